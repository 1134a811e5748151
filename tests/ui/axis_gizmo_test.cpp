// The axes in the corner of the viewport, clicked where they are drawn.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

#include "ui/screen.h"

namespace limn::ui {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(AxisGizmo, EveryEndLooksFromThere) {
  Screen screen;
  screen.model.view.yaw = 30.0;
  screen.model.view.pitch = 25.0;
  const std::pair<const char*, ActionId> ends[] = {
      {"axis: Right view", ActionId::kViewRight}, {"axis: Left view", ActionId::kViewLeft},
      {"axis: Top view", ActionId::kViewTop},     {"axis: Bottom view", ActionId::kViewBottom},
      {"axis: Front view", ActionId::kViewFront}, {"axis: Back view", ActionId::kViewBack}};
  for (const auto& [name, id] : ends) {
    screen.click(name);
    EXPECT_THAT(screen.take_actions(), ElementsAre(Action(id))) << name;
  }
}

TEST(AxisGizmo, EndsLieWhereTheirAxesPoint) {
  Screen screen;
  screen.model.view = {};  // The front view.
  screen.settle();
  const WindowPoint centre = screen.middle("axis: Front view");
  EXPECT_GT(screen.middle("axis: Right view").x, centre.x + 20.0);
  EXPECT_LT(screen.middle("axis: Left view").x, centre.x - 20.0);
  EXPECT_LT(screen.middle("axis: Top view").y, centre.y - 20.0);
  EXPECT_GT(screen.middle("axis: Bottom view").y, centre.y + 20.0);
  // The end towards the viewer lies over the other one.
  screen.click(centre);
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kViewFront)));
  screen.model.view.yaw = 180.0;
  screen.click(centre);
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kViewBack)));
}

TEST(AxisGizmo, BetweenTheEndsTheViewportHasTheMouse) {
  Screen screen;
  screen.model.view = {};
  screen.settle();
  const WindowPoint right = screen.middle("axis: Right view");
  const WindowPoint top = screen.middle("axis: Top view");
  screen.move({right.x, top.y});
  screen.settle();
  screen.button(MouseButton::kLeft, true);
  EXPECT_TRUE(screen.frame().viewport_input.owns_drag);
  EXPECT_THAT(screen.take_actions(), IsEmpty());
}

TEST(AxisGizmo, APressOnAnEndIsNoStroke) {
  Screen screen;
  screen.model.view = {};
  screen.settle();
  screen.move(screen.middle("axis: Right view"));
  screen.settle();
  EXPECT_FALSE(screen.last().viewport_input.is_hovered);
  screen.button(MouseButton::kLeft, true);
  EXPECT_FALSE(screen.frame().viewport_input.owns_drag);
  screen.button(MouseButton::kLeft, false);
}

TEST(AxisGizmo, ADragOfTheViewportPassesOverIt) {
  Screen screen;
  screen.model.view = {};
  screen.settle();
  screen.move({500, 300});
  screen.settle();
  screen.button(MouseButton::kLeft, true);
  screen.settle();
  screen.move(screen.middle("axis: Right view"));
  screen.button(MouseButton::kLeft, false);
  screen.settle();
  EXPECT_THAT(screen.take_actions(), IsEmpty());
}

}  // namespace
}  // namespace limn::ui
