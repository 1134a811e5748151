#pragma once

#include <cstdint>

#include "subdivision/schemes/level_mesh.h"

// Internal to this folder.
namespace limn {

/// The half-edges on the boundary in growing order, for what is made there.
struct BoundaryEdges {
  LargeArray<std::uint32_t> half_edges;
  LargeArray<std::uint32_t> ranks;  ///< By edge: place in `half_edges`, kNone inside. Empty where
                                    ///< there is no boundary.
};
[[nodiscard]] BoundaryEdges boundary_edges(const LevelMesh& mesh);

/// The half-edge that comes to the start of h along the boundary.
[[nodiscard]] std::uint32_t boundary_before(const LevelMesh& mesh, std::uint32_t h);

}  // namespace limn
