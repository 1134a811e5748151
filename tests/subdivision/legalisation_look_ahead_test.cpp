// What look-ahead promises, on meshes of every kind; how close it comes to the optimum is in
// legalisation_optimum_test.cpp.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "exactness_check.h"
#include "limn/subdivision/label_subdivision.h"
#include "support/shape_lists.h"
#include "support/shapes.h"

namespace limn {
namespace {

using test::MeshPointer;
using ::testing::IsEmpty;

constexpr LegalisationMethod kMethod = LegalisationMethod::kLookAhead;

Legalisation look_ahead(const ControlMesh& mesh, const VertexLabels& labels, NonQuadRule rule) {
  IgnoreProgress progress;
  auto found = legalise_look_ahead(mesh, labels, rule, progress);
  EXPECT_TRUE(found);
  return found ? *std::move(found) : Legalisation{};
}

/// As the header tells a display to.
VertexLabels look_ahead_replayed(const ControlMesh& mesh, VertexLabels labels, NonQuadRule rule,
                                 const std::vector<LegalisationStep>& steps) {
  for (const LegalisationStep& step : steps) {
    labels[step.vertex] = step.label;
    if (step.label > 0 && rule == NonQuadRule::kWherePainted) {
      labels = apply_non_quad_rule(mesh, std::move(labels), rule);
    }
  }
  return labels;
}

/// The labels with some relabelled vertices back at 0, and with them all that faces other than
/// quads tie to them.
VertexLabels without(const ControlMesh& mesh, VertexLabels labels,
                     std::vector<std::uint32_t> vertices) {
  while (!vertices.empty()) {
    const std::uint32_t v = vertices.back();
    vertices.pop_back();
    labels[v] = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      const auto face = mesh.face(f);
      if (face.size() != 4 && std::ranges::count(face, v) > 0) {
        std::ranges::copy_if(face, std::back_inserter(vertices),
                             [&](std::uint32_t w) { return labels[w] > 0; });
      }
    }
  }
  return labels;
}

/// No relabel, and no two in one quad, that could be spared.
void expect_nothing_needless(const ControlMesh& mesh, const VertexLabels& painted,
                             const VertexLabels& labels) {
  const auto is_relabelled = [&](std::uint32_t v) { return painted[v] == 0 && labels[v] > 0; };
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (const std::uint32_t a : face) {
      for (const std::uint32_t b : face) {
        if (face.size() == 4 && is_relabelled(a) && is_relabelled(b)) {
          ASSERT_THAT(illegal_faces(mesh, without(mesh, labels, {a, b}), kMethod),
                      ::testing::Not(IsEmpty()))
              << "vertices " << a << " and " << b;
        }
      }
    }
  }
}

void expect_promises(const ControlMesh& mesh, const VertexLabels& painted, NonQuadRule rule) {
  const Legalisation found = look_ahead(mesh, painted, rule);
  ASSERT_THAT(illegal_faces(mesh, found.labels, kMethod), IsEmpty());
  for (std::size_t v = 0; v < painted.size(); ++v) {
    if (painted[v] > 0) {
      ASSERT_EQ(found.labels[v], painted[v]) << "vertex " << v;
    } else {
      ASSERT_LE(found.labels[v], 1) << "vertex " << v;
    }
  }
  ASSERT_EQ(apply_non_quad_rule(mesh, found.labels, NonQuadRule::kWherePainted), found.labels);
  ASSERT_EQ(look_ahead_replayed(mesh, painted, rule, found.steps), found.labels);
  expect_nothing_needless(mesh, painted, found.labels);

  IgnoreProgress progress;
  const auto greedy = legalise_greedy(mesh, painted, rule, progress);
  ASSERT_TRUE(greedy);
  ASSERT_LE(predict_refinement(mesh, found.labels).faces,
            predict_refinement(mesh, greedy->labels).faces);
}

void expect_promises_for_paintings(const PolygonSoup& soup, int paintings, test::Random& random) {
  const MeshPointer mesh = test::control_mesh(soup);
  for (int painting = 0; painting < paintings; ++painting) {
    SCOPED_TRACE(fmt::format("{} faces, painting {}", mesh->face_count(), painting));
    const VertexLabels labels = vertex_labels(
        *mesh, test::random_depths(*mesh, std::pow(0.5, 1 + painting % 6), 5, random));
    for (const NonQuadRule rule : {NonQuadRule::kWherePainted, NonQuadRule::kUniformFirstStep}) {
      expect_promises(*mesh, apply_non_quad_rule(*mesh, labels, rule), rule);
      if (testing::Test::HasFatalFailure()) {
        return;
      }
    }
  }
}

TEST(LookAhead, KeepsItsPromisesOnRegularMeshes) {
  test::Random random(21);
  for (const auto& soup : test::regular_soups()) {
    expect_promises_for_paintings(soup, 60, random);
  }
}

TEST(LookAhead, KeepsItsPromisesAroundPoles) {
  test::Random random(22);
  for (const std::uint32_t n : {3u, 5u, 9u, 40u}) {  // Beyond 32 quads it does not look.
    expect_promises_for_paintings(test::trapezohedron_soup(n), 60, random);
  }
  expect_promises_for_paintings(test::trapezohedron_soup(300), 3, random);
}

TEST(LookAhead, KeepsItsPromisesOnRandomQuadMeshes) {
  test::Random random(23);
  for (int i = 0; i < 20; ++i) {
    expect_promises_for_paintings(test::random_quad_soup(i, random), 12, random);
  }
}

TEST(LookAhead, KeepsItsPromisesOnMixedMeshes) {
  test::Random random(24);
  for (int i = 0; i < 30; ++i) {
    expect_promises_for_paintings(test::random_mixed_soup(i, random), 12, random);
  }
  expect_promises_for_paintings(test::prism_soup(5), 30, random);
  expect_promises_for_paintings(test::polygon_in_ring_soup(7), 30, random);
}

TEST(LookAhead, LeavesOppositeLabelsAlone) {
  const MeshPointer quad = test::grid(1);
  VertexLabels labels(4, 0);
  labels[quad->face(0)[1]] = 2;
  labels[quad->face(0)[3]] = 1;
  EXPECT_THAT(look_ahead(*quad, labels, NonQuadRule::kWherePainted).steps, IsEmpty());
  labels[quad->face(0)[0]] = 1;
  labels[quad->face(0)[3]] = 0;
  EXPECT_EQ(look_ahead(*quad, labels, NonQuadRule::kWherePainted).steps.size(), 1U);
}

TEST(LookAhead, ClosesOnePaintedFaceWithTwoPairsOfRelabels) {
  // At two opposite corners of the painted face, one vertex along either edge.
  const MeshPointer mesh = test::control_mesh(test::torus_soup(9, 9));
  std::vector<std::uint8_t> depths(mesh->face_count(), 0);
  depths[40] = 3;
  const VertexLabels painted = vertex_labels(*mesh, depths);
  const Legalisation found = look_ahead(*mesh, painted, NonQuadRule::kWherePainted);
  EXPECT_EQ(std::ranges::count(found.labels, 3), 4);
  EXPECT_EQ(std::ranges::count(found.labels, 1), 4);
}

TEST(LookAhead, TakesTheGreedysLabelsWhereTheyAreBetter) {
  // The promise is not idle: among these paintings are some that the score alone does worse on.
  const MeshPointer mesh = test::control_mesh(test::torus_soup(8, 8));
  test::Random random(25);
  int taken = 0;
  for (int painting = 0; painting < 200; ++painting) {
    const VertexLabels labels = vertex_labels(*mesh, test::random_depths(*mesh, 0.15, 2, random));
    const Legalisation found = look_ahead(*mesh, labels, NonQuadRule::kWherePainted);
    taken += std::ranges::any_of(found.steps, [](const LegalisationStep& step) {
      return step.valence > 0;  // Only the greedy counts it.
    });
  }
  EXPECT_GT(taken, 0);
  EXPECT_LT(taken, 20);
}

TEST(LookAhead, RefinesToPointsOfUniformCatmullClark) {
  test::Random random(26);
  for (const auto& soup : {test::cube_soup(), test::torus_soup(7, 6), test::grid_soup(7, 7),
                           test::with_mixed_faces(test::grid_soup(6, 6), random),
                           test::random_quads(test::torus_soup(3, 4), random)}) {
    const MeshPointer mesh = test::control_mesh(soup);
    constexpr int kDeepest = 3;
    const test::UniformReference reference(*mesh, kDeepest + 1, CornerRule::kSharp);
    for (int painting = 0; painting < 6; ++painting) {
      SubdivisionSettings settings;
      settings.legalisation = kMethod;
      settings.non_quads =
          painting % 2 == 0 ? NonQuadRule::kWherePainted : NonQuadRule::kUniformFirstStep;
      IgnoreProgress progress;
      const auto legal = legal_labels(*mesh, test::random_depths(*mesh, 0.1, kDeepest, random),
                                      settings, progress);
      ASSERT_TRUE(legal);
      const test::Exactness exactness = reference.compare(legal->labels, settings, kAllLevels);
      EXPECT_EQ(exactness.difference, "");
      EXPECT_EQ(exactness.off, 0U);
      EXPECT_EQ(test::first_breach(*mesh, legal->labels, settings, kAllLevels), "");
    }
  }
}

TEST(LookAhead, StopsWhenAskedAtAnyTime) {
  class StopAt final : public Progress {
   public:
    explicit StopAt(int reports) : left_(reports) {}
    bool report(double, std::string_view) override { return left_-- > 0; }

   private:
    int left_;
  };
  const MeshPointer mesh = test::control_mesh(test::torus_soup(8, 8));
  VertexLabels labels(mesh->vertex_count(), 0);
  labels[3] = 1;
  labels[4] = 1;
  int reports = 0;
  for (bool is_done = false; !is_done; ++reports) {
    StopAt stop(reports);
    const auto result = legalise_look_ahead(*mesh, labels, NonQuadRule::kWherePainted, stop);
    is_done = result.has_value();
    if (!is_done) {
      EXPECT_EQ(result.error().kind, ErrorKind::kCancelled);
    }
  }
  EXPECT_GT(reports, 1);
}

}  // namespace
}  // namespace limn
