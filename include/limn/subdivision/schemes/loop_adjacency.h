#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "limn/mesh/control_mesh.h"

namespace limn {

/// The adjacency that Loop's scheme needs of a triangle mesh, as teachers set it in exercises:
/// which vertices each new position is a combination of.
struct LoopAdjacency {
  /// For each old vertex a row: the number of its neighbours, then these, counter-clockwise; at a
  /// boundary from one boundary neighbour to the other.
  std::vector<std::uint32_t> row_offsets;  ///< V + 1.
  std::vector<std::uint32_t> rows;
  /// For each midpoint, one per edge of the mesh in its order: the two ends of the edge, then the
  /// vertices opposite in the two triangles; kNone where there is no second one.
  std::vector<std::array<std::uint32_t, 4>> midpoints;

  [[nodiscard]] std::span<const std::uint32_t> row(std::size_t v) const noexcept {
    return std::span(rows).subspan(row_offsets[v], row_offsets[v + 1] - row_offsets[v]);
  }
};

/// `mesh` is all triangles.
[[nodiscard]] LoopAdjacency loop_adjacency(const ControlMesh& mesh);

}  // namespace limn
