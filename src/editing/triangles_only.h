#pragma once

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"

// Internal to this folder.
namespace limn {

/// kFailed, naming the first face that is no triangle.
[[nodiscard]] Result<void> check_triangles(const ControlMesh& mesh);

}  // namespace limn
