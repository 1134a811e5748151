// A legalisation as it is shown: every move is the best of what it chose from, counted anew.
#include "limn/subdivision/legalisation_trace.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/shape_lists.h"
#include "support/shapes.h"

namespace limn {
namespace {

using test::MeshPointer;
using ::testing::IsEmpty;

Legalisation legalised(const ControlMesh& mesh, const VertexLabels& labels, NonQuadRule rule,
                       LegalisationMethod method) {
  IgnoreProgress progress;
  auto found = method == LegalisationMethod::kGreedy
                   ? legalise_greedy(mesh, labels, rule, progress)
                   : legalise_look_ahead(mesh, labels, rule, progress);
  EXPECT_TRUE(found);
  return found ? *std::move(found) : Legalisation{};
}

/// One step as the header of legalisation.h tells a display to.
VertexLabels stepped(const ControlMesh& mesh, VertexLabels labels, NonQuadRule rule,
                     const LegalisationStep& step) {
  labels[step.vertex] = step.label;
  return step.label > 0 && rule == NonQuadRule::kWherePainted
             ? apply_non_quad_rule(mesh, std::move(labels), rule)
             : labels;
}

/// Follows a legalisation from one end to the other and back. Returns its moves.
std::size_t follow(const MeshPointer& mesh, const VertexLabels& labels, NonQuadRule rule,
                   LegalisationMethod method) {
  const Legalisation legal = legalised(*mesh, labels, rule, method);
  LegalisationTrace trace(mesh, labels, legal, rule, method);
  EXPECT_EQ(trace.order(), legal.order);
  VertexLabels expected = labels;
  std::size_t steps = 0;
  for (std::size_t i = 0; i < trace.size(); ++i) {
    SCOPED_TRACE(fmt::format("move {} of {}", i, trace.size()));
    trace.seek(i);
    EXPECT_EQ(trace.labels(), expected);
    const LegalisationStep& first = trace.move(i).front();
    const auto candidates = trace.candidates();
    if (trace.is_reset(i)) {
      EXPECT_THAT(candidates, IsEmpty());
      EXPECT_THAT(trace.illegal_faces(), IsEmpty()) << "vertices go back once all is legal";
    } else {
      EXPECT_FALSE(candidates.empty());
      if (candidates.empty()) {
        return trace.size();
      }
      const LegalisationCandidate& best = candidates.front();
      EXPECT_EQ(best.vertex, first.vertex);
      if (legal.order == LegalisationMethod::kGreedy) {
        EXPECT_EQ(best.valence, first.valence);
        EXPECT_EQ(best.cost, first.cost);
      } else {
        EXPECT_EQ(best.score, first.score);
      }
    }
    for (const LegalisationStep& step : trace.move(i)) {
      expected = stepped(*mesh, std::move(expected), rule, step);
      ++steps;
    }
    if (testing::Test::HasFailure()) {
      return trace.size();
    }
  }
  EXPECT_EQ(steps, legal.steps.size());
  trace.seek(trace.size() + 7);
  EXPECT_EQ(trace.position(), trace.size());
  EXPECT_EQ(trace.labels(), legal.labels);
  EXPECT_THAT(trace.illegal_faces(), IsEmpty());
  EXPECT_THAT(trace.illegal_vertices(), IsEmpty());
  EXPECT_THAT(trace.candidates(), IsEmpty());
  trace.seek(trace.size() / 2);
  const VertexLabels middle = trace.labels();
  trace.seek(0);
  EXPECT_EQ(trace.labels(), labels);
  EXPECT_EQ(trace.illegal_faces(), illegal_faces(*mesh, labels, legal.order));
  EXPECT_THAT(trace.raised_vertices(), IsEmpty());
  trace.seek(trace.size() / 2);
  EXPECT_EQ(trace.labels(), middle) << "the way back is the way there";
  return trace.size();
}

/// Paintings of every shape with both methods and rules.
std::size_t follow_paintings(const std::vector<PolygonSoup>& soups, LegalisationMethod method,
                             unsigned seed) {
  test::Random random(seed);
  std::size_t moves = 0;
  for (std::size_t shape = 0; shape < soups.size(); ++shape) {
    const MeshPointer mesh = test::control_mesh(soups[shape]);
    for (int painting = 0; painting < 8; ++painting) {
      SCOPED_TRACE(fmt::format("shape {}, painting {}", shape, painting));
      const VertexLabels labels = vertex_labels(
          *mesh, test::random_depths(*mesh, std::pow(0.5, 1 + painting % 4), 3, random));
      for (const NonQuadRule rule : {NonQuadRule::kWherePainted, NonQuadRule::kUniformFirstStep}) {
        moves += follow(mesh, apply_non_quad_rule(*mesh, labels, rule), rule, method);
        if (testing::Test::HasFailure()) {
          return moves;
        }
      }
    }
  }
  return moves;
}

TEST(LegalisationTrace, EveryGreedyMoveIsTheBestCandidate) {
  EXPECT_GT(follow_paintings(test::regular_soups(), LegalisationMethod::kGreedy, 21), 100U);
  EXPECT_GT(follow_paintings({test::torus_soup(12, 12)}, LegalisationMethod::kGreedy, 22), 50U);
}

TEST(LegalisationTrace, EveryLookAheadMoveHasTheHighestScore) {
  EXPECT_GT(follow_paintings(test::regular_soups(), LegalisationMethod::kLookAhead, 23), 50U);
  EXPECT_GT(follow_paintings({test::torus_soup(12, 12)}, LegalisationMethod::kLookAhead, 24), 20U);
}

TEST(LegalisationTrace, FollowsMeshesWithFacesOfAllKindsAndPoles) {
  test::Random random(25);
  std::vector<PolygonSoup> soups{test::trapezohedron_soup(9), test::trapezohedron_soup(50)};
  for (int i = 0; i < 4; ++i) {
    soups.push_back(test::with_mixed_faces(test::grid_soup(8, 8), random));
  }
  for (const LegalisationMethod method :
       {LegalisationMethod::kGreedy, LegalisationMethod::kLookAhead}) {
    EXPECT_GT(follow_paintings(soups, method, 26), 30U);
  }
}

TEST(LegalisationTrace, VerticesThatGoBackTogetherAreOneMove) {
  // Made by hand: two raises, then both taken back at once.
  const MeshPointer mesh = test::grid(3);
  Legalisation legal;
  legal.labels.assign(mesh->vertex_count(), 0);
  legal.steps = {{.vertex = 5},
                 {.vertex = 6},
                 {.vertex = 5, .label = 0, .is_joint = true},
                 {.vertex = 6, .label = 0}};
  legal.order = LegalisationMethod::kLookAhead;
  LegalisationTrace trace(mesh, legal.labels, legal, NonQuadRule::kWherePainted,
                          LegalisationMethod::kLookAhead);
  ASSERT_EQ(trace.size(), 3U);
  EXPECT_EQ(trace.move(2).size(), 2U);
  EXPECT_TRUE(trace.is_reset(2));
  trace.seek(2);
  EXPECT_THAT(trace.raised_vertices(), testing::ElementsAre(5, 6));
  trace.seek(3);
  EXPECT_THAT(trace.raised_vertices(), IsEmpty());
}

TEST(LegalisationTrace, ACubeWithOneFaceTellsItsThreeMoves) {
  const MeshPointer mesh = test::cube();
  const VertexLabels labels = vertex_labels(*mesh, std::vector<std::uint8_t>{0, 0, 0, 1, 0, 0});
  const Legalisation legal =
      legalised(*mesh, labels, NonQuadRule::kUniformFirstStep, LegalisationMethod::kGreedy);
  LegalisationTrace trace(mesh, labels, legal, NonQuadRule::kUniformFirstStep,
                          LegalisationMethod::kGreedy);
  ASSERT_EQ(trace.size(), 3U) << "as published: one painted face of a cube wants three relabels";
  EXPECT_EQ(trace.illegal_faces().size(), 4U) << "the four faces around";
  const auto first = trace.candidates();
  ASSERT_EQ(first.size(), 4U);
  for (const LegalisationCandidate& candidate : first) {
    EXPECT_EQ(candidate.valence, 2U);
    EXPECT_EQ(candidate.cost, 0U);
    EXPECT_FALSE(candidate.is_beside_leaf);
  }
  trace.seek(1);
  const auto second = trace.candidates();
  ASSERT_FALSE(second.empty());
  EXPECT_EQ(second.front().vertex, legal.steps[1].vertex);
}

}  // namespace
}  // namespace limn
