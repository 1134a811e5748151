#pragma once

#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include <glm/vec3.hpp>

#include "limn/mesh/control_mesh.h"
#include "limn/mesh/polygon_soup.h"

// Meshes made in memory, to test on.
namespace limn::test {

using MeshPointer = std::shared_ptr<const ControlMesh>;
using Random = std::mt19937;

/// The control mesh of a soup that is known to be one; fails the program otherwise.
[[nodiscard]] MeshPointer control_mesh(const PolygonSoup& soup);
[[nodiscard]] MeshPointer control_mesh(const std::vector<glm::dvec3>& positions,
                                       const std::vector<std::vector<std::uint32_t>>& faces);

/// The cube with corners at +-1. Faces: 0 -x, 1 +x, 2 -y, 3 +y, 4 -z, 5 +z.
[[nodiscard]] PolygonSoup cube_soup();
/// Open: columns x rows quads over unit squares of the xy-plane, gently waved in z;
/// counter-clockwise seen from +z, row by row from the origin.
[[nodiscard]] PolygonSoup grid_soup(std::uint32_t columns, std::uint32_t rows);
/// Closed, all vertices of valence 4.
[[nodiscard]] PolygonSoup torus_soup(std::uint32_t around, std::uint32_t across);
/// Closed, 2 n kites: two poles of valence n.
[[nodiscard]] PolygonSoup trapezohedron_soup(std::uint32_t n);
/// Open, one polygon with n sides within a ring of n quads.
[[nodiscard]] PolygonSoup polygon_in_ring_soup(std::uint32_t n);
/// Closed: an n-gon at either end of a ring of n quads.
[[nodiscard]] PolygonSoup prism_soup(std::uint32_t n);

/// Splits some quads into triangles and joins some neighbours to pentagons and hexagons.
[[nodiscard]] PolygonSoup with_mixed_faces(const PolygonSoup& soup, Random& random);
/// The quads of one linear subdivision of the soup's triangulation after many random edge flips:
/// vertices of all valences from 3 up.
[[nodiscard]] PolygonSoup random_quads(const PolygonSoup& soup, Random& random);
/// Without `count` random faces.
[[nodiscard]] PolygonSoup with_holes(const PolygonSoup& soup, std::uint32_t count, Random& random);
/// Every coordinate moved by up to `amount`.
[[nodiscard]] PolygonSoup jittered(PolygonSoup soup, double amount, Random& random);

[[nodiscard]] MeshPointer cube();
/// The grid of n rows of n quads.
[[nodiscard]] MeshPointer grid(std::uint32_t n);
/// A pentagonal prism with the sides cut once: pentagons, quads and triangles in mixed order.
[[nodiscard]] MeshPointer mixed_prism();

/// Depths that paint each face with the given probability to a depth of 1 to `deepest`.
[[nodiscard]] std::vector<std::uint8_t> random_depths(const ControlMesh& mesh, double probability,
                                                      int deepest, Random& random);

}  // namespace limn::test
