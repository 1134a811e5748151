// The panel of the painting tools: each shows what it can be set to, and nothing else.
#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ui/availability.h"
#include "ui/screen.h"

namespace limn::ui {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

bool shows(Screen& screen, std::string_view name) {
  screen.settle();
  return std::ranges::any_of(screen.gui().items(),
                             [&](const ItemRect& item) { return item.name == name; });
}

TEST(PaintSection, ShowsWhatTheToolCanBeSetTo) {
  struct Options {
    Tool tool;
    bool radius;
    bool angle;
    bool through;
    bool line;
  };
  constexpr Options kOptions[] = {
      {Tool::kPaint, true, false, true, true},       {Tool::kLower, true, false, true, false},
      {Tool::kFill, false, false, false, false},     {Tool::kSmartFill, false, true, false, false},
      {Tool::kRectangle, false, false, true, false}, {Tool::kLasso, false, false, true, false}};
  Screen screen;
  for (const Options& options : kOptions) {
    screen.model.brush.tool = options.tool;
    EXPECT_EQ(shows(screen, "Brush radius"), options.radius);
    EXPECT_EQ(shows(screen, "Fill angle"), options.angle);
    EXPECT_EQ(shows(screen, "Paint through"), options.through);
    EXPECT_EQ(shows(screen, "Line with Shift"), options.line);
    for (const char* always : {"Mirror X", "Mirror Y", "Mirror Z", "Raise all", "depth 3"}) {
      EXPECT_TRUE(shows(screen, always)) << always;
    }
  }
}

TEST(PaintSection, TheAxesAreTurnedOnAndOff) {
  Screen screen;
  screen.click("Mirror Y");
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kToggleMirrorY, true)));
  screen.model.brush.mirror.y = true;
  screen.click("Mirror Y");
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kToggleMirrorY, false)));
  screen.click("Paint through");
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kTogglePaintThrough, true)));
}

TEST(PaintSection, WhatNeedsAPaintingIsDimmedWithoutOne) {
  Screen screen;
  for (const char* rule : {"Grow", "Shrink", "Even out", "Invert", "Mirror painting"}) {
    screen.click(rule);
  }
  EXPECT_THAT(screen.take_actions(), IsEmpty());
  screen.model.depth_counts[2] = 4;
  for (const char* rule : {"Grow", "Shrink", "Even out", "Invert", "Mirror painting"}) {
    screen.click(rule);
  }
  EXPECT_THAT(screen.take_actions(),
              ElementsAre(Action(ActionId::kGrowPainting), Action(ActionId::kShrinkPainting),
                          Action(ActionId::kSmoothPainting), Action(ActionId::kInvertPainting)));
  screen.model.brush.mirror.x = true;
  screen.click("Mirror painting");
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kMirrorPainting)));
}

TEST(PaintSection, SaysWhyFineIsNotToBeHad) {
  Screen screen;
  screen.model.brush.is_fine = true;
  screen.model.depth_counts = {3, 3};
  EXPECT_EQ(why_not_fine(screen.model), "");
  screen.settle();
  screen.click("Fine");
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kToggleFine, false)));
  screen.document.settings.scheme = RefinementScheme::kLoop;
  screen.settle();
  screen.click("Fine");
  EXPECT_THAT(screen.take_actions(), IsEmpty());
  EXPECT_FALSE(is_available(screen.model, ActionId::kClearFine));
  EXPECT_THAT(std::string(why_not_fine(screen.model)), testing::HasSubstr("Loop's scheme"));
  screen.document.settings.scheme = RefinementScheme::kCatmullClark;
  screen.document.demands = FineDemands(std::vector<FineDemand>{{{0, 0, 1, 0, 0}, 2}});
  EXPECT_TRUE(is_available(screen.model, ActionId::kClearFine));
  EXPECT_EQ(painted_counts(screen.model), (DepthCounts{3, 3, 1}));
}

TEST(ToolStrip, AllToolsFitAboveEachOtherInALowWindow) {
  for (const WindowSize size : {WindowSize{800, 600}, WindowSize{1280, 800}}) {
    Screen screen(size);
    screen.settle();
    double below = 0.0;
    std::size_t tools = 0;
    for (const ItemRect& item : screen.gui().items()) {
      if (item.name.starts_with("tool: ")) {
        EXPECT_GE(item.rect.origin.y, below) << item.name;
        below = item.rect.origin.y + item.rect.size.height;
        EXPECT_LE(below, size.height - 26.0) << item.name;
        EXPECT_GE(item.rect.size.height, 28.0);
        ++tools;
      }
    }
    EXPECT_EQ(tools, 15U);
  }
}

}  // namespace
}  // namespace limn::ui
