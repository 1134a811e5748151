#pragma once

#include <array>
#include <cstdint>

#include "subdivision/label_counts.h"
#include "subdivision/limit_point.h"
#include "subdivision/ring_tables.h"
#include "subdivision/tensor_grid.h"

// The piece of surface that one quad becomes. Internal to this folder.
//
// Corners and sides are numbered counter-clockwise; side i runs from corner i to corner i + 1. In a
// grid, corner 0 is at the lower left, side 0 along the first row, side 1 along the last column.
namespace limn {

/// Small sets of corners or sides, a bit each.
[[nodiscard]] constexpr bool has(std::uint8_t bits, std::size_t i) noexcept {
  return (bits >> i & 1) != 0;
}
[[nodiscard]] constexpr std::uint8_t bit(std::size_t i, bool is_set = true) noexcept {
  return static_cast<std::uint8_t>(is_set ? 1u << i : 0u);
}

/// What bounds a patch on one side.
enum class SideKind : std::uint8_t {
  kOpen,    ///< The surface goes on smoothly.
  kCurve,   ///< A cubic B-spline of its own: a boundary.
  kPinned,  ///< Straight: midpoints, and vertices that stay.
  kSharp,   ///< A crease of some sharpness.
};

struct PatchSide {
  SideKind kind = SideKind::kOpen;
  SideSharpness sharpness;  ///< kSharp only.
};

/// The ring around a patch's corner, where that is irregular.
struct PatchCorner {
  RingView ring;
  std::uint32_t before = kNone;  ///< Which edges of the ring lie beyond the corner's two sides:
  std::uint32_t after = kNone;   ///< beyond side i, and beyond side i - 1. kNone: outside.
  bool is_on_boundary = false;   ///< Whether the surface ends there, in whichever face.
};

/// A quad of level 0, or of level 1 inside a face that is none, with the vertices around it.
struct Patch {
  std::array<Point, 16> grid;  ///< One face with its ring. Where the surface ends, or an irregular
                               ///< corner leaves no place, any finite points.
  std::array<PatchSide, 4> sides;
  std::array<PatchCorner, 4> corners;
  bool is_bilinear = false;
  bool is_plain = true;  ///< No side and no corner has been set since the last `make_plain`.

  /// All sides open and all corners regular, as in most faces: the grid is left alone.
  void make_plain() noexcept {
    if (!is_plain) {
      sides = {};
      corners = {};
      is_plain = true;
    }
  }
};

/// Which numbers the vertices inside an edge have: first, first + step, ..., step being 1 or -1
/// (modulo 2^32). One word, since a pair that is copied whole right after its halves were written
/// keeps the processor waiting.
class EdgeRun {
 public:
  EdgeRun() = default;
  EdgeRun(std::uint32_t first, std::uint32_t step) noexcept
      : bits_(std::uint64_t{step} << 32 | first) {}

  [[nodiscard]] std::uint32_t first() const noexcept { return static_cast<std::uint32_t>(bits_); }
  [[nodiscard]] std::uint32_t step() const noexcept {
    return static_cast<std::uint32_t>(bits_ >> 32);
  }
  [[nodiscard]] std::uint32_t at(std::uint32_t i) const noexcept { return first() + step() * i; }
  /// Without its first i.
  [[nodiscard]] EdgeRun from(std::uint32_t i) const noexcept { return {at(i), step()}; }
  /// The same `count` from the other end.
  [[nodiscard]] EdgeRun reversed(std::uint32_t count) const noexcept {
    return {at(count - 1), 0u - step()};
  }

 private:
  std::uint64_t bits_ = std::uint64_t{1} << 32;
};

/// A face of the level-k mesh inside a patch and the numbers of what becomes of it.
///
/// Every vertex has one owner that writes it: a node for the corners and sides marked, and for all
/// inside. A node is told of a corner only while that still moves.
struct Node {
  int level = 0;  ///< k
  QuadLabels labels{};
  std::uint32_t column = 0;  ///< Its place among the patch's faces of its level.
  std::uint32_t row = 0;
  std::array<std::uint32_t, 4> corners{};
  std::array<EdgeRun, 4> sides{};
  std::uint32_t inside = 0;        ///< First vertex inside.
  std::uint32_t quad = 0;          ///< First quad.
  std::uint8_t owned_corners = 0;  ///< Bits.
  std::uint8_t owned_sides = 0;    ///< Bits.
  std::uint8_t lifted_sides = 0;   ///< Bits: the midpoint of the side has label 0 and no positive
                                  ///< neighbour on it, and moves once more because of a face point.
  std::uint8_t patch_corners = 15;  ///< Bits: which corners are the patch's,
  std::uint8_t patch_sides = 15;    ///< and which sides lie on the patch's.
};

/// Where points and faces go. Arrays without use are null.
struct RefinedArrays {
  float* points = nullptr;
  std::size_t width = 3;  ///< Floats per point: 3, or 2 for texture coordinates.
  std::uint8_t* vertex_levels = nullptr;
  std::array<std::uint32_t, 4>* quads = nullptr;
  std::uint32_t* face_control_faces = nullptr;
  std::uint8_t* face_levels = nullptr;
  bool has_limit_points = false;  ///< `points` are those of the limit (width 3).
  float* normals = nullptr;       ///< Of the limit, 3 floats a vertex.

  [[nodiscard]] bool takes_limits() const noexcept {
    return has_limit_points || normals != nullptr;
  }
  void put_limit(std::uint32_t vertex, const LimitPoint& limit) const noexcept {
    const auto put_vec3 = [vertex](const glm::dvec3& from, float* to) {
      to += std::size_t{3} * vertex;
      to[0] = static_cast<float>(from.x);
      to[1] = static_cast<float>(from.y);
      to[2] = static_cast<float>(from.z);
    };
    if (has_limit_points) {
      put_vec3(limit.position, points);
    }
    if (normals != nullptr) {
      put_vec3(limit.normal, normals);
    }
  }
  void put(std::uint32_t vertex, const Point& point, int level) const noexcept {
    float* at = points + width * vertex;
    at[0] = static_cast<float>(point[0]);
    at[1] = static_cast<float>(point[1]);
    if (width == 3) {
      at[2] = static_cast<float>(point[2]);
    }
    if (vertex_levels != nullptr) {
      vertex_levels[vertex] = static_cast<std::uint8_t>(level);
    }
  }
};

/// Writes all faces and owned vertices that become of `node`, the root of `patch` in control face
/// `control_face`.
void refine_patch(const Patch& patch, const Node& node, std::uint32_t control_face,
                  const RefinedArrays& arrays);

}  // namespace limn
