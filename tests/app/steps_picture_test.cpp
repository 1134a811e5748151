// What is to be seen of a legalisation: candidates with their keys, the picked one, what is raised.
// Drawn with ImGui's own font, so that they are the same bytes on every machine.
#include <vector>

#include <gtest/gtest.h>

#include "app/desk.h"
#include "support/image_compare.h"

namespace limn::app {
namespace {

using enum ui::ActionId;

class StepsPicture : public testing::Test {
 protected:
  StepsPicture() {
    ui::PanelLayout layout;
    layout.paint_open = layout.subdivide_open = layout.display_open = layout.numbers_open = false;
    layout.steps_open = true;
    desk_.gui().set_layout(layout);
    session_.perform({kOpenBundled, std::string("grid")});
    session_.perform(kLegaliseGreedy);
    session_.begin_stroke(DepthChange::set(2));
    session_.touch(std::vector<std::uint32_t>{78, 91, 103, 104, 105, 106});
    session_.end_stroke();
    session_.finish_refinement();
  }

  Desk desk_{{1100, 760}};
  Session& session_ = desk_.session();
};

TEST_F(StepsPicture, GreedyInTheMiddle) {
  session_.perform(kToggleSteps);
  for (int i = 0; i < 4; ++i) {
    session_.perform(kStepNext);
  }
  const render::Image picture = desk_.picture();
  EXPECT_TRUE(test::matches_golden(desk_.viewport_of(picture), "steps_greedy"));
  EXPECT_TRUE(test::matches_golden(desk_.panel_of(picture), "steps_panel_greedy"));
}

TEST_F(StepsPicture, LookAheadAtTheBeginningLight) {
  session_.perform(kLegaliseLookAhead);
  session_.perform(kThemeLight);
  session_.finish_refinement();
  session_.perform(kToggleSteps);
  const render::Image picture = desk_.picture();
  EXPECT_TRUE(test::matches_golden(desk_.viewport_of(picture), "steps_look_ahead_light"));
  EXPECT_TRUE(test::matches_golden(desk_.panel_of(picture), "steps_panel_look_ahead_light"));
}

TEST_F(StepsPicture, AfterTheLast) {
  session_.perform(kToggleSteps);
  session_.perform(kStepLast);
  EXPECT_TRUE(test::matches_golden(desk_.viewport_of(desk_.picture()), "steps_after"));
}

}  // namespace
}  // namespace limn::app
