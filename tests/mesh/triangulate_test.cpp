#include "limn/mesh/triangulate.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "limn/mesh/build.h"
#include "limn/mesh/statistics.h"
#include "mesh/mesh_checks.h"
#include "support/attribute_shapes.h"
#include "support/shapes.h"

namespace limn {
namespace {

using test::MeshPointer;

glm::dvec3 area_vector(const ControlMesh& mesh, std::size_t f) {
  const auto face = mesh.face(f);
  glm::dvec3 sum(0.0);
  for (std::size_t i = 2; i < face.size(); ++i) {
    sum += glm::cross(mesh.positions()[face[i - 1]] - mesh.positions()[face[0]],
                      mesh.positions()[face[i]] - mesh.positions()[face[0]]);
  }
  return 0.5 * sum;
}

void expect_triangles(const ControlMesh& mesh, const ControlMesh& original) {
  const MeshStatistics after = mesh_statistics(mesh);
  const MeshStatistics before = mesh_statistics(original);
  ASSERT_EQ(after.faces_by_sides.size(), 1u);
  EXPECT_EQ(after.faces_by_sides.begin()->first, 3u);
  EXPECT_EQ(after.euler_characteristic, before.euler_characteristic);
  EXPECT_EQ(after.boundary_edges, before.boundary_edges);
  EXPECT_EQ(after.components, before.components);
}

TEST(Triangulated, CutsQuadsAtTheirShorterDiagonal) {
  const MeshPointer kite =
      test::control_mesh({{0, 0, 0}, {4, -1, 0}, {8, 0, 0}, {4, 1, 0}}, {{0, 1, 2, 3}});
  const MeshPointer cut = triangulated(*kite);
  ASSERT_EQ(cut->face_count(), 2u);
  for (std::size_t f = 0; f < 2; ++f) {
    EXPECT_GT(area_vector(*cut, f).z, 0.0);
  }
  bool has_short_diagonal = false;
  for (const auto& [a, b] : cut->topology().edge_vertices) {
    has_short_diagonal = has_short_diagonal || (a == 1 && b == 3) || (a == 3 && b == 1);
  }
  EXPECT_TRUE(has_short_diagonal);
}

// The shorter diagonal of a dart lies outside of it.
TEST(Triangulated, StaysInsideFacesThatAreNotConvex) {
  const MeshPointer dart =
      test::control_mesh({{0, 0, 0}, {2, -5, 0}, {4, 0, 0}, {2, -1, 0}}, {{0, 1, 2, 3}});
  const MeshPointer cut = triangulated(*dart);
  ASSERT_EQ(cut->face_count(), 2u);
  for (std::size_t f = 0; f < 2; ++f) {
    EXPECT_GT(area_vector(*cut, f).z, 0.0);
  }
}

TEST(Triangulated, CutsStarsOfAllSizesIntoWhatTheyCover) {
  for (std::uint32_t points = 3; points <= 40; ++points) {
    std::vector<glm::dvec3> positions;
    std::vector<std::uint32_t> face;
    for (std::uint32_t i = 0; i < 2 * points; ++i) {
      const double angle = std::numbers::pi * i / points;
      const double radius = i % 2 == 0 ? 2.0 : 0.7;
      positions.emplace_back(radius * std::cos(angle), 0.3, -radius * std::sin(angle));
      face.push_back(i);
    }
    const MeshPointer star = test::control_mesh(positions, {face});
    const MeshPointer cut = triangulated(*star);
    expect_triangles(*cut, *star);
    double area = 0.0;
    for (std::size_t f = 0; f < cut->face_count(); ++f) {
      EXPECT_GT(area_vector(*cut, f).y, 0.0) << points;
      area += glm::length(area_vector(*cut, f));
    }
    EXPECT_NEAR(area, glm::length(area_vector(*star, 0)), 1e-9) << points;
    // Beyond 32 sides a vertex in the middle.
    EXPECT_EQ(cut->vertex_count(), star->vertex_count() + (2 * points > 32 ? 1 : 0)) << points;
  }
}

// Cut alike, the two would share the diagonal, and it would have four faces.
TEST(Triangulated, NeverDoublesADiagonal) {
  const MeshPointer pillow = test::control_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                                                {{0, 1, 2, 3}, {3, 2, 1, 0}});
  expect_triangles(*triangulated(*pillow), *pillow);

  // The diagonal of the one quad is an edge of the other faces.
  const MeshPointer wedge =
      test::control_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, -3}},
                         {{0, 1, 2, 3}, {1, 0, 4}, {3, 2, 4}, {2, 1, 4}, {0, 3, 4}});
  expect_triangles(*triangulated(*wedge), *wedge);
}

TEST(Triangulated, KeepsTrianglesAndTheOrderOfFaces) {
  test::Random random(61);
  const MeshPointer mesh =
      test::control_mesh(test::with_mixed_faces(test::torus_soup(8, 6), random));
  const MeshPointer cut = triangulated(*mesh);
  expect_triangles(*cut, *mesh);
  std::size_t at = 0;
  for (std::size_t f = 0; f < mesh->face_count(); ++f) {
    const std::size_t count = mesh->face(f).size() - 2;
    if (count == 1) {
      EXPECT_TRUE(std::ranges::equal(cut->face(at), mesh->face(f)));
    }
    at += count;
  }
  EXPECT_EQ(at, cut->face_count());
}

TEST(Triangulated, SurvivesFacesWithoutArea) {
  const MeshPointer line =
      test::control_mesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 1, 2, 3}});
  expect_triangles(*triangulated(*line), *line);
}

TEST(Triangulated, KeepsSharpEdgesAndTexture) {
  for (const test::NamedShape& shape : test::creased_shapes()) {
    const MeshPointer cut = triangulated(*shape.mesh);
    const MeshStatistics after = mesh_statistics(*cut);
    const MeshStatistics before = mesh_statistics(*shape.mesh);
    EXPECT_EQ(after.crease_edges, before.crease_edges) << shape.name;
    EXPECT_EQ(after.sharp_vertices, before.sharp_vertices) << shape.name;
    EXPECT_EQ(cut->creases().method, shape.mesh->creases().method);
  }
  for (const test::NamedShape& shape : test::textured_shapes()) {
    const MeshPointer cut = triangulated(*shape.mesh);
    EXPECT_EQ(mesh_statistics(*cut).uv_seams, mesh_statistics(*shape.mesh).uv_seams) << shape.name;
    ASSERT_EQ(cut->texture().corner_values.size(), 3 * cut->face_count());
  }
}

TEST(Triangulated, NamesAndLooseVerticesGoAlong) {
  PolygonSoup soup = test::soup_of(8, {{0, 1, 2, 3}, {3, 2, 4, 5, 6}});
  soup.names.materials = {{"red", "blue"}, {1, 0}};
  const auto built = build_control_mesh(soup);
  ASSERT_TRUE(built.has_value());
  const auto mesh = triangulated(*built->mesh);
  ASSERT_EQ(mesh->face_count(), 5U);
  EXPECT_THAT(mesh->attributes().names.materials.of_faces, testing::ElementsAre(1, 1, 0, 0, 0));
  EXPECT_EQ(mesh->attributes().loose_vertices.size(), 1U);
}

}  // namespace
}  // namespace limn
