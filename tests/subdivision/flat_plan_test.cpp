// A plan against the refinement that it is for. What shaders make of it is tested with these.
#include "subdivision/flat_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "limn/subdivision/label_subdivision.h"
#include "support/shapes.h"

namespace limn {
namespace {

using test::MeshPointer;

/// A plan and the refined mesh of a random painting.
struct Planned {
  FlatPlanner planner;
  RefinedMesh mesh;
  [[nodiscard]] const FlatPlan& plan() const { return planner.result(); }
};

Planned planned(const ControlMesh& mesh, int deepest, const SubdivisionSettings& settings,
                double painted = 0.3) {
  test::Random random(17);
  IgnoreProgress progress;
  const VertexLabels labels =
      legal_labels(mesh, test::random_depths(mesh, painted, deepest, random), settings, progress)
          .value()
          .labels;
  Planned both;
  EXPECT_TRUE(both.planner.plan(mesh, labels, settings, {}, progress));
  both.mesh = refine(mesh, labels, settings, {}, progress).value();
  return both;
}

MeshPointer mixed_torus() {
  test::Random random(9);
  return test::control_mesh(test::with_mixed_faces(test::torus_soup(12, 8), random));
}

QuadLabels labels_of(const FlatNode& node) {
  QuadLabels labels{};
  for (std::size_t i = 0; i < 4; ++i) {
    labels[i] = static_cast<std::uint8_t>(node.bits >> 4 * i & 15U);
  }
  return labels;
}

TEST(FlatPlan, NodesMakeAllQuadsAndVertices) {
  for (const NonQuadRule rule : {NonQuadRule::kUniformFirstStep, NonQuadRule::kWherePainted}) {
    const Planned both = planned(*mixed_torus(), 4, {.non_quads = rule});
    const FlatPlan& plan = both.plan();
    EXPECT_EQ(plan.quad_count, both.mesh.quads.size());
    EXPECT_EQ(plan.vertex_count, both.mesh.vertex_count());
    EXPECT_EQ(plan.polygon_vertices, both.mesh.polygon_vertices);
    std::uint64_t quads = plan.resting_quads.size();
    for (const FlatNode& root : plan.roots) {
      quads += plan.subtrees.of(labels_of(root)).face.quads;
    }
    EXPECT_EQ(quads, plan.quad_count);
  }
}

TEST(FlatPlan, NodesOfAKindAreNumberedRootByRoot) {
  const Planned both = planned(*mixed_torus(), 5, {});
  const FlatPlan& plan = both.plan();
  for (std::size_t kind = 0; kind < kNodeKinds; ++kind) {
    std::uint64_t next = 0;
    for (std::size_t r = 0; r < plan.roots.size(); ++r) {
      ASSERT_EQ(plan.first_nodes[kind][r], next) << "kind " << kind << " root " << r;
      next += plan.subtrees.of(labels_of(plan.roots[r])).nodes[kind];
    }
    EXPECT_EQ(plan.node_counts[kind], next);
  }
}

TEST(FlatPlan, EachSubtreeIsSplitAndUniformNodes) {
  const SubtreeTable table(8);
  const auto uniform = [](std::uint8_t a) { return QuadLabels{a, a, a, a}; };
  for (std::uint8_t a = 1; a <= kMostUniformLevels; ++a) {
    NodeCounts one{};
    one[a] = 1;
    EXPECT_EQ(table.of(uniform(a)).nodes, one);
  }
  EXPECT_THAT(table.of(uniform(8)).nodes, testing::ElementsAre(1 + 4, 0, 0, 0, 0, 0, 16));
  // A Y-element and its three quads; then one whose child is a Y-element again.
  EXPECT_THAT(table.of({1, 0, 0, 0}).nodes, testing::ElementsAre(1, 0, 0, 0, 0, 0, 0));
  EXPECT_THAT(table.of({2, 0, 0, 0}).nodes, testing::ElementsAre(2, 0, 0, 0, 0, 0, 0));
  // Of its children, (1,1,1,1), (1,1,1,0), (1,0,0,0) and (1,0,0,0) turned, the first is uniform.
  EXPECT_THAT(table.of({2, 2, 2, 0}).nodes, testing::ElementsAre(4, 1, 0, 0, 0, 0, 0));
}

TEST(FlatPlan, RestingVerticesAreInPlace) {
  const MeshPointer mesh = test::control_mesh(test::torus_soup(12, 8));
  const Planned both = planned(*mesh, 3, {}, 0.05);
  const FlatPlan& plan = both.plan();
  std::size_t resting = 0;
  for (std::size_t v = 0; v < mesh->vertex_count(); ++v) {
    if (both.mesh.vertex_levels[v] == 0) {
      ++resting;
      EXPECT_LT(
          glm::distance(plan.origin + glm::dvec3(plan.control_points[v]), mesh->positions()[v]),
          1e-6);
    }
  }
  EXPECT_GT(resting, 0u);
  EXPECT_LT(resting, mesh->vertex_count());
}

TEST(FlatPlan, RegularPatchesAreNotSpecial) {
  const MeshPointer torus = test::control_mesh(test::torus_soup(8, 6));
  const Planned both = planned(*torus, 3, {});
  EXPECT_FALSE(both.plan().roots.empty());
  EXPECT_TRUE(both.plan().specials.empty());
  EXPECT_EQ(both.plan().piece_count, 0u);
}

TEST(FlatPlan, IsTheSameWhenMadeAgain) {
  const MeshPointer torus = mixed_torus();
  Planned both = planned(*torus, 4, {});
  const LargeArray<glm::vec3> points = both.plan().points;
  const std::uint64_t pieces = both.plan().piece_count;
  EXPECT_GT(pieces, 0u);
  IgnoreProgress progress;
  ASSERT_TRUE(both.planner.plan(*test::cube(), VertexLabels(8, 2), {}, {}, progress));
  EXPECT_EQ(both.plan().quad_count, 96u);
  const Planned again = planned(*torus, 4, {});
  EXPECT_TRUE(again.plan().points == points);
  EXPECT_EQ(again.plan().piece_count, pieces);
}

TEST(FlatPlan, SaysWhenItIsOverTheBudget) {
  FlatPlanner planner;
  IgnoreProgress progress;
  const auto done =
      planner.plan(*test::cube(), VertexLabels(8, 5), {}, {.face_budget = 6143}, progress);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().kind, ErrorKind::kOverBudget);
}

}  // namespace
}  // namespace limn
