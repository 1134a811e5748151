#pragma once

#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "limn/mesh/refined_mesh.h"
#include "limn/subdivision/schemes/scheme.h"
#include "support/attribute_shapes.h"

// Meshes to try every scheme on.
namespace limn::test {

/// Closed and open shapes of all kinds, bundled meshes among them, made fit for what the scheme
/// takes.
[[nodiscard]] std::vector<NamedShape> shapes_for(Scheme scheme);
/// Those of them that are closed.
[[nodiscard]] std::vector<NamedShape> closed_shapes_for(Scheme scheme);
/// As they are.
[[nodiscard]] std::vector<NamedShape> scheme_shapes();

/// The same mesh with no two vertices in one place: every coordinate is moved by up to `amount`
/// diagonals.
[[nodiscard]] MeshPointer set_apart(const ControlMesh& mesh, double amount, Random& random);

/// `mesh` as it is where the scheme takes it, else made fit.
[[nodiscard]] MeshPointer fitted(const MeshPointer& mesh, Scheme scheme);

/// `subdivide` where nothing can go wrong.
[[nodiscard]] RefinedMesh subdivided(const ControlMesh& mesh, const SchemeSettings& settings,
                                     int levels);
/// Of the vertices on the boundary.
[[nodiscard]] std::vector<glm::dvec3> boundary_positions(const RefinedMesh& mesh);

}  // namespace limn::test
