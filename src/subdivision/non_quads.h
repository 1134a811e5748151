#pragma once

#include <cstdint>
#include <vector>

#include "limn/mesh/control_mesh.h"
#include "limn/subdivision/labels.h"

// The rule kWherePainted, one vertex at a time. Internal to this folder.
namespace limn {

/// Given that the vertices in `risen` have become positive, raises to 1 the zeros of every non-quad
/// face they touch, and so on until nothing changes. The vertices it raised are appended to
/// `risen`, in the order in which they rose.
void raise_non_quads(const ControlMesh& mesh, VertexLabels& labels,
                     std::vector<std::uint32_t>& risen);

}  // namespace limn
