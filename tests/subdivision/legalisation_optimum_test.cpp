// The optimum against trying everything, and both methods of legalisation against the optimum.
#include "legalisation_optimum.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "limn/subdivision/label_subdivision.h"
#include "support/effort.h"
#include "support/shapes.h"

namespace limn {
namespace {

using test::LegalisationGoal;
using test::MeshPointer;

std::uint64_t relabels(const VertexLabels& painted, const VertexLabels& labels) {
  std::uint64_t count = 0;
  for (std::size_t v = 0; v < painted.size(); ++v) {
    count += painted[v] == 0 && labels[v] > 0 ? 1 : 0;
  }
  return count;
}

/// The least of every legal choice, one by one.
std::uint64_t least_of_all(const ControlMesh& mesh, const VertexLabels& painted, NonQuadRule rule,
                           LegalisationGoal goal) {
  std::vector<std::uint32_t> zeros;
  for (std::uint32_t v = 0; v < painted.size(); ++v) {
    if (painted[v] == 0) {
      zeros.push_back(v);
    }
  }
  std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
  for (std::uint32_t bits = 0; bits < 1U << zeros.size(); ++bits) {
    VertexLabels labels = painted;
    for (std::size_t i = 0; i < zeros.size(); ++i) {
      labels[zeros[i]] = static_cast<std::uint8_t>(bits >> i & 1U);
    }
    if (illegal_faces(mesh, labels, LegalisationMethod::kLookAhead).empty() &&
        (rule == NonQuadRule::kUniformFirstStep ||
         apply_non_quad_rule(mesh, labels, rule) == labels)) {
      least =
          std::min(least, goal == LegalisationGoal::kFaces ? predict_refinement(mesh, labels).faces
                                                           : relabels(painted, labels));
    }
  }
  return least;
}

TEST(OptimalLegalisation, IsTheLeastOfAllChoices) {
  test::Random random(31);
  for (const auto& soup :
       {test::cube_soup(), test::torus_soup(4, 3), test::grid_soup(3, 2), test::prism_soup(5),
        test::trapezohedron_soup(5), test::polygon_in_ring_soup(6),
        test::with_mixed_faces(test::grid_soup(3, 2), random)}) {
    const MeshPointer mesh = test::control_mesh(soup);
    for (int painting = 0; painting < 6; ++painting) {
      SCOPED_TRACE(fmt::format("{} faces, painting {}", mesh->face_count(), painting));
      const VertexLabels painted = apply_non_quad_rule(
          *mesh, vertex_labels(*mesh, test::random_depths(*mesh, 0.2, 4, random)),
          NonQuadRule::kWherePainted);
      for (const auto goal : {LegalisationGoal::kFaces, LegalisationGoal::kRelabels}) {
        const auto best =
            test::optimal_legalisation(*mesh, painted, NonQuadRule::kWherePainted, goal);
        ASSERT_TRUE(best);
        EXPECT_TRUE(illegal_faces(*mesh, best->labels, LegalisationMethod::kLookAhead).empty());
        EXPECT_EQ(goal == LegalisationGoal::kFaces ? best->faces : best->relabels,
                  least_of_all(*mesh, painted, NonQuadRule::kWherePainted, goal));
      }
    }
  }
}

/// Sums over paintings that could be solved.
struct Totals {
  int paintings = 0;
  int look_ahead_optimal = 0;
  std::uint64_t greedy = 0;
  std::uint64_t look_ahead = 0;
  std::uint64_t optimum = 0;
};

Totals faces_over_paintings(const PolygonSoup& soup, double density, int paintings,
                            test::Random& random) {
  const MeshPointer mesh = test::control_mesh(soup);
  constexpr NonQuadRule kRule = NonQuadRule::kWherePainted;
  Totals totals;
  for (int painting = 0; painting < paintings; ++painting) {
    const VertexLabels painted = apply_non_quad_rule(
        *mesh, vertex_labels(*mesh, test::random_depths(*mesh, density, 1, random)), kRule);
    const auto best =
        test::optimal_legalisation(*mesh, painted, kRule, LegalisationGoal::kFaces, 14);
    if (!best) {
      continue;
    }
    IgnoreProgress progress;
    const auto greedy = legalise_greedy(*mesh, painted, kRule, progress);
    const auto found = legalise_look_ahead(*mesh, painted, kRule, progress);
    EXPECT_TRUE(greedy && found);
    const std::uint64_t faces = predict_refinement(*mesh, found->labels).faces;
    EXPECT_GE(faces, best->faces);
    ++totals.paintings;
    totals.look_ahead_optimal += faces == best->faces ? 1 : 0;
    totals.greedy += predict_refinement(*mesh, greedy->labels).faces;
    totals.look_ahead += faces;
    totals.optimum += best->faces;
  }
  return totals;
}

TEST(OptimalLegalisation, IsFoundMostTimesByLookAhead) {
  test::Random random(32);
  struct Case {
    PolygonSoup soup;
    double density;
  };
  const std::vector<Case> cases{{test::torus_soup(8, 8), 0.05},
                                {test::torus_soup(8, 8), 0.15},
                                {test::torus_soup(8, 8), 0.4},
                                {test::grid_soup(10, 10), 0.1},
                                {test::torus_soup(24, 5), 0.05},
                                {test::cube_soup(), 0.2},
                                {test::trapezohedron_soup(9), 0.1},
                                {test::random_quads(test::grid_soup(4, 4), random), 0.08},
                                {test::with_mixed_faces(test::grid_soup(8, 8), random), 0.06}};
  const int paintings = std::max(8, static_cast<int>(40 * test::effort()));
  Totals all;
  for (const Case& c : cases) {
    const Totals totals = faces_over_paintings(c.soup, c.density, paintings, random);
    EXPECT_GT(totals.paintings, 0) << c.soup.face_count() << " faces";
    EXPECT_LE(totals.look_ahead, totals.greedy) << c.soup.face_count() << " faces";
    all.paintings += totals.paintings;
    all.look_ahead_optimal += totals.look_ahead_optimal;
    all.greedy += totals.greedy;
    all.look_ahead += totals.look_ahead;
    all.optimum += totals.optimum;
  }
  EXPECT_GT(10 * all.look_ahead_optimal, 6 * all.paintings);
  // Of the faces that the greedy makes needlessly, it saves the most.
  EXPECT_LT(2 * (all.look_ahead - all.optimum), all.greedy - all.optimum);
}

}  // namespace
}  // namespace limn
