#pragma once

#include <cstddef>

#include "limn/mesh/control_mesh.h"

namespace limn {

/// Memory that a control mesh holds: its half-edges with their properties, and the flat arrays.
[[nodiscard]] std::size_t mesh_bytes(const ControlMesh& mesh);

}  // namespace limn
