// Legalisation played in a session: to and fro, and over what is painted meanwhile.
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "app/session.h"
#include "render/camera.h"

namespace limn::app {
namespace {

using enum ui::ActionId;
using testing::IsEmpty;

class Steps : public testing::Test {
 protected:
  Steps() {
    session_.perform({kOpenBundled, std::string("cube")});
    session_.perform(kLegaliseGreedy);
    paint(3, 2);
  }

  void paint(std::uint32_t face, int depth) {
    session_.begin_stroke(DepthChange::set(depth));
    session_.touch(std::vector<std::uint32_t>{face});
    session_.end_stroke();
    session_.finish_refinement();
  }
  [[nodiscard]] ui::StepperStatus steps() const { return session_.model().steps; }

  Session session_{{[] {}, {}}};
};

TEST_F(Steps, ACubeWithOnePaintedFaceTakesThreeSteps) {
  EXPECT_FALSE(steps().is_shown);
  session_.perform(kToggleSteps);
  ASSERT_TRUE(steps().has_trace);
  EXPECT_EQ(steps().position, 0U);
  EXPECT_EQ(steps().size, 3U);
  EXPECT_EQ(steps().illegal_faces, 4U);
  EXPECT_EQ(steps().illegal_vertices, 4U);
  EXPECT_EQ(steps().candidates.size(), 4U);
  for (std::size_t step = 1; step <= 3; ++step) {
    session_.perform(kStepNext);
    EXPECT_EQ(steps().position, step);
    EXPECT_EQ(steps().raised, step);
  }
  EXPECT_EQ(steps().illegal_faces, 0U);
  EXPECT_THAT(steps().candidates, IsEmpty());
  EXPECT_EQ(session_.steps().labels(), session_.refinement().labels()->legal.labels);
  session_.perform(kStepNext);
  EXPECT_EQ(steps().position, 3U) << "there is no step after the last";
  session_.perform(kStepPrevious);
  EXPECT_EQ(steps().position, 2U);
  session_.perform(kStepFirst);
  EXPECT_EQ(steps().illegal_faces, 4U);
  session_.perform(kStepLast);
  EXPECT_EQ(steps().position, 3U);
}

TEST_F(Steps, TheyChangeNothing) {
  session_.perform(kToggleSteps);
  const auto undo = session_.history().undo_name();
  const Revisions before = session_.document().revisions;
  session_.perform(kStepNext);
  session_.perform(kStepLast);
  EXPECT_EQ(session_.history().undo_name(), undo);
  EXPECT_EQ(session_.document().revisions.depths, before.depths);
  EXPECT_EQ(session_.document().revisions.stage, before.stage);
}

TEST_F(Steps, TheControlMeshShowsWhileTheyDo) {
  session_.perform(kSubdivide);
  session_.finish_refinement();
  ASSERT_TRUE(session_.shows_refined());
  session_.perform(kToggleSteps);
  EXPECT_FALSE(session_.shows_refined());
  session_.perform(kCancel);
  EXPECT_FALSE(steps().is_shown) << "Esc leaves them";
  EXPECT_TRUE(session_.shows_refined());
}

TEST_F(Steps, PaintingBeginsAnewWithTheLabelsOfNow) {
  session_.perform(kToggleSteps);
  session_.perform(kStepNext);
  const std::uint64_t before = session_.steps().revision();
  paint(2, 2);  // The face opposite: every label is positive.
  EXPECT_NE(session_.steps().revision(), before);
  EXPECT_EQ(steps().position, 0U);
  EXPECT_EQ(steps().size, 0U) << "nothing is illegal";
  session_.perform(kUndo);
  session_.finish_refinement();
  EXPECT_EQ(steps().size, 3U);
}

TEST_F(Steps, LookingAheadTellsScores) {
  session_.perform(kLegaliseLookAhead);
  session_.finish_refinement();
  session_.perform(kToggleSteps);
  ASSERT_TRUE(steps().has_trace);
  EXPECT_GT(steps().size, 0U);
  if (steps().order == LegalisationMethod::kLookAhead) {
    EXPECT_NE(steps().candidates.front().score, 0.0F);
  }
  session_.perform(kStepLast);
  EXPECT_EQ(steps().illegal_faces, 0U);
}

TEST_F(Steps, AnotherMeshIsFollowedToo) {
  session_.perform(kToggleSteps);
  session_.perform({kOpenBundled, std::string("creature")});
  session_.perform(kDiscardChanges);
  session_.finish_refinement();
  EXPECT_EQ(steps().size, 0U);
  paint(10, 1);
  EXPECT_GT(steps().size, 0U);
}

TEST_F(Steps, TheCameraGoesToTheVertexThatIsPicked) {
  session_.perform(kToggleSteps);
  session_.update(1.0);
  for (std::size_t step = 0; step < 3; ++step) {
    session_.perform(kFrameStep);
    session_.update(10.0 + static_cast<double>(step));
    session_.update(10.5 + static_cast<double>(step));
    const glm::dvec3 picked =
        session_.document().control->positions()[steps().candidates.front().vertex];
    const render::Camera camera =
        render::make_camera(session_.view(), session_.document().control->bounds(), {600, 400});
    EXPECT_GT(glm::dot(camera.back, picked), 0.5) << "its side of the cube faces the eye";
    const auto shown = render::project(camera, picked);
    ASSERT_TRUE(shown);
    EXPECT_NEAR(shown->point.x, 300.0, 150.0);
    EXPECT_NEAR(shown->point.y, 200.0, 150.0);
    session_.perform(kStepNext);
  }
}

TEST_F(Steps, TheFirstPressOfNextShowsWhereItBegins) {
  session_.perform(kStepNext);
  EXPECT_TRUE(steps().is_shown);
  EXPECT_EQ(steps().position, 0U);
}

}  // namespace
}  // namespace limn::app
