#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "limn/mesh/flat_topology.h"
#include "subdivision/cage.h"

// Faces of several levels of the uniform meshes, as many of each as are wanted. Internal to this
// folder.
namespace limn {

/// Which of a face's children there are: all, none, or 0..3, the one at that corner alone.
enum : std::uint8_t { kAllChildren = 4, kNoChildren = 5 };

/// What is across a side: 4 node + side of the node there, or one of these.
inline constexpr std::uint32_t kNobody = kNone;        ///< A face that the forest has not.
inline constexpr std::uint32_t kBoundary = kNone - 1;  ///< No face.

/// The corner or side so many further around a quad.
[[nodiscard]] constexpr std::uint32_t turned(std::uint32_t corner, std::uint32_t by) noexcept {
  return (corner + by) % 4;
}

/// A face of some level; a quad. Its child i lies at its corner i and has it for its own corner i.
struct ForestNode {
  std::array<std::uint32_t, 4> vertices{};
  std::array<std::uint32_t, 4> neighbours{};  ///< From level 1 on.
  std::uint32_t first_child = kNone;
  std::uint8_t children = kNoChildren;

  [[nodiscard]] std::uint32_t child(std::uint32_t i) const noexcept {
    if (children == kAllChildren) {
      return first_child + i;
    }
    return children == i ? first_child : kNone;
  }
};

/// A control face and what becomes of it. One that is no quad has a child at each corner, which has
/// that for its corner 0.
struct ForestRoot {
  std::uint32_t face = 0;
  std::uint32_t node = kNone;  ///< Of level 0, where the face is a quad.
  std::uint32_t first_child = kNone;
  std::uint8_t children = kNoChildren;
  std::uint32_t sides = 0;

  [[nodiscard]] bool is_quad() const noexcept { return sides == 4; }
  [[nodiscard]] std::uint32_t child(std::uint32_t i) const noexcept {
    if (children == kAllChildren) {
      return first_child + i;
    }
    return children == i ? first_child : kNone;
  }
  /// Which corner of its child the control face's corner i is.
  [[nodiscard]] std::uint32_t turn(std::uint32_t i) const noexcept { return is_quad() ? i : 0; }
};

/// Roots, and level by level what they are divided into. A vertex keeps its number from level to
/// level; vertices of each level are numbered behind those of the levels before.
class QuadForest {
 public:
  /// Some faces of the cage, ascending: level 0. The cage must outlive the next call.
  void plant(const Cage& cage, std::span<const std::uint32_t> faces);
  /// Level 1, from the children wanted of each root: all those of a face that is no quad, or none.
  void divide_roots(const Cage& cage, const std::function<std::uint8_t(std::uint32_t)>& children);
  /// The next level, from the children wanted of each node of the last.
  void divide(const std::function<std::uint8_t(std::uint32_t)>& children);

  [[nodiscard]] std::span<const ForestRoot> roots() const noexcept { return roots_; }
  [[nodiscard]] const ForestRoot& root(std::uint32_t i) const noexcept { return roots_[i]; }
  /// The root of a control face; kNone where it has none.
  [[nodiscard]] std::uint32_t root_of(std::uint32_t face) const noexcept {
    return face_roots_.empty() ? kNone : face_roots_[face];
  }
  [[nodiscard]] std::span<const ForestNode> nodes() const noexcept { return nodes_; }
  [[nodiscard]] const ForestNode& node(std::uint32_t i) const noexcept { return nodes_[i]; }
  [[nodiscard]] int level_count() const noexcept {
    return static_cast<int>(first_nodes_.size()) - 1;
  }
  /// Nodes of a level: from the first to that of the next level. Level 0 has those of quads.
  [[nodiscard]] std::uint32_t first_node(int level) const noexcept {
    return first_nodes_[static_cast<std::size_t>(level)];
  }
  [[nodiscard]] std::uint32_t vertex_count() const noexcept { return vertex_count_; }
  /// The vertices that are the cage's: number v is control_vertices()[v].
  [[nodiscard]] std::span<const std::uint32_t> control_vertices() const noexcept {
    return control_vertices_;
  }
  /// Their numbers; kNone where the vertex is at no root.
  [[nodiscard]] std::uint32_t number_of(std::uint32_t control_vertex) const noexcept {
    return vertex_numbers_[control_vertex];
  }

 private:
  void link_first_level(const Cage& cage, const ForestRoot& root);
  [[nodiscard]] std::uint32_t middle(std::uint32_t node, std::uint32_t side);
  [[nodiscard]] std::uint32_t across(std::uint32_t neighbour, std::uint32_t from_end) const;

  std::vector<ForestRoot> roots_;
  std::vector<ForestNode> nodes_;
  std::vector<std::uint32_t> first_nodes_{0};
  std::vector<std::uint32_t> face_roots_;
  std::vector<std::uint32_t> vertex_numbers_;
  std::vector<std::uint32_t> control_vertices_;
  std::uint32_t vertex_count_ = 0;
};

}  // namespace limn
