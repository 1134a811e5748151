// The greedy against the loop it must equal: everything counted anew for every step.
#include "limn/subdivision/legalisation.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "limn/subdivision/label_subdivision.h"
#include "support/shape_lists.h"
#include "support/shapes.h"

namespace limn {
namespace {

using test::MeshPointer;

std::vector<std::vector<std::uint32_t>> neighbours_along_edges(const ControlMesh& mesh) {
  std::vector<std::vector<std::uint32_t>> neighbours(mesh.vertex_count());
  for (const auto& [a, b] : mesh.topology().edge_vertices) {
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  }
  return neighbours;
}

Legalisation brute_force(const ControlMesh& mesh, VertexLabels labels, NonQuadRule rule) {
  const auto neighbours = neighbours_along_edges(mesh);
  Legalisation result;
  for (;;) {
    const std::vector<std::uint32_t> illegal = illegal_vertices(mesh, labels);
    if (illegal.empty()) {
      break;
    }
    std::vector<char> is_illegal(labels.size(), 0);
    for (const std::uint32_t v : illegal) {
      is_illegal[v] = 1;
    }
    const auto valence = [&](std::uint32_t v) {
      return static_cast<std::uint32_t>(std::ranges::count_if(
          neighbours[v], [&](std::uint32_t w) { return is_illegal[w] != 0; }));
    };
    std::vector<std::uint32_t> cost(labels.size(), 0);
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      const auto face = mesh.face(f);
      if (face.size() == 4 &&
          std::ranges::count_if(face, [&](std::uint32_t v) { return labels[v] == 0; }) == 3) {
        for (const std::uint32_t v : face) {
          ++cost[v];
        }
      }
    }
    std::vector<std::uint32_t> candidates;
    for (const std::uint32_t v : illegal) {
      if (std::ranges::any_of(neighbours[v], [&](std::uint32_t w) {
            return is_illegal[w] != 0 && valence(w) == 1;
          })) {
        candidates.push_back(v);
      }
    }
    if (candidates.empty()) {
      candidates = illegal;
    }
    const std::uint32_t best =
        *std::ranges::min_element(candidates, [&](std::uint32_t a, std::uint32_t b) {
          return std::tuple(valence(b), cost[a], a) < std::tuple(valence(a), cost[b], b);
        });
    result.steps.push_back({.vertex = best, .valence = valence(best), .cost = cost[best]});
    labels[best] = 1;
    if (rule == NonQuadRule::kWherePainted) {
      labels = apply_non_quad_rule(mesh, std::move(labels), rule);
    }
  }
  result.labels = std::move(labels);
  return result;
}

/// As the header tells a display to.
VertexLabels replayed(const ControlMesh& mesh, VertexLabels labels, NonQuadRule rule,
                      const std::vector<LegalisationStep>& steps) {
  for (const LegalisationStep& step : steps) {
    labels[step.vertex] = 1;
    if (rule == NonQuadRule::kWherePainted) {
      labels = apply_non_quad_rule(mesh, std::move(labels), rule);
    }
  }
  return labels;
}

void expect_equal(const ControlMesh& mesh, const VertexLabels& labels, NonQuadRule rule) {
  const Legalisation expected = brute_force(mesh, labels, rule);
  IgnoreProgress progress;
  const auto found = legalise_greedy(mesh, labels, rule, progress);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->labels, expected.labels);
  ASSERT_EQ(found->steps.size(), expected.steps.size());
  for (std::size_t i = 0; i < expected.steps.size(); ++i) {
    ASSERT_EQ(found->steps[i].vertex, expected.steps[i].vertex) << "step " << i;
    ASSERT_EQ(found->steps[i].valence, expected.steps[i].valence) << "step " << i;
    ASSERT_EQ(found->steps[i].cost, expected.steps[i].cost) << "step " << i;
  }
  ASSERT_TRUE(illegal_faces(mesh, found->labels).empty());
  ASSERT_EQ(replayed(mesh, labels, rule, found->steps), found->labels);
}

/// Painted by faces, or vertex by vertex, which makes patterns that no painting does.
VertexLabels random_labels(const ControlMesh& mesh, int painting, test::Random& random) {
  const double probability = std::pow(0.5, 1 + painting % 6);
  if (painting % 3 != 0) {
    return vertex_labels(mesh, test::random_depths(mesh, probability, 5, random));
  }
  std::bernoulli_distribution is_positive(probability);
  VertexLabels labels(mesh.vertex_count());
  std::ranges::generate(labels, [&] { return static_cast<std::uint8_t>(is_positive(random)); });
  return labels;
}

void expect_equal_for_paintings(const PolygonSoup& soup, int paintings, test::Random& random) {
  const MeshPointer mesh = test::control_mesh(soup);
  for (int painting = 0; painting < paintings; ++painting) {
    SCOPED_TRACE(fmt::format("{} faces, painting {}", mesh->face_count(), painting));
    const VertexLabels labels = random_labels(*mesh, painting, random);
    for (const NonQuadRule rule : {NonQuadRule::kWherePainted, NonQuadRule::kUniformFirstStep}) {
      if (mesh->is_all_quads() && rule == NonQuadRule::kUniformFirstStep) {
        continue;
      }
      expect_equal(*mesh, apply_non_quad_rule(*mesh, labels, rule), rule);
      if (testing::Test::HasFatalFailure()) {
        return;
      }
    }
  }
}

TEST(GreedyLegalisation, EqualsBruteForceOnRegularMeshes) {
  test::Random random(11);
  for (const auto& soup : test::regular_soups()) {
    expect_equal_for_paintings(soup, 150, random);
  }
  expect_equal_for_paintings(test::torus_soup(16, 16), 30, random);
}

TEST(GreedyLegalisation, EqualsBruteForceAroundPoles) {
  test::Random random(12);
  for (const std::uint32_t n : {2u, 3u, 5u, 9u, 64u}) {
    expect_equal_for_paintings(test::trapezohedron_soup(std::max(n, 3u)), 100, random);
  }
  expect_equal_for_paintings(test::trapezohedron_soup(300), 12,
                             random);  // More than a byte counts.
}

TEST(GreedyLegalisation, EqualsBruteForceOnRandomQuadMeshes) {
  test::Random random(13);
  for (int i = 0; i < 40; ++i) {
    expect_equal_for_paintings(test::random_quad_soup(i, random), 30, random);
  }
}

TEST(GreedyLegalisation, EqualsBruteForceOnMixedMeshes) {
  test::Random random(14);
  for (int i = 0; i < 40; ++i) {
    expect_equal_for_paintings(test::random_mixed_soup(i, random), 30, random);
  }
  expect_equal_for_paintings(test::prism_soup(5), 60, random);
  expect_equal_for_paintings(test::polygon_in_ring_soup(7), 60, random);
}

TEST(GreedyLegalisation, LeavesNoIllegalFaceOnACubeWithOnePaintedFace) {
  const MeshPointer cube = test::cube();
  for (std::size_t painted = 0; painted < 6; ++painted) {
    std::vector<std::uint8_t> depths(6, 0);
    depths[painted] = 1;
    IgnoreProgress progress;
    const VertexLabels labels = vertex_labels(*cube, depths);
    EXPECT_EQ(illegal_faces(*cube, labels).size(), 4u);
    const auto legal = legalise_greedy(*cube, labels, NonQuadRule::kWherePainted, progress);
    ASSERT_TRUE(legal);
    EXPECT_EQ(legal->steps.size(), 3u);
    EXPECT_TRUE(illegal_faces(*cube, legal->labels).empty());
  }
}

TEST(GreedyLegalisation, RaisesThePolygonsItTouchesWherePainted) {
  // A relabelled ring vertex of a prism makes its whole cap positive.
  const MeshPointer mesh = test::control_mesh(test::prism_soup(5));
  VertexLabels labels(10, 0);
  labels = apply_non_quad_rule(
      *mesh,
      [&] {
        labels[0] = 2;
        return labels;
      }(),
      NonQuadRule::kWherePainted);
  ASSERT_FALSE(illegal_faces(*mesh, labels).empty());
  IgnoreProgress progress;
  const auto legal = legalise_greedy(*mesh, labels, NonQuadRule::kWherePainted, progress);
  ASSERT_TRUE(legal);
  EXPECT_EQ(legal->steps.size(), 1u);
  EXPECT_EQ(std::ranges::count(legal->labels, 0), 0);
}

TEST(GreedyLegalisation, StopsWhenAsked) {
  class Stop final : public Progress {
   public:
    bool report(double, std::string_view) override { return false; }
  };
  Stop stop;
  const MeshPointer mesh = test::control_mesh(test::torus_soup(8, 8));
  VertexLabels labels(mesh->vertex_count(), 0);
  labels[3] = 1;
  const auto result = legalise_greedy(*mesh, labels, NonQuadRule::kWherePainted, stop);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::kCancelled);
}

}  // namespace
}  // namespace limn
