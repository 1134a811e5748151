#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "limn/mesh/control_mesh.h"
#include "limn/mesh/polygon_soup.h"
#include "support/shapes.h"

// Meshes with creases, corners and texture coordinates, to test on.
namespace limn::test {

struct NamedShape {
  std::string name;
  MeshPointer mesh;
};

/// The same surface with these creases and corners; fails the program where a tag fits nothing.
[[nodiscard]] MeshPointer with_tags(PolygonSoup soup, std::vector<CreaseTag> creases,
                                    std::vector<CornerTag> corners = {},
                                    CreasingMethod method = CreasingMethod::kUniform);

/// Every kind of vertex the crease rules tell apart, with whole, fractional and infinite sharpness:
/// crease loops, a dart, creases that cross, meet, end on a boundary or run along it, corners
/// inside and on boundaries, beside faces that are no quads and at vertices of valence 3, 5 and 8;
/// each both with uniform and with Chaikin creasing.
[[nodiscard]] std::vector<NamedShape> creased_shapes();

/// Gives each edge and each vertex a random sharpness of 0.1 to 5, or an infinite one, with the
/// given probability.
[[nodiscard]] MeshPointer with_random_creases(const ControlMesh& mesh, double edge_probability,
                                              double vertex_probability, Random& random);

/// The same surface with these texture points; `corners` has one index per corner, face by face.
[[nodiscard]] MeshPointer with_uvs(PolygonSoup soup, std::vector<glm::dvec2> points,
                                   std::vector<std::uint32_t> corners);

/// One chart over an open grid, one around a cube unfolded to a cross, a torus cut open along two
/// loops, a chart per face, two charts of which one is flipped over, a seam that ends inside the
/// surface, charts that touch in a point only, faces that are no quads, a seam with the same points
/// on both sides (under two numbers), and texture together with creases.
[[nodiscard]] std::vector<NamedShape> textured_shapes();

/// Cuts the surface into charts at random: each edge whose faces `charts` numbers differently is a
/// seam. Points are spread at random over the unit square.
[[nodiscard]] MeshPointer with_random_charts(const ControlMesh& mesh, std::uint32_t charts,
                                             Random& random);

}  // namespace limn::test
