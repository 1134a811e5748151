// Loop's scheme as an exercise sets it: adjacency first, then every position out of its row.
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "limn/subdivision/schemes/loop_adjacency.h"
#include "limn/subdivision/schemes/uniform.h"
#include "scheme_shapes.h"

namespace limn {
namespace {

using test::MeshPointer;

double beta(LoopWeights weights, std::size_t n) {
  const auto valence = static_cast<double>(n);
  if (weights == LoopWeights::kWarren) {
    return n == 3 ? 3.0 / 16.0 : 3.0 / (8.0 * valence);
  }
  return (5.0 / 8.0 - std::pow(3.0 / 8.0 + std::cos(2.0 * std::numbers::pi / valence) / 4.0, 2)) /
         valence;
}

TEST(LoopAdjacency, GivesEveryPosition) {
  for (const LoopWeights weights : {LoopWeights::kOriginal, LoopWeights::kWarren}) {
    for (const test::NamedShape& shape : test::closed_shapes_for(Scheme::kLoop)) {
      const ControlMesh& mesh = *shape.mesh;
      const LoopAdjacency adjacency = loop_adjacency(mesh);
      IgnoreProgress progress;
      const RefinedMesh result =
          subdivide(mesh, {.scheme = Scheme::kLoop, .weights = weights}, {}, progress).value();
      const double tolerance = 1e-6 * mesh.bounds().diagonal();
      for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        const auto row = adjacency.row(v);
        ASSERT_EQ(row.size(), row[0] + 1u);
        const double share = beta(weights, row[0]);
        glm::dvec3 expected = (1.0 - row[0] * share) * mesh.positions()[v];
        for (const std::uint32_t neighbour : row.subspan(1)) {
          expected += share * mesh.positions()[neighbour];
        }
        ASSERT_LT(glm::distance(result.position(v), expected), tolerance) << shape.name;
      }
      ASSERT_EQ(adjacency.midpoints.size(), mesh.edge_count());
      for (std::size_t e = 0; e < mesh.edge_count(); ++e) {
        const auto& [a, b, c, d] = adjacency.midpoints[e];
        const glm::dvec3 expected = 0.375 * (mesh.positions()[a] + mesh.positions()[b]) +
                                    0.125 * (mesh.positions()[c] + mesh.positions()[d]);
        ASSERT_LT(glm::distance(result.position(mesh.vertex_count() + e), expected), tolerance)
            << shape.name;
      }
    }
  }
}

TEST(LoopAdjacency, RunsFromBoundaryToBoundary) {
  // A fan of two triangles around vertex 0.
  const MeshPointer fan =
      test::control_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}}, {{0, 1, 2}, {0, 2, 3}});
  const LoopAdjacency adjacency = loop_adjacency(*fan);
  EXPECT_EQ(std::vector<std::uint32_t>(adjacency.row(0).begin(), adjacency.row(0).end()),
            (std::vector<std::uint32_t>{3, 1, 2, 3}));
  std::size_t with_one_side = 0;
  for (const auto& midpoint : adjacency.midpoints) {
    with_one_side += midpoint[3] == kNone ? 1 : 0;
  }
  EXPECT_EQ(with_one_side, 4u);
}

TEST(LoopWeights, DifferOnlyOffTheRegular) {
  // Every vertex of the torus has six edges: the diagonals of its quads run alike.
  std::vector<std::vector<std::uint32_t>> triangles;
  const PolygonSoup quads = test::torus_soup(8, 6);
  for (std::size_t f = 0; f < quads.face_count(); ++f) {
    const auto quad = quads.face(f);
    triangles.push_back({quad[0], quad[1], quad[2]});
    triangles.push_back({quad[0], quad[2], quad[3]});
  }
  const MeshPointer torus = test::control_mesh(quads.positions, triangles);
  const MeshPointer tetrahedron =
      test::control_mesh({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                         {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}});
  const auto farthest = [](const ControlMesh& mesh) {
    IgnoreProgress progress;
    const RefinedMesh one = subdivide(mesh, {.scheme = Scheme::kLoop}, {}, progress).value();
    const RefinedMesh other =
        subdivide(mesh, {.scheme = Scheme::kLoop, .weights = LoopWeights::kWarren}, {}, progress)
            .value();
    double distance = 0.0;
    for (std::size_t v = 0; v < one.vertex_count(); ++v) {
      distance = std::max(distance, glm::distance(one.position(v), other.position(v)));
    }
    return distance;
  };
  EXPECT_LT(farthest(*torus), 1e-6);
  // For n = 3 both are 3/16: Warren's choice agrees with Loop's there.
  EXPECT_LT(farthest(*tetrahedron), 1e-6);
  const MeshPointer icosahedron = test::scheme_shapes()[13].mesh;
  ASSERT_EQ(icosahedron->vertex_count(), 12u);
  EXPECT_GT(farthest(*icosahedron), 1e-3);
}

}  // namespace
}  // namespace limn
