#include "limn/mesh/statistics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/mesh_checks.h"
#include "support/attribute_shapes.h"

namespace limn {
namespace {

using test::soup_of;
using testing::ElementsAre;
using testing::Pair;

TEST(MeshStatistics, ClosedCube) {
  const auto built = build_control_mesh(soup_of(
      8, {{0, 1, 3, 2}, {2, 3, 5, 4}, {4, 5, 7, 6}, {6, 7, 1, 0}, {1, 7, 5, 3}, {6, 0, 2, 4}}));
  ASSERT_TRUE(built.has_value());
  const MeshStatistics s = mesh_statistics(*built->mesh);
  EXPECT_EQ(s.vertices, 8U);
  EXPECT_EQ(s.edges, 12U);
  EXPECT_EQ(s.faces, 6U);
  EXPECT_THAT(s.faces_by_sides, ElementsAre(Pair(4U, 6U)));
  EXPECT_EQ(s.boundary_edges, 0U);
  EXPECT_EQ(s.boundary_loops, 0U);
  EXPECT_EQ(s.components, 1U);
  EXPECT_EQ(s.euler_characteristic, 2);
  EXPECT_EQ(s.highest_valence, 3U);
}

TEST(MeshStatistics, OpenPartsAndHoles) {
  // An annulus of three quads, a triangle and a pentagon joined at an edge, and a fan of five.
  const auto built = build_control_mesh(soup_of(19, {{0, 1, 4, 3},
                                                     {1, 2, 5, 4},
                                                     {2, 0, 3, 5},
                                                     {6, 7, 8},
                                                     {8, 7, 9, 10, 11},
                                                     {12, 13, 14},
                                                     {12, 14, 15},
                                                     {12, 15, 16},
                                                     {12, 16, 17},
                                                     {12, 17, 18}}));
  ASSERT_TRUE(built.has_value());
  const MeshStatistics s = mesh_statistics(*built->mesh);
  EXPECT_EQ(s.vertices, 19U);
  EXPECT_EQ(s.edges, 9U + 7 + 11);
  EXPECT_THAT(s.faces_by_sides, ElementsAre(Pair(3U, 6U), Pair(4U, 3U), Pair(5U, 1U)));
  EXPECT_EQ(s.boundary_edges, 6U + 6 + 7);
  EXPECT_EQ(s.boundary_loops, 4U);
  EXPECT_EQ(s.components, 3U);
  EXPECT_EQ(s.euler_characteristic, 0 + 1 + 1);
  EXPECT_EQ(s.highest_valence, 6U);  // The hub of the fan: five faces, six edges.
}

TEST(MeshStatistics, CountsCreasesAndSeams) {
  std::size_t charted_cubes = 0;
  for (const auto& [name, mesh] : test::textured_shapes()) {
    const MeshStatistics s = mesh_statistics(*mesh);
    EXPECT_EQ(s.uv_points, mesh->texture().values.size()) << name;
    if (name == "cube, cross") {
      EXPECT_EQ(s.uv_seams, 7U);
      ++charted_cubes;
    } else if (name == "cube, chart per face") {
      EXPECT_EQ(s.uv_seams, 12U);
      ++charted_cubes;
    }
  }
  EXPECT_EQ(charted_cubes, 2U);
  const MeshStatistics plain = mesh_statistics(*test::cube());
  EXPECT_EQ(plain.uv_points + plain.uv_seams + plain.crease_edges + plain.sharp_vertices, 0U);
  const MeshStatistics creased = mesh_statistics(*test::with_tags(
      test::cube_soup(), {{{0, 1}, 2.0F}, {{1, 2}, 0.5F}, {{2, 3}, 0.0F}}, {{7, 1.0F}}));
  EXPECT_EQ(creased.crease_edges, 2U);
  EXPECT_EQ(creased.sharp_vertices, 1U);
}

}  // namespace
}  // namespace limn
