#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "limn/mesh/control_mesh.h"

// Internal to this folder.
namespace limn {

/// A copy of a mesh in which edges can be split and flipped one after the other, each in constant
/// time, before it becomes a control mesh again.
///
/// Corners are numbered as in FlatTopology at first, and new ones come last. A corner names the
/// edge from its vertex to the next corner's, and keeps on naming it while other edges are split:
/// splitting or flipping changes the ends of no edge but the one it is asked for.
class Surgery {
  class Neighbours;

 public:
  explicit Surgery(const ControlMesh& mesh);

  [[nodiscard]] std::uint32_t from(std::uint32_t corner) const { return corners_[corner].vertex; }
  [[nodiscard]] std::uint32_t to(std::uint32_t corner) const { return from(next(corner)); }
  /// The third vertex of a corner's triangle.
  [[nodiscard]] std::uint32_t opposite(std::uint32_t corner) const { return to(next(corner)); }
  [[nodiscard]] std::uint32_t next(std::uint32_t corner) const { return corners_[corner].next; }
  /// Across the corner's edge; kNone on a boundary.
  [[nodiscard]] std::uint32_t twin(std::uint32_t corner) const { return corners_[corner].twin; }

  /// Why an edge cannot be split or flipped, to follow "it cannot be flipped: "; nothing where it
  /// can.
  [[nodiscard]] std::optional<std::string_view> why_not_split(std::uint32_t corner) const;
  [[nodiscard]] std::optional<std::string_view> why_not_flip(std::uint32_t corner) const;

  /// What a split adds: a vertex, and the corners that lead from it to the vertices opposite, the
  /// second kNone where there is but one face.
  struct Split {
    std::uint32_t vertex = 0;
    std::uint32_t rest = 0;  ///< The corner of the edge's half that was appended.
    std::array<std::uint32_t, 2> spokes{};
  };
  /// Nothing speaks against it. The triangles with the corner's vertex keep their numbers, those
  /// with the edge's other end come last, the corner's own first.
  Split split(std::uint32_t corner);
  /// Nothing speaks against it. The triangle at the corner becomes the one that holds the corner's
  /// vertex.
  void flip(std::uint32_t corner);

  /// In place of the positions so far: one for each vertex.
  void move_vertices(std::vector<glm::dvec3> positions);
  /// In place of the sharpness so far, of vertices. All are 0 or more; or empty: none is sharp.
  void set_vertex_sharpness(std::vector<float> sharpness);
  /// Of a corner's edge.
  void set_sharpness(std::uint32_t corner, float sharpness);

  [[nodiscard]] std::shared_ptr<const ControlMesh> finish() const;

 private:
  struct Corner {
    std::uint32_t vertex;
    std::uint32_t next;
    std::uint32_t twin;
    std::uint32_t face;
    std::uint32_t uv;  ///< kNone where the mesh has no texture coordinates.
    float sharpness;   ///< The same at its twin.
  };

  [[nodiscard]] bool is_triangle(std::uint32_t corner) const;
  [[nodiscard]] bool is_seam(std::uint32_t corner) const;
  [[nodiscard]] std::uint32_t previous(std::uint32_t corner) const;
  /// Whether an edge joins the vertices that two corners leave.
  [[nodiscard]] bool are_joined(std::uint32_t one, std::uint32_t other) const;
  [[nodiscard]] std::uint32_t add_uv_between(std::uint32_t one, std::uint32_t other);
  /// Cuts the triangle of a corner from a vertex on the corner's edge to the one opposite. The half
  /// at the corner's start, or else at its end, keeps the corner and the face's number.
  struct Cut {
    std::uint32_t middle = 0;
    std::uint32_t uv = 0;  ///< Of the middle, in this triangle.
    bool keeps_start = true;
  };
  struct Halves {
    std::uint32_t rest;   ///< The corner on the edge's other half.
    std::uint32_t spoke;  ///< The corner that leaves the middle for the vertex opposite.
  };
  Halves cut(std::uint32_t corner, const Cut& cut);
  void make_triangle(std::uint32_t face, std::array<std::uint32_t, 3> corners);
  void pair(std::uint32_t one, std::uint32_t other);

  std::vector<Corner> corners_;
  std::vector<std::uint32_t> first_corners_;  ///< Of every face.
  std::vector<std::uint32_t> face_sources_;   ///< For every face the one it was or was cut from.
  std::vector<glm::dvec3> positions_;
  std::vector<float> vertex_sharpness_;
  std::vector<glm::dvec2> uvs_;
  CreasingMethod creasing_;
  std::optional<CornerRule> corner_rule_;
  FaceNaming names_;  ///< Of the faces that there were.
  std::vector<glm::dvec3> loose_vertices_;
};

}  // namespace limn
