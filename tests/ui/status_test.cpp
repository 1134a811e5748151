// The status line's words, the legend, and figures that keep their width.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <cmath>

#include "ui/panels.h"
#include "ui/screen.h"
#include "ui/theme.h"

namespace limn::ui {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(StatusLine, SaysWhatTheMouseWillDo) {
  Screen screen;
  ViewportInput input;
  EXPECT_THAT(mouse_hint(screen.model, input), HasSubstr("Left drag: depth +1"));
  screen.model.brush.sets_depth = true;
  screen.model.brush.target_depth = 4;
  EXPECT_THAT(mouse_hint(screen.model, input), HasSubstr("set depth 4"));
  input.modifiers.shift = true;
  EXPECT_THAT(mouse_hint(screen.model, input), HasSubstr("depth −1"));
  input.modifiers = {.alt = true};
  EXPECT_THAT(mouse_hint(screen.model, input), HasSubstr("orbit"));
  EXPECT_THAT(mouse_hint(screen.model, input), Not(HasSubstr("depth")));
  input.modifiers = {};
  screen.model.brush.tool = Tool::kPick;
  EXPECT_THAT(mouse_hint(screen.model, input), HasSubstr("pick"));
  screen.model.brush.tool = Tool::kSplitEdge;
  EXPECT_THAT(mouse_hint(screen.model, input), HasSubstr("Point at an edge"));
  screen.model.hover_edge = EdgeHover{4, {12, 3400}};
  EXPECT_THAT(mouse_hint(screen.model, input), HasSubstr("Click: split edge 12 – 3,400"));
  screen.model.brush.tool = Tool::kFlipEdge;
  EXPECT_THAT(mouse_hint(screen.model, input), HasSubstr("Click: flip edge 12 – 3,400"));
  screen.model.brush.tool = Tool::kOrbit;
  EXPECT_THAT(mouse_hint(screen.model, input), HasSubstr("Left or middle drag: orbit"));
  input.owns_drag = true;
  screen.model.is_stroking = true;
  EXPECT_THAT(mouse_hint(screen.model, input), HasSubstr("Esc"));
}

TEST(StatusLine, NamesWhatEachPaintingToolDoes) {
  Screen screen;
  ViewportInput input;
  const auto hint = [&](Tool tool) {
    screen.model.brush.tool = tool;
    return mouse_hint(screen.model, input);
  };
  EXPECT_THAT(hint(Tool::kFill), HasSubstr("Click: fill this depth's region, depth +1"));
  EXPECT_THAT(hint(Tool::kSmartFill), HasSubstr("Click: fill up to the angle"));
  EXPECT_THAT(hint(Tool::kRectangle), HasSubstr("Left drag: rectangle, depth +1 · Shift: −1"));
  EXPECT_THAT(hint(Tool::kLasso), HasSubstr("Left drag: lasso"));
  EXPECT_THAT(hint(Tool::kLower), HasSubstr("Shift + click: line"));
  input.modifiers.shift = true;
  EXPECT_THAT(hint(Tool::kLower), HasSubstr("straight line from the last stroke, depth −1"));
  EXPECT_THAT(hint(Tool::kFill), HasSubstr("Shift + click: depth −1"));
  EXPECT_THAT(hint(Tool::kPaint), HasSubstr("Shift + left drag: depth −1"));
  screen.model.brush.shift_draws_lines = true;
  EXPECT_THAT(hint(Tool::kPaint), HasSubstr("straight line from the last stroke, depth +1"));
  input.modifiers = {};
  EXPECT_THAT(hint(Tool::kPaint), HasSubstr("Shift + click: line · Ctrl: −1"));
  input.owns_drag = true;
  screen.model.is_stroking = true;
  EXPECT_THAT(hint(Tool::kLasso), HasSubstr("Release: paint these faces · Esc"));
}

TEST(StatusLine, TellsWhatAClickCosts) {
  EXPECT_EQ(forecast_text({.faces = 4, .depth = 3, .amount = 1, .added_faces = 912}),
            "4 faces to depth 3: +912 faces");
  EXPECT_EQ(forecast_text({.faces = 1, .depth = 0, .amount = -1, .added_faces = -12345}),
            "1 face to depth 0: −12,345 faces");
  EXPECT_EQ(forecast_text({.faces = 1200, .depth = std::nullopt, .amount = 1, .added_faces = 1}),
            "1,200 faces by +1: +1 face");
  EXPECT_EQ(forecast_text({.faces = 2, .depth = std::nullopt, .amount = -1, .added_faces = 0}),
            "2 faces by −1: +0 faces");
  EXPECT_EQ(forecast_text({}), "no face changes");
}

TEST(Legend, IsDrawnAloneInItsCorner) {
  Screen screen;
  DepthCounts counts{};
  counts[0] = 5;
  screen.gui().frame_legend({counts, {}}, Theme::kLight, {640, 480});
  const ImDrawData& data = screen.gui().draw_data();
  ASSERT_EQ(data.CmdListsCount, 1);
  const ImDrawList& list = *data.CmdLists[0];
  ASSERT_GT(list.VtxBuffer.Size, 100);
  bool has_deepest = false;
  for (const ImDrawVert& vertex : list.VtxBuffer) {
    EXPECT_GE(vertex.pos.x, 15.0F);
    EXPECT_LE(vertex.pos.x, 200.0F);
    EXPECT_GE(vertex.pos.y, 200.0F);
    EXPECT_LE(vertex.pos.y, 465.0F);
    has_deepest = has_deepest || vertex.col == swatch_colour(7);
  }
  EXPECT_TRUE(has_deepest);
}

TEST(Fonts, AllFiguresAreAsWide) {
  for (const Scale scale : {Scale{}, Scale{1.25, 1.0}, Scale{1.0, 2.0}}) {
    Screen screen({1280, 800}, scale);
    for (ImFont* font : screen.gui().atlas().Fonts) {
      for (char digit = '1'; digit <= '9'; ++digit) {
        EXPECT_EQ(font->GetCharAdvance(static_cast<ImWchar>(digit)), font->GetCharAdvance('0'));
      }
    }
  }
}

TEST(StatusLine, LeavesOutWholePartsWhereThereIsNoRoom) {
  Screen screen({800, 600});
  screen.settle();
  std::string shown;
  for (const ItemRect& item : screen.gui().items()) {
    if (item.name.rfind("status: ", 0) == 0) {
      shown = item.name;
      EXPECT_LE(item.rect.origin.x + item.rect.size.width, 800.0);
    }
  }
  EXPECT_THAT(shown, HasSubstr("Left drag: depth +1 · Shift: −1"));
  EXPECT_THAT(shown, Not(HasSubstr("…")));
}

TEST(Legend, LiesFlatBesideTheAxesInASmallViewport) {
  Screen small({800, 600});
  small.settle();
  const WindowRect flat = small.rect("legend");
  EXPECT_LT(flat.size.height, 70.0);
  for (const ItemRect& item : small.gui().items()) {
    if (item.name.rfind("axis: ", 0) == 0) {
      EXPECT_GT(item.rect.origin.x, flat.origin.x + flat.size.width) << item.name;
    }
  }
  Screen large;
  large.settle();
  EXPECT_GT(large.rect("legend").size.height, large.rect("legend").size.width);
}

TEST(Fonts, DamagedFilesFallBackToTheBuiltInFont) {
  FontFiles files;
  files.regular.assign(5000, std::byte{0x5A});
  files.semi_bold.assign(3, std::byte{0});
  Screen screen({1280, 800}, {}, files);
  EXPECT_EQ(screen.gui().atlas().Fonts.Size, 4);
  screen.click("Raise all");
  EXPECT_EQ(screen.take_actions().size(), 1U);
}

double luminance(ImU32 colour) {
  const auto channel = [colour](unsigned shift) {
    const double c = static_cast<double>((colour >> shift) & 0xFFU) / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * channel(IM_COL32_R_SHIFT) + 0.7152 * channel(IM_COL32_G_SHIFT) +
         0.0722 * channel(IM_COL32_B_SHIFT);
}

double contrast(ImU32 a, ImU32 b) {
  const double la = luminance(a);
  const double lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

TEST(Themes, TextReadsOnEveryGround) {
  for (const Theme theme : {Theme::kDark, Theme::kLight}) {
    const ThemeColours& c = theme_colours(theme);
    for (const ImU32 ground : {c.panel, c.chrome, c.popup, c.field, c.control}) {
      EXPECT_GE(contrast(c.text, ground), 7.0);
    }
    for (const ImU32 ground : {c.panel, c.chrome, c.popup, c.field}) {
      EXPECT_GE(contrast(c.dim_text, ground), 4.5);
    }
    EXPECT_GE(contrast(c.on_accent, c.accent), 7.0);
    EXPECT_GE(contrast(c.problem, c.panel), 4.5);
  }
}

}  // namespace
}  // namespace limn::ui
