#pragma once

#include "limn/mesh/refined_mesh.h"

// What must hold of every refinement; checked in debug builds and in tests. Internal.
namespace limn {

/// The greatest difference of `face_levels` across an edge; 0 for no faces.
[[nodiscard]] int greatest_level_difference(const RefinedMesh& mesh);

}  // namespace limn
