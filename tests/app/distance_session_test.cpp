// The distance from the limit surface: measured when asked for, and while it colours the faces.
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session.h"
#include "limn/subdivision/label_subdivision.h"

namespace limn::app {
namespace {

using enum ui::ActionId;

class DistanceSession : public testing::Test {
 protected:
  DistanceSession() { session_.perform({kOpenBundled, std::string("cube")}); }

  void paint(int depth) {
    session_.begin_stroke(DepthChange::set(depth));
    session_.touch(std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5});
    session_.end_stroke();
    session_.finish_refinement();
  }
  [[nodiscard]] ui::DistanceStatus status() const { return session_.model().distance; }

  Session session_{{[] {}, {}}};
};

TEST_F(DistanceSession, IsMeasuredOnceWhenAsked) {
  paint(2);
  EXPECT_TRUE(status().can_measure);
  EXPECT_FALSE(status().figures);
  session_.perform(kMeasureDistance);
  session_.finish_refinement();
  ASSERT_TRUE(status().figures) << status().problem;

  const ControlMesh& cube = *session_.document().control;
  IgnoreProgress nobody;
  const VertexLabels labels(cube.vertex_count(), 2);
  const RefinedMesh refined = refine(cube, labels, {}, {}, nobody).value();
  const LimitDistance expected = measure_limit_distance(cube, labels, {}, refined, nobody).value();
  EXPECT_EQ(status().figures->greatest(), expected.greatest());
  EXPECT_EQ(status().figures->root_mean_square(), expected.root_mean_square());
  EXPECT_EQ(status().figures->diagonal, cube.bounds().diagonal());

  paint(3);
  EXPECT_FALSE(status().figures) << "these were another mesh's";
  EXPECT_FALSE(session_.distance().is_busy()) << "nobody has asked again";
}

TEST_F(DistanceSession, IsKeptUpWhileItColoursTheFaces) {
  session_.perform(kTintDistance);
  EXPECT_EQ(session_.display().tint, ui::Tint::kDistance);
  session_.finish_refinement();
  ASSERT_TRUE(status().figures) << "the control mesh is shown as yet";
  const ControlMesh* control = session_.document().control.get();
  ASSERT_NE(session_.distance().distance(control), nullptr);
  EXPECT_EQ(session_.distance().distance(control)->of_faces.size(), control->face_count());
  EXPECT_NEAR(status().figures->greatest(), 0.25 * control->bounds().diagonal(), 1e-6)
      << "a cube's corners";
  paint(2);
  EXPECT_EQ(session_.distance().distance(control), nullptr);
  ASSERT_TRUE(status().figures);
  const double before = status().figures->greatest();
  paint(3);
  ASSERT_TRUE(status().figures);
  EXPECT_LT(status().figures->greatest(), 0.5 * before);
  const RefinedMesh* mesh = session_.refinement().refined()->mesh.get();
  ASSERT_NE(session_.distance().distance(mesh), nullptr);
  EXPECT_EQ(session_.distance().distance(mesh)->of_faces.size(), mesh->face_count());
  session_.perform(kShowControl);
  session_.finish_refinement();
  ASSERT_TRUE(status().figures);
  EXPECT_GT(status().figures->greatest(), before);
  session_.perform(kShowRefined);
  session_.finish_refinement();
  EXPECT_LT(status().figures->greatest(), before);
}

TEST_F(DistanceSession, StopsWhenCancelled) {
  session_.perform(kTintDistance);
  session_.begin_stroke(DepthChange::set(4));
  session_.touch(std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5});
  session_.end_stroke();
  while (!session_.distance().is_busy()) {
    session_.update(0.0);
  }
  session_.perform(kCancel);
  EXPECT_FALSE(session_.distance().is_busy());
  session_.finish_refinement();
  EXPECT_FALSE(status().figures);
  EXPECT_FALSE(status().problem.empty());
  session_.perform(kMeasureDistance);
  session_.finish_refinement();
  EXPECT_TRUE(status().figures);
}

TEST_F(DistanceSession, IsOfWhatIsPaintedByCatmullClarkAlone) {
  session_.perform({kOpenBundled, std::string("icosahedron")});
  session_.perform(kAdaptiveLoop);
  session_.perform(kMeasureDistance);
  EXPECT_FALSE(session_.distance().is_busy());
  ASSERT_FALSE(session_.toasts().empty());
  EXPECT_THAT(session_.toasts().back().text, testing::HasSubstr("Catmull-Clark"));
  session_.perform(kRaiseAll);
  session_.finish_refinement();
  EXPECT_FALSE(status().can_measure);
}

}  // namespace
}  // namespace limn::app
