#include "limn/document/history.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/document/commands.h"
#include "limn/mesh/bundled.h"
#include "ui/screen.h"

namespace limn::ui {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class HistorySection : public testing::Test {
 protected:
  HistorySection() {
    PanelLayout layout;
    layout.paint_open = layout.subdivide_open = layout.display_open = layout.numbers_open = false;
    layout.history_open = true;
    screen_.gui().set_layout(layout);
    document_ = make_document(load_bundled_mesh("cube").value(), "cube");
    screen_.model.history.steps = &history_;
  }
  void paint(std::uint32_t face, int depth) {
    history_.execute(
        document_, paint_command(plan_edits(document_.depths, {&face, 1}, DepthChange::set(depth)),
                                 "paint face " + std::to_string(face)));
  }

  Document document_;
  History history_;
  Screen screen_;
};

TEST_F(HistorySection, AnyStepCanBeGoneTo) {
  paint(0, 1);
  paint(1, 2);
  paint(2, 3);
  screen_.settle();
  static_cast<void>(screen_.take_actions());
  screen_.click("step 1");
  EXPECT_THAT(screen_.take_actions(), ElementsAre(Action(ActionId::kGoToStep, 1)));
  screen_.click("step 0");
  EXPECT_THAT(screen_.take_actions(), ElementsAre(Action(ActionId::kGoToStep, 0)));
  screen_.click("step 3");
  EXPECT_THAT(screen_.take_actions(), IsEmpty()) << "there already";
}

TEST_F(HistorySection, OnlyLinesThatShowAreMadeAndTheStepInForceIsAmongThem) {
  for (std::uint32_t i = 0; i < 500; ++i) {
    paint(i % 6, 1 + static_cast<int>(i % 2));
  }
  screen_.settle();
  EXPECT_TRUE(screen_.has("step 500"));
  EXPECT_FALSE(screen_.has("step 100"));
  history_.go_to(document_, 100);
  screen_.settle();
  EXPECT_TRUE(screen_.has("step 100"));
  EXPECT_FALSE(screen_.has("step 500"));
}

}  // namespace
}  // namespace limn::ui
