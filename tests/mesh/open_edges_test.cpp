#include "limn/mesh/open_edges.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/mesh/statistics.h"
#include "support/shapes.h"

namespace limn {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Two small quads beside a large one, whose long edge runs past the vertex between them:
///
///   3-------2   7---6
///   |       |   |   |
///   |       |   4---5   (4 lies in the middle of 1-2, once the gap is 0)
///   |       |   |   |
///   0-------1   8---9
test::MeshPointer split_beside_whole(double gap, double scale = 1.0) {
  std::vector<glm::dvec3> positions{{0, 0, 0},       {2, 0, 0}, {2, 2, 0}, {0, 2, 0},
                                    {2 + gap, 1, 0}, {3, 1, 0}, {3, 2, 0}, {2 + gap, 2, 0},
                                    {2 + gap, 0, 0}, {3, 0, 0}};
  for (glm::dvec3& position : positions) {
    position *= scale;
  }
  return test::control_mesh(positions, {{0, 1, 2, 3}, {4, 5, 6, 7}, {8, 9, 5, 4}});
}

TEST(TJunctions, AVertexOnALongEdgeIsOne) {
  for (const double scale : {1e-6, 1.0, 1e6}) {
    const auto mesh = split_beside_whole(0.0, scale);
    const std::vector<TJunction> found = find_t_junctions(*mesh);
    ASSERT_EQ(found.size(), 1U) << scale;
    EXPECT_EQ(found[0].vertex, 4U);
    EXPECT_THAT(mesh->topology().edge_vertices[found[0].edge], ElementsAre(1U, 2U));
  }
}

TEST(TJunctions, AGapIsNone) {
  EXPECT_THAT(find_t_junctions(*split_beside_whole(0.01)), IsEmpty());
  EXPECT_EQ(find_t_junctions(*split_beside_whole(0.01), 0.02).size(), 1U) << "but to a wider eye";
}

TEST(TJunctions, EndsThatTouchAreNone) {
  // Unjoined, but edge to edge: corners meet corners.
  const auto mesh = test::control_mesh(
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}},
      {{0, 1, 2, 3}, {4, 5, 6, 7}});
  EXPECT_THAT(find_t_junctions(*mesh), IsEmpty());
}

TEST(TJunctions, JoinedAndClosedMeshesHaveNone) {
  EXPECT_THAT(find_t_junctions(*test::grid(12)), IsEmpty());
  EXPECT_THAT(find_t_junctions(*test::cube()), IsEmpty());
}

TEST(BoundaryLoops, AreAsManyAsStatisticsCountAndHoldEveryBoundaryEdge) {
  test::Random random(3);
  const std::vector<PolygonSoup> soups{test::cube_soup(), test::grid_soup(5, 4),
                                       test::polygon_in_ring_soup(5),
                                       test::with_holes(test::torus_soup(12, 9), 9, random)};
  for (const PolygonSoup& soup : soups) {
    const auto mesh = test::control_mesh(soup);
    const MeshStatistics statistics = mesh_statistics(*mesh);
    const std::vector<BoundaryLoop> loops = boundary_loops(*mesh);
    EXPECT_EQ(loops.size(), statistics.boundary_loops);
    std::size_t edges = 0;
    for (const BoundaryLoop& loop : loops) {
      edges += loop.size();
      EXPECT_GE(loop.size(), 3U);
    }
    EXPECT_EQ(edges, statistics.boundary_edges);
  }
}

TEST(BoundaryLoops, RunAroundInOrder) {
  const auto mesh =
      test::control_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
  EXPECT_THAT(boundary_loops(*mesh), ElementsAre(ElementsAre(0U, 1U, 2U, 3U)));
}

}  // namespace
}  // namespace limn
