// The card with the first things to know, and what panels say while there is nothing to show.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/document/history.h"
#include "ui/screen.h"

namespace limn::ui {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

bool is_inside(const WindowRect& inner, const WindowRect& outer) {
  return inner.origin.x >= outer.origin.x && inner.origin.y >= outer.origin.y &&
         inner.origin.x + inner.size.width <= outer.origin.x + outer.size.width &&
         inner.origin.y + inner.size.height <= outer.origin.y + outer.size.height;
}

TEST(HintCard, IsThereOnlyWhereItIsWanted) {
  Screen screen;
  screen.settle();
  EXPECT_FALSE(screen.has("hints"));
  screen.model.hints = HintCard{};
  screen.settle();
  EXPECT_TRUE(screen.has("hints"));
}

TEST(HintCard, ItsButtonClosesItAndPaintsNothing) {
  Screen screen;
  screen.model.hints = HintCard{};
  screen.settle();
  screen.move(screen.middle("Got it"));
  screen.settle();
  EXPECT_FALSE(screen.last().viewport_input.is_hovered);
  screen.click("Got it");
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kToggleHints, false)));
}

TEST(HintCard, WhatLiesBeneathTheRestCanBePainted) {
  Screen screen;
  screen.model.hints = HintCard{};
  screen.settle();
  const WindowRect card = screen.rect("hints");
  screen.move({card.origin.x + 20.0, card.origin.y + 20.0});
  screen.settle();
  EXPECT_TRUE(screen.last().viewport_input.is_hovered);
}

TEST(HintCard, FitsIntoTheSmallestWindowWhateverTheKeys) {
  for (const NavigationPreset preset :
       {NavigationPreset::kOriginal, NavigationPreset::kMouseOnly, NavigationPreset::kClassroom}) {
    Screen screen({800, 600});
    screen.model.hints = HintCard{};
    screen.model.navigation.preset = preset;
    screen.model.brush.tool = Tool::kOrbit;
    screen.settle();
    EXPECT_TRUE(is_inside(screen.rect("hints"), screen.last().viewport));
    EXPECT_TRUE(is_inside(screen.rect("Got it"), screen.rect("hints")));
  }
}

TEST(HintCard, ToastsLeaveItReadable) {
  Screen screen({800, 600});
  screen.model.hints = HintCard{true, false};
  screen.toasts = {{Toast::Kind::kDone, "Raise all: 476 faces changed."}};
  screen.settle();
  const WindowRect card = screen.rect("hints");
  EXPECT_GE(screen.rect("toast: Raise all: 476 faces changed.").origin.y,
            card.origin.y + card.size.height);
}

TEST(Toasts, ALongOneTakesMoreLinesAndStaysInTheViewport) {
  Screen screen({800, 600});
  const std::string text =
      "The window system keeps Alt and drag for itself. Orbit with the middle button, or with the "
      "orbit tool (V).";
  screen.toasts = {{Toast::Kind::kNote, "Short."}, {Toast::Kind::kNote, text}};
  screen.settle();
  const WindowRect place = screen.rect("toast: " + text);
  EXPECT_TRUE(is_inside(place, screen.last().viewport));
  EXPECT_GT(place.size.height, screen.rect("toast: Short.").size.height);
}

TEST(EmptyStates, SayWhatWouldFillThem) {
  Screen screen;
  PanelLayout layout;
  layout.paint_open = layout.subdivide_open = layout.display_open = layout.numbers_open = false;
  layout.history_open = true;
  screen.gui().set_layout(layout);
  const History history;
  screen.model.history.steps = &history;
  screen.settle();
  EXPECT_TRUE(screen.has("Nothing was changed yet. What you do is listed here."));
  screen.click("menu: File");
  screen.click("menu: Open recent");
  EXPECT_TRUE(screen.has("no recent files"));
}

TEST(Gui, RestsWithEverySectionOpenHoweverFarItReaches) {
  Screen screen({800, 600});
  PanelLayout layout;
  layout.steps_open = layout.schemes_open = layout.history_open = true;
  screen.gui().set_layout(layout);
  const History history;
  screen.model.history.steps = &history;
  screen.settle();
  EXPECT_FALSE(screen.frame().needs_another_frame);
}

TEST(CopyStatus, IsToldBesideTheNameWithoutMovingIt) {
  Screen screen;
  screen.model.is_modified = true;
  screen.settle();
  EXPECT_FALSE(screen.has("copy status"));
  screen.model.copies.when = "14:05";
  screen.settle();
  const WindowRect kept = screen.rect("copy status");
  EXPECT_LT(kept.origin.x + kept.size.width, static_cast<double>(screen.window.width));
  screen.model.copies = {{}, "The disk is full."};
  screen.settle();
  const WindowRect failed = screen.rect("copy status");
  EXPECT_NEAR(failed.origin.x + failed.size.width, kept.origin.x + kept.size.width, 1.0);
  EXPECT_THAT(screen.take_actions(), IsEmpty());
}

}  // namespace
}  // namespace limn::ui
