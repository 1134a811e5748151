#include "limn/document/refinement.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/document/commands.h"
#include "limn/document/history.h"
#include "limn/mesh/bundled.h"
#include "limn/subdivision/label_subdivision.h"
#include "limn/subdivision/labels.h"
#include "support/attribute_shapes.h"
#include "support/shapes.h"

namespace limn {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

DerivedLabels labels_of(const ControlMesh& mesh, std::span<const std::uint8_t> depths,
                        const SubdivisionSettings& settings = {}) {
  IgnoreProgress progress;
  return derive_labels(mesh, depths, settings, progress).value();
}

Refinement refinement_of(const ControlMesh& mesh, std::span<const std::uint8_t> depths,
                         const RefinementOptions& options = {}) {
  IgnoreProgress progress;
  const DerivedLabels labels = labels_of(mesh, depths, options.settings);
  return derive_refinement(mesh, labels, options, progress).value();
}

/// Stops at the n-th report, and checks that reports rise.
class StopAt final : public Progress {
 public:
  explicit StopAt(int reports) : left_(reports) {}
  [[nodiscard]] bool report(double fraction, std::string_view stage) override {
    EXPECT_GE(fraction, 0.0);
    EXPECT_LE(fraction, 1.0);
    EXPECT_FALSE(stage.empty());
    if (stage == stage_) {
      EXPECT_GE(fraction, fraction_);
    }
    stage_ = stage;
    fraction_ = fraction;
    return left_-- > 0;
  }

 private:
  int left_;
  std::string stage_;
  double fraction_ = 0.0;
};

TEST(DeriveLabels, CubeWithOneFacePaintedIsMendedByThreeRelabels) {
  const auto cube = test::cube();
  const std::vector<std::uint8_t> depths{5, 0, 0, 0, 0, 0};
  const DerivedLabels derived =
      labels_of(*cube, depths, {.legalisation = LegalisationMethod::kGreedy});
  EXPECT_EQ(derived.painted, vertex_labels(*cube, depths));
  EXPECT_EQ(derived.illegal_faces, illegal_faces(*cube, derived.painted));
  EXPECT_EQ(derived.illegal_faces.size(), 4U);
  EXPECT_EQ(derived.illegal_vertices.size(), 4U);
  EXPECT_EQ(derived.legal.steps.size(), 3U);
  EXPECT_EQ(derived.raised_vertices.size(), 3U);
  EXPECT_THAT(illegal_faces(*cube, derived.legal.labels), IsEmpty());
  EXPECT_EQ(derived.prediction.faces, 2484U);
  EXPECT_EQ(derived.prediction.vertices, 2486U);
  EXPECT_EQ(derived.prediction.levels, 5);
  EXPECT_EQ(derived.prediction.uniform_faces, 6U * 1024U);
}

TEST(DeriveLabels, CubeWithOneFacePaintedIsMendedByTwoRelabelsLookingAhead) {
  // Two opposite corners of the far face, which leaves it legal.
  const auto cube = test::cube();
  const std::vector<std::uint8_t> depths{5, 0, 0, 0, 0, 0};
  const DerivedLabels derived = labels_of(*cube, depths);
  EXPECT_EQ(derived.illegal_faces.size(), 4U);
  EXPECT_EQ(derived.raised_vertices.size(), 2U);
  EXPECT_THAT(illegal_faces(*cube, derived.legal.labels, LegalisationMethod::kLookAhead),
              IsEmpty());
  EXPECT_EQ(derived.prediction.faces, 2484U);
}

TEST(DeriveLabels, NothingPaintedNeedsNothing) {
  const auto cube = test::cube();
  const DerivedLabels derived = labels_of(*cube, std::vector<std::uint8_t>(6));
  EXPECT_THAT(derived.illegal_faces, IsEmpty());
  EXPECT_THAT(derived.legal.steps, IsEmpty());
  EXPECT_EQ(derived.prediction.faces, 6U);
  EXPECT_EQ(derived.prediction.levels, 0);
}

TEST(DeriveLabels, CountsVerticesThatAreRaisedAlongWithAChosenOne) {
  test::Random random(5);
  const auto mesh = test::control_mesh(test::with_mixed_faces(test::grid_soup(12, 12), random));
  std::size_t chosen = 0;
  std::size_t raised = 0;
  for (int round = 0; round < 20; ++round) {
    const DerivedLabels derived = labels_of(
        *mesh, test::random_depths(*mesh, 0.1, 2, random),
        {.non_quads = NonQuadRule::kWherePainted, .legalisation = LegalisationMethod::kGreedy});
    for (const LegalisationStep& step : derived.legal.steps) {
      EXPECT_THAT(derived.raised_vertices, ::testing::Contains(step.vertex));
    }
    for (const std::uint32_t vertex : derived.raised_vertices) {
      EXPECT_EQ(derived.painted[vertex], 0);
      EXPECT_GT(derived.legal.labels[vertex], 0);
    }
    chosen += derived.legal.steps.size();
    raised += derived.raised_vertices.size();
  }
  EXPECT_GT(chosen, 0U);
  EXPECT_GT(raised, chosen);
}

TEST(DeriveLabels, FollowsTheRuleForNonQuads) {
  const auto mixed = load_bundled_mesh("mixed").value().mesh;
  std::vector<std::uint8_t> depths(mixed->face_count());
  depths[0] = 2;
  const DerivedLabels uniform = labels_of(*mixed, depths);
  EXPECT_THAT(uniform.painted, ::testing::Each(::testing::Ge(1)));
  EXPECT_THAT(uniform.illegal_faces, IsEmpty());
  const DerivedLabels painted =
      labels_of(*mixed, depths, {.non_quads = NonQuadRule::kWherePainted});
  EXPECT_EQ(painted.painted,
            apply_non_quad_rule(*mixed, vertex_labels(*mixed, depths), NonQuadRule::kWherePainted));
  EXPECT_LT(painted.prediction.faces, uniform.prediction.faces);
}

TEST(DeriveRefinement, HoldsWhatWasPredicted) {
  test::Random random(5);
  for (const std::string_view name : {"cube", "mixed", "grid", "torus_open", "icosahedron"}) {
    const auto mesh = load_bundled_mesh(name).value().mesh;
    const auto depths = test::random_depths(*mesh, 0.2, 3, random);
    for (const int levels : {1, 2, kAllLevels}) {
      RefinementOptions options;
      options.levels = levels;
      const Refinement refinement = refinement_of(*mesh, depths, options);
      EXPECT_EQ(refinement.mesh->face_count(), refinement.prediction.faces);
      EXPECT_EQ(refinement.mesh->vertex_count(), refinement.prediction.vertices);
      EXPECT_LE(refinement.prediction.levels, levels);
      EXPECT_TRUE(refinement.cracks.is_watertight()) << name;
    }
  }
}

TEST(DeriveRefinement, OverBudgetIsRefusedAndTheBudgetItselfIsNot) {
  const auto cube = test::cube();
  const DerivedLabels labels = labels_of(*cube, std::vector<std::uint8_t>{3, 0, 0, 0, 0, 0});
  IgnoreProgress progress;
  RefinementOptions options;
  options.face_budget = labels.prediction.faces - 1;
  const auto refused = derive_refinement(*cube, labels, options, progress);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kOverBudget);
  EXPECT_THAT(refused.error().message, ::testing::HasSubstr("228"));
  options.face_budget = labels.prediction.faces;
  EXPECT_TRUE(derive_refinement(*cube, labels, options, progress));
}

TEST(DeriveRefinement, BytesAreForetoldToTheLastOne) {
  test::Random random(8);
  std::vector<test::NamedShape> shapes = test::textured_shapes();
  shapes.push_back({"mixed", load_bundled_mesh("mixed").value().mesh});
  shapes.push_back({"creature", load_bundled_mesh("creature").value().mesh});
  for (const auto& [name, mesh] : shapes) {
    for (const double painted : {0.0, 0.2, 1.0}) {
      const auto depths = test::random_depths(*mesh, painted, 3, random);
      const Refinement refinement = refinement_of(*mesh, depths);
      const RefinedMesh& refined = *refinement.mesh;
      const std::size_t sharp = refined.creases.size() * sizeof(RefinedCrease) +
                                refined.corners.size() * sizeof(RefinedCorner);
      EXPECT_EQ(refinement.prediction.bytes, refined.bytes() - sharp) << name;
    }
  }
}

TEST(DeriveRefinement, MoreMemoryThanAllowedIsRefusedBeforeAnyWork) {
  const auto cube = test::cube();
  const DerivedLabels labels = labels_of(*cube, std::vector<std::uint8_t>(6, 9));
  StopAt progress(0);  // Any work would be stopped.
  RefinementOptions options;
  options.memory_budget = labels.prediction.bytes - 1;
  const auto refused = derive_refinement(*cube, labels, options, progress);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kOverBudget);
  EXPECT_THAT(refused.error().message,
              ::testing::HasSubstr(std::to_string(labels.prediction.bytes)));
  EXPECT_THAT(refused.error().message, ::testing::HasSubstr("1572864 faces"));
  options.memory_budget = labels.prediction.bytes;
  const auto stopped = derive_refinement(*cube, labels, options, progress);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().kind, ErrorKind::kCancelled);
}

TEST(DeriveRefinement, StopsWhereverItIsTold) {
  const auto cube = test::cube();
  const DerivedLabels labels = labels_of(*cube, std::vector<std::uint8_t>{4, 0, 0, 0, 0, 0});
  int stopped = 0;
  for (int reports = 0; reports < 10000; ++reports) {
    StopAt progress(reports);
    const auto derived = derive_refinement(*cube, labels, {}, progress);
    if (derived) {
      break;
    }
    ASSERT_EQ(derived.error().kind, ErrorKind::kCancelled);
    ++stopped;
  }
  EXPECT_GT(stopped, 1);  // At least once while refining and once before the check.
  EXPECT_LT(stopped, 10000);
}

TEST(DeriveRefinement, PaintingAfterSubdividingRefinesTheControlMeshAgain) {
  const auto cube = test::cube();
  Document document = make_document({cube, {}}, "cube");
  History history;
  const auto paint = [&](std::uint32_t face, int depth) {
    const std::vector<std::uint32_t> faces{face};
    history.execute(
        document,
        paint_command(plan_edits(document.depths, faces, DepthChange::set(depth)), "paint"));
  };
  const auto refined = [&] {
    RefinementOptions options;
    options.levels = document.stage.levels;
    return refinement_of(*document.control, document.depths.values(), options);
  };
  paint(0, 5);
  history.execute(document, stage_command({true, kAllLevels}, "subdivide"));
  EXPECT_EQ(refined().mesh->face_count(), 2484U);
  const auto before = refined().mesh->positions;

  paint(0, 3);
  EXPECT_EQ(refined().mesh->face_count(), 228U);
  history.undo(document);
  EXPECT_EQ(refined().mesh->positions, before);
  EXPECT_EQ(document.control, cube);
}

TEST(DeriveRefinement, LoweringThreeToTwoGivesWhatPaintingTwoGives) {
  const auto mesh = load_bundled_mesh("grid").value().mesh;
  FaceDepths lowered(mesh->face_count());
  FaceDepths painted(mesh->face_count());
  for (const std::size_t face : {40U, 41U, 52U}) {
    lowered.set(face, 3);
    painted.set(face, 2);
  }
  const std::vector<std::uint32_t> faces{40, 41, 52};
  apply_edits(lowered, plan_edits(lowered, faces, DepthChange::add(-1)));
  EXPECT_EQ(labels_of(*mesh, lowered.values()).legal.labels,
            labels_of(*mesh, painted.values()).legal.labels);
  EXPECT_EQ(refinement_of(*mesh, lowered.values()).mesh->positions,
            refinement_of(*mesh, painted.values()).mesh->positions);
}

TEST(DeriveRefinement, RaisingTwiceOnAMixedMeshAddsTwoLevelsAndNoMore) {
  const auto mesh = load_bundled_mesh("mixed").value().mesh;
  FaceDepths depths(mesh->face_count());
  std::vector<std::uint32_t> all(mesh->face_count());
  for (std::uint32_t f = 0; f < all.size(); ++f) {
    all[f] = f;
  }
  std::vector<int> levels;
  for (int i = 0; i < 2; ++i) {
    apply_edits(depths, plan_edits(depths, all, DepthChange::add(1)));
    levels.push_back(labels_of(*mesh, depths.values()).prediction.levels);
  }
  // One more than painted, by the uniform first step; not one more for each time it is painted.
  EXPECT_THAT(levels, ElementsAre(2, 3));
}

TEST(RefinementSource, WritesOverWhatNobodyHolds) {
  const auto cube = test::cube();
  IgnoreProgress progress;
  RefinementSource source;
  DerivedLabels fine;
  fine.legal.labels.assign(8, 4);
  DerivedLabels coarse;
  coarse.legal.labels.assign(8, 2);
  std::shared_ptr<const RefinedMesh> first = source.derive(*cube, fine, {}, progress).value().mesh;
  const glm::vec3* const memory = first->positions.data();
  const std::vector<glm::vec3> before(first->positions.begin(), first->positions.end());
  const std::shared_ptr<const RefinedMesh> second =
      source.derive(*cube, coarse, {}, progress).value().mesh;
  EXPECT_NE(second->positions.data(), memory);  // The first is still looked at.
  EXPECT_TRUE(std::ranges::equal(first->positions, before));
  first.reset();
  const std::shared_ptr<const RefinedMesh> third =
      source.derive(*cube, fine, {}, progress).value().mesh;
  EXPECT_EQ(third->positions.data(), memory);
  EXPECT_TRUE(std::ranges::equal(third->positions, before));
  EXPECT_EQ(second->quads.size(), 96u);
}

TEST(AdaptiveLoop, IsDerivedFromThePainting) {
  const std::shared_ptr<const ControlMesh> mesh = load_bundled_mesh("icosahedron")->mesh;
  SubdivisionSettings settings;
  settings.scheme = RefinementScheme::kLoop;
  IgnoreProgress progress;
  std::vector<std::uint8_t> depths(mesh->face_count(), 0);
  depths[0] = 3;
  const DerivedLabels labels = derive_labels(*mesh, depths, settings, progress).value();
  EXPECT_TRUE(labels.illegal_faces.empty());
  EXPECT_EQ(labels.face_depths[0], 3);
  // Three beside it to 2, and the six beside those to 1.
  EXPECT_EQ(labels.deepened_faces, 9u);
  EXPECT_EQ(labels.prediction.levels, 3);
  EXPECT_EQ(labels.prediction.uniform_faces, 20u * 64);
  for (const int levels : {1, 2, kAllLevels}) {
    const Refinement refinement =
        derive_refinement(*mesh, labels, {settings, levels}, progress).value();
    EXPECT_TRUE(refinement.cracks.is_watertight());
    EXPECT_EQ(refinement.prediction.faces, refinement.mesh->face_count());
    EXPECT_EQ(refinement.prediction.vertices, refinement.mesh->vertex_count());
    EXPECT_EQ(refinement.prediction.levels, std::min(levels, 3));
    EXPECT_EQ(predict_derived(*mesh, labels, levels).faces, refinement.mesh->face_count());
  }
  settings.weights = LoopWeights::kWarren;
  const auto other = derive_refinement(*mesh, labels, {settings}, progress).value().mesh;
  const auto original = derive_refinement(*mesh, labels, {}, progress).value().mesh;
  EXPECT_FALSE(std::ranges::equal(other->positions, original->positions));
}

TEST(AdaptiveLoop, RefusesFacesThatAreNoTriangles) {
  SubdivisionSettings settings;
  settings.scheme = RefinementScheme::kLoop;
  IgnoreProgress progress;
  const auto labels =
      derive_labels(*test::cube(), std::vector<std::uint8_t>(6, 1), settings, progress);
  ASSERT_FALSE(labels);
  EXPECT_EQ(labels.error().kind, ErrorKind::kFailed);
  EXPECT_NE(labels.error().message.find("Triangulate"), std::string::npos);
}

}  // namespace
}  // namespace limn
