#pragma once

#include <cstddef>

#include "limn/document/document.h"
#include "limn/mesh/control_mesh.h"

namespace limn {

/// Memory that a control mesh's attributes hold: what it costs beside another mesh of the same
/// surface.
[[nodiscard]] std::size_t attribute_bytes(const ControlMesh& mesh);

/// Memory that a control mesh holds: its half-edges with their properties, the flat arrays and the
/// attributes.
[[nodiscard]] std::size_t mesh_bytes(const ControlMesh& mesh);

/// What keeping `mesh` costs whoever does, beside what the document keeps anyway.
[[nodiscard]] std::size_t bytes_beside(const Document& document, const ControlMesh& mesh);

}  // namespace limn
