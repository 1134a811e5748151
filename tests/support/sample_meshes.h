#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include "limn/mesh/control_mesh.h"

namespace limn::test {

/// A control mesh from positions and faces; aborts where they are no surface.
[[nodiscard]] std::shared_ptr<const ControlMesh> control_mesh(
    const std::vector<glm::dvec3>& positions, const std::vector<std::vector<std::uint32_t>>& faces);

/// The cube with corners at +-1. Faces: 0 -x, 1 +x, 2 -y, 3 +y, 4 -z, 5 +z.
[[nodiscard]] std::shared_ptr<const ControlMesh> cube_mesh();

/// A pentagonal prism with the sides cut once: pentagons, quads and triangles in mixed order.
[[nodiscard]] std::shared_ptr<const ControlMesh> mixed_mesh();

/// n by n unit quads in the plane z = 0, counter-clockwise seen from +z, row by row from the
/// origin.
[[nodiscard]] std::shared_ptr<const ControlMesh> grid_mesh(std::uint32_t n);

}  // namespace limn::test
