#pragma once

#include "limn/mesh/control_mesh.h"
#include "support/surface_match.h"

// What other libraries make of a closed mesh, each in a file of its own: their headers are large.
namespace limn::test {

[[nodiscard]] PlainMesh openmesh_butterfly(const ControlMesh& mesh, int levels);
[[nodiscard]] PlainMesh openmesh_sqrt3(const ControlMesh& mesh, int levels);
[[nodiscard]] PlainMesh openmesh_loop(const ControlMesh& mesh, int levels);
[[nodiscard]] PlainMesh cgal_doo_sabin(const ControlMesh& mesh, int levels);
[[nodiscard]] PlainMesh cgal_sqrt3(const ControlMesh& mesh, int levels);

}  // namespace limn::test
