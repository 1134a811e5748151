#pragma once

#include <cstdint>

#include "limn/mesh/creases.h"
#include "subdivision/schemes/level_mesh.h"

// Internal to this folder: corners of the boundary that stay where they are, for schemes after
// whose steps they would not be known any more. LevelMesh::vertex_sharpness marks them.
namespace limn {

/// Marks the boundary vertices of one face where `corners` is kSharp. Takes whatever was sharp
/// besides away.
void mark_corners(CornerRule corners, LevelMesh& mesh);

[[nodiscard]] inline bool is_marked(const LevelMesh& mesh, std::uint32_t v) noexcept {
  return !mesh.vertex_sharpness.empty() && mesh.vertex_sharpness[v] > 0.0f;
}

}  // namespace limn
