#pragma once

#include <array>
#include <cstdint>

#include "subdivision/flat_array.h"
#include "subdivision/level.h"
#include "subdivision/sweep.h"

// One step from level k to level k + 1: who becomes what, under which number. Internal.
namespace limn {

/// What happens to a face in this step, in one byte: 0 it stays, 1 it splits into its sides' number
/// of quads, 2 + i it is a Y-element whose positive label is at side i.
using FaceCode = std::uint8_t;
inline constexpr FaceCode kFaceStays = 0;
inline constexpr FaceCode kFaceSplits = 1;
inline constexpr FaceCode kFaceIsY = 2;

/// Numbers of everything that level k + 1 is made of.
///
/// Its vertices are numbered: those of level k that move, face points, emitted edge points, virtual
/// edge points. Its faces are the children of split faces, corner by corner, and three children of
/// each Y-element: the one at the positive vertex v1, then the virtual ones at v2 and at v4.
struct Step {
  FlatArray<FaceCode> codes;                ///< Per face.
  FlatArray<std::uint32_t> first_children;  ///< Per face: its first child.
  FlatArray<std::uint32_t> first_quads;     ///< Per face: its first finished quad in the output.
  FlatArray<std::uint32_t> face_points;     ///< Per face; kNone where it stays.
  FlatArray<std::uint32_t> edge_points;     ///< Per corner: the point on its edge, or kNone.
  FlatArray<std::uint32_t> vertex_points;   ///< Per vertex; kNone where it does not move.
  std::uint32_t children = 0;
  std::uint32_t quads = 0;         ///< Finished in this step.
  std::uint32_t moved = 0;         ///< Vertices of level k that move.
  std::uint32_t emitted = 0;       ///< Moved, face and emitted edge points.
  std::uint32_t points = 0;        ///< All vertices of level k + 1.
  std::uint32_t first_output = 0;  ///< Vertex of the RefinedMesh that the first new point becomes.
  bool is_last = false;            ///< No label of level k + 1 is positive.

  /// Vertex of the RefinedMesh for a face or edge point.
  [[nodiscard]] std::uint32_t output_of(std::uint32_t point) const noexcept {
    return point < emitted ? first_output + (point - moved) : kNone;
  }
};

/// The child of a face at its side `side`; kNone where the face stays, and at the far corner of a
/// Y-element.
[[nodiscard]] inline std::uint32_t child_at(FaceCode code, std::uint32_t first_child,
                                            std::uint32_t side) noexcept {
  if (code == kFaceSplits) {
    return first_child + side;
  }
  if (code == kFaceStays) {
    return kNone;
  }
  constexpr std::array<std::uint32_t, 4> kOrder{0, 1, kNone, 2};
  const std::uint32_t order = kOrder[(side - (code - kFaceIsY)) & 3u];
  return order == kNone ? kNone : first_child + order;
}

template <class Sides>
[[nodiscard]] std::uint32_t child_at(const Sides& sides, const Step& step,
                                     std::uint32_t corner) noexcept {
  const std::uint32_t f = sides.face(corner);
  return child_at(step.codes[f], step.first_children[f], sides.side(corner));
}

/// Each edge is told once, by one of its corners.
[[nodiscard]] inline bool is_edge_owner(const Level& level, std::uint32_t corner) noexcept {
  return corner < level.twins[corner];  // Both kBoundary and kMissing are above any corner.
}

/// Looks at the labels of a level and numbers what becomes of it. `first_quad` and `first_vertex`
/// are the next free places in the output.
template <class Sides>
[[nodiscard]] Step plan_step(Sweep& sweep, const Sides& sides, const Level& level,
                             std::uint32_t first_quad, std::uint32_t first_vertex, bool is_last);

/// The level that a step leads to, without its positions.
template <class Sides>
[[nodiscard]] Level child_level(Sweep& sweep, const Sides& sides, const Level& level,
                                const Step& step);

}  // namespace limn
