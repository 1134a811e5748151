// Plays the mouse with each painting tool, frame by frame, over a picker that knows where the faces
// of a cube are: side by side, strips of 100 pixels.
#include "app/paint_tools/paint_tools.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session.h"
#include "app/viewport_controller.h"
#include "app/viewport_mouse.h"
#include "limn/document/refinement.h"
#include "limn/progress.h"

namespace limn::app {
namespace {

using enum ui::ActionId;
using testing::Each;
using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::IsEmpty;
using testing::UnorderedElementsAre;
using ui::MouseButton;

constexpr render::FramebufferSize kPixels{600, 400};

class StripCubePicker final : public ViewportPicker {
 public:
  explicit StripCubePicker(const Session& session) : session_(session) {}

  [[nodiscard]] std::optional<render::PickedFace> pick(render::FramebufferPoint point) override {
    if (point.x < 0.0 || point.x >= 600.0) {
      return std::nullopt;
    }
    const render::Camera camera =
        render::make_camera(session_.view(), session_.document().control->bounds(), kPixels);
    render::PickedFace face;
    face.control_face = static_cast<std::uint32_t>(point.x / 100.0);
    face.view_depth = camera.target_depth;
    face.position = render::world_at(camera, point, face.view_depth);
    return face;
  }
  [[nodiscard]] std::vector<std::uint32_t> faces_in(const render::ScreenRegion& region,
                                                    Reach reach) override {
    last_reach = reach;
    last_region = region;
    std::vector<std::uint32_t> faces;
    for (std::uint32_t face = 0; face < 6; ++face) {
      const double x = 100.0 * face;
      const std::vector<glm::dvec2> strip{{x, 0}, {x + 99.9, 0}, {x + 99.9, 400}, {x, 400}};
      if (region.meets(strip)) {
        faces.push_back(face);
      }
    }
    return faces;
  }

  Reach last_reach = Reach::kVisible;
  std::optional<render::ScreenRegion> last_region;

 private:
  const Session& session_;
};

class PaintToolsTest : public testing::Test, protected ViewportMouse {
 protected:
  PaintToolsTest() {
    session_.perform({kOpenBundled, std::string("cube")});
    session_.perform({kSetBrushRadius, 4.0});
  }

  void frame(const ui::ViewportInput& input) override {
    controller_.update(input, place_, session_, picker_);
  }
  void move(double x, double y = 220.0) { move_along({{x, y}}); }
  void press() { change(MouseButton::kLeft, true); }
  void release() { change(MouseButton::kLeft, false); }
  void click(double x) {
    move(x);
    press();
    release();
  }
  void lose_focus() {
    held_ = {};
    frame(held_);
  }

  [[nodiscard]] std::vector<int> depths() const {
    const auto values = session_.document().depths.values();
    return {values.begin(), values.end()};
  }
  [[nodiscard]] std::string undo_name() const { return session_.history().undo_name(); }
  [[nodiscard]] std::vector<std::uint32_t> lit() const {
    return {controller_.highlighted().begin(), controller_.highlighted().end()};
  }
  /// Faces that the painting as it is refines to.
  [[nodiscard]] std::int64_t faces_to_come() const {
    const Document& document = session_.document();
    IgnoreProgress progress;
    const auto labels =
        derive_labels(*document.control, document.depths.values(), document.settings, progress);
    return static_cast<std::int64_t>(labels.value().prediction.faces);
  }

  ViewportPlace place_{{{0.0, 0.0}, {600.0, 400.0}}, kPixels};
  Session session_{{[] {}, {}}};
  StripCubePicker picker_{session_};
  ViewportController controller_;
};

TEST_F(PaintToolsTest, FillTakesTheRegionOfEqualDepthInOneCommand) {
  session_.perform({kSetTargetDepth, 3});
  click(50);
  EXPECT_THAT(depths(), ElementsAre(3, 0, 0, 0, 0, 0));
  session_.perform(kToolFill);
  session_.perform(kBrushAdds);
  move(150);
  EXPECT_THAT(lit(), UnorderedElementsAre(1, 2, 3, 4, 5)) << "what a click would fill lights up";
  press();
  EXPECT_THAT(depths(), ElementsAre(3, 1, 1, 1, 1, 1)) << "as soon as the button is down";
  move(450);
  release();
  EXPECT_THAT(depths(), ElementsAre(3, 1, 1, 1, 1, 1));
  EXPECT_EQ(undo_name(), "fill 5 faces");
  held_.modifiers.shift = true;
  click(250);
  EXPECT_THAT(depths(), ElementsAre(3, 0, 0, 0, 0, 0)) << "Shift lowers";
  session_.perform(kUndo);
  session_.perform(kUndo);
  EXPECT_THAT(depths(), ElementsAre(3, 0, 0, 0, 0, 0));
}

TEST_F(PaintToolsTest, SmartFillStopsAtTheAngle) {
  session_.perform(kToolSmartFill);
  session_.perform({kSetFillAngle, 89.0});
  click(50);
  EXPECT_THAT(depths(), ElementsAre(1, 0, 0, 0, 0, 0));
  EXPECT_EQ(undo_name(), "smart fill 1 face");
  session_.perform({kSetFillAngle, 90.0});
  held_.modifiers.ctrl = false;
  click(50);
  EXPECT_EQ(std::ranges::count(depths(), 0), 1) << "but the face opposite";
  EXPECT_EQ(depths()[0], 2);
  session_.perform({kSetFillAngle, 1e9});
  EXPECT_EQ(session_.brush().fill_angle, 360.0);
}

TEST_F(PaintToolsTest, WheelAndKeysWidenTheAngleInPlaceOfTheBrush) {
  session_.perform(kToolSmartFill);
  session_.perform({kSetFillAngle, 85.0});
  move(50);
  EXPECT_THAT(lit(), ElementsAre(0));
  ui::ViewportInput input = held_;
  input.cursor = cursor_;
  input.modifiers.ctrl = true;
  input.wheel = {0.0, 1.0};
  const ViewState before = session_.view();
  frame(input);
  EXPECT_EQ(session_.brush().fill_angle, 90.0);
  EXPECT_EQ(session_.brush().radius, 4.0);
  EXPECT_EQ(session_.view(), before);
  EXPECT_EQ(lit().size(), 5U) << "and what it would fill lights up at once";
  session_.perform(kBrushSmaller);
  move(51);
  EXPECT_THAT(lit(), ElementsAre(0));
  session_.perform(kToolPaint);
  session_.perform(kBrushBigger);
  EXPECT_GT(session_.brush().radius, 4.0);
  EXPECT_EQ(session_.brush().fill_angle, 85.0);
}

TEST_F(PaintToolsTest, ARectanglePaintsWhenItIsLetGo) {
  session_.perform(kToolRectangle);
  move(150, 100);
  EXPECT_THAT(lit(), ElementsAre(1)) << "what a click would take";
  press();
  move(350, 300);
  EXPECT_THAT(depths(), Each(0));
  EXPECT_THAT(lit(), ElementsAre(1, 2, 3)) << "what letting go would paint";
  EXPECT_TRUE(controller_.outline().is_closed);
  EXPECT_THAT(controller_.outline().points,
              ElementsAre(render::FramebufferPoint{150, 100}, render::FramebufferPoint{350, 100},
                          render::FramebufferPoint{350, 300}, render::FramebufferPoint{150, 300}));
  move(250, 50);
  EXPECT_THAT(lit(), ElementsAre(1, 2)) << "it also becomes smaller";
  release();
  EXPECT_THAT(depths(), ElementsAre(0, 1, 1, 0, 0, 0));
  EXPECT_THAT(controller_.outline().points, IsEmpty());
  EXPECT_EQ(undo_name(), "rectangle, 2 faces");
  held_.modifiers.ctrl = true;
  move(250);
  press();
  held_.modifiers.ctrl = false;
  move(450);
  release();
  EXPECT_THAT(depths(), ElementsAre(0, 1, 0, 0, 0, 0)) << "what was held at the press counts";
}

TEST_F(PaintToolsTest, ALassoGoesTheWayOfTheMouse) {
  session_.perform(kToolLasso);
  move(120, 50);
  press();
  for (const double x : {160.0, 240.0, 330.0}) {
    move(x, 50);
  }
  move(330.5, 50.5);  // Too little a way to count.
  move(330, 350);
  EXPECT_EQ(controller_.outline().points.size(), 5U);
  release();
  EXPECT_THAT(depths(), ElementsAre(0, 1, 1, 1, 0, 0));
  EXPECT_EQ(undo_name(), "lasso, 3 faces");
}

TEST_F(PaintToolsTest, AClickWithAnAreaToolTakesTheFaceUnderTheCursor) {
  for (const auto tool : {kToolRectangle, kToolLasso}) {
    session_.perform(tool);
    move(450);
    press();
    move(451);
    release();
    EXPECT_TRUE(picker_.last_region->capsule().has_value());
  }
  EXPECT_THAT(depths(), ElementsAre(0, 0, 0, 0, 2, 0));
}

TEST_F(PaintToolsTest, EscAndLostFocusGiveAnAreaUp) {
  for (const auto tool : {kToolRectangle, kToolLasso}) {
    session_.perform(tool);
    move(50, 50);
    press();
    move(550, 60);
    move(550, 350);
    session_.perform(kCancel);
    move(350, 350);
    EXPECT_THAT(controller_.outline().points, IsEmpty());
    release();
    EXPECT_THAT(depths(), Each(0));

    move(50, 50);
    press();
    move(550, 60);
    move(550, 350);
    const auto held = held_;
    lose_focus();
    EXPECT_FALSE(session_.is_stroking());
    EXPECT_THAT(controller_.outline().points, IsEmpty());
    EXPECT_THAT(depths(), Each(0)) << "what was not finished is not meant";
    held_ = held;
    held_.owns_drag = false;
    held_.buttons_down = {};
  }
  EXPECT_FALSE(session_.history().can_undo());
}

TEST_F(PaintToolsTest, EscTakesAFillBackWhileTheButtonIsDown) {
  session_.perform(kToolFill);
  move(50);
  press();
  EXPECT_THAT(depths(), Each(1));
  session_.perform(kCancel);
  EXPECT_THAT(depths(), Each(0));
  release();
  EXPECT_FALSE(session_.history().can_undo());
}

TEST_F(PaintToolsTest, AnAreaEndsAtTheRimOfTheViewport) {
  session_.perform(kToolRectangle);
  move(350, 300);
  press();
  move(-1000, 9000);
  EXPECT_EQ(controller_.outline().points[2], (render::FramebufferPoint{0, 400}));
  release();
  EXPECT_THAT(depths(), ElementsAre(1, 1, 1, 1, 0, 0));
}

TEST_F(PaintToolsTest, TheLowerToolDrawsAStraightLineWithShift) {
  session_.perform(kRaiseAll);
  session_.perform(kToolLower);
  held_.modifiers.shift = true;
  move(150);
  EXPECT_THAT(controller_.outline().points, IsEmpty()) << "no stroke has been made yet";
  held_.modifiers.shift = false;
  click(150);
  held_.modifiers.shift = true;
  move(450);
  EXPECT_THAT(lit(), ElementsAre(1, 2, 3, 4)) << "the line to come lights up";
  ASSERT_EQ(controller_.outline().points.size(), 2U);
  EXPECT_NEAR(controller_.outline().points[0].x, 150.0, 1e-6);
  EXPECT_FALSE(controller_.outline().is_closed);
  press();
  release();
  EXPECT_THAT(depths(), ElementsAre(1, 0, 0, 0, 0, 1));
  session_.perform(kUndo);
  EXPECT_THAT(depths(), ElementsAre(1, 0, 1, 1, 1, 1)) << "the line is one command";
  click(550);
  EXPECT_THAT(depths(), ElementsAre(1, 0, 1, 1, 0, 0)) << "the next goes on from there";
}

TEST_F(PaintToolsTest, ALineBeginsWhereTheStrokeEndedHoweverTheCameraMoved) {
  session_.perform(kToolLower);
  click(350);
  ViewState view = session_.view();
  const render::Camera before =
      render::make_camera(view, session_.document().control->bounds(), kPixels);
  const glm::dvec3 end = render::world_at(before, {350, 220}, before.target_depth);
  view.yaw += 20.0;
  session_.set_view(view);
  held_.modifiers.shift = true;
  move(550);
  const auto shown = render::project(
      render::make_camera(view, session_.document().control->bounds(), kPixels), end);
  ASSERT_EQ(controller_.outline().points.size(), 2U);
  EXPECT_NEAR(controller_.outline().points[0].x, shown->point.x, 1e-6);
  session_.perform({kOpenBundled, std::string("cube")});
  session_.perform(kDiscardChanges);
  move(540);
  EXPECT_THAT(controller_.outline().points, IsEmpty()) << "another mesh, no line";
}

TEST_F(PaintToolsTest, ShiftOfThePaintToolIsAChoice) {
  click(50);
  held_.modifiers.shift = true;
  click(250);
  EXPECT_THAT(depths(), ElementsAre(1, 0, 0, 0, 0, 0)) << "Shift lowers at first";
  session_.perform({kToggleShiftLine, true});
  click(450);
  EXPECT_THAT(depths(), ElementsAre(1, 0, 1, 1, 1, 0));
  held_.modifiers = {.ctrl = true};
  click(350);
  EXPECT_THAT(depths(), ElementsAre(1, 0, 1, 0, 1, 0)) << "Ctrl always lowers";
  held_.modifiers = {.shift = true, .ctrl = true};
  click(250);
  EXPECT_THAT(depths(), ElementsAre(1, 0, 0, 0, 1, 0)) << "with both, a line that lowers";
}

TEST_F(PaintToolsTest, ThroughIsForBrushRectangleAndLasso) {
  move(50);
  EXPECT_EQ(picker_.last_reach, Reach::kVisible);
  session_.perform(kTogglePaintThrough);
  for (const auto tool : {kToolPaint, kToolRectangle, kToolLasso}) {
    session_.perform(tool);
    picker_.last_reach = Reach::kVisible;
    click(50);
    EXPECT_EQ(picker_.last_reach, Reach::kThrough);
  }
}

TEST_F(PaintToolsTest, EveryToolPaintsAndLightsMirrorImages) {
  session_.perform(kToggleMirrorX);
  move(50);
  EXPECT_THAT(lit(), ElementsAre(0, 1));
  press();
  release();
  EXPECT_THAT(depths(), ElementsAre(1, 1, 0, 0, 0, 0));
  EXPECT_EQ(undo_name(), "paint 2 faces");
  session_.perform(kUndo);
  session_.perform(kToolSmartFill);
  session_.perform({kSetFillAngle, 0.0});
  move(150);
  EXPECT_THAT(lit(), UnorderedElementsAre(0, 1));
  press();
  release();
  session_.perform(kUndo);
  session_.perform(kToolRectangle);
  click(50);
  EXPECT_THAT(depths(), ElementsAre(1, 1, 0, 0, 0, 0));
  session_.perform(kToggleMirrorX);
  click(50);
  EXPECT_THAT(depths(), ElementsAre(2, 1, 0, 0, 0, 0));
  EXPECT_EQ(session_.model().lone_faces, 0U);
}

TEST_F(PaintToolsTest, HoveringTellsWhatAClickAddsToTheFace) {
  for (const auto tool : {kToolPaint, kToolLower, kToolFill, kToolSmartFill, kToolRectangle}) {
    for (const int target : {0, 1, 3}) {
      session_.perform(kZeroAll);
      session_.perform(kRaiseAll);
      session_.perform(tool);
      session_.perform({kSetTargetDepth, target});
      if (target == 1) {
        session_.perform(kBrushAdds);
      }
      move(250);
      session_.finish_forecast();
      const auto forecast = session_.model().forecast;
      ASSERT_TRUE(forecast);
      const std::int64_t before = faces_to_come();
      const auto depths_before = depths();
      press();
      EXPECT_EQ(session_.model().forecast.has_value(), tool == kToolRectangle)
          << "what is being done is not foretold, what a drag would do is";
      release();
      const auto depths_after = depths();
      EXPECT_EQ(forecast->added_faces, faces_to_come() - before) << static_cast<int>(tool);
      std::size_t changed = 0;
      for (std::size_t f = 0; f < 6; ++f) {
        changed += depths_before[f] != depths_after[f] ? 1 : 0;
      }
      EXPECT_EQ(forecast->faces, changed);
      EXPECT_EQ(forecast->depth, depths_after[2]) << "all had the same depth";
    }
  }
}

TEST_F(PaintToolsTest, ADragTellsTheCostOfWhatItEncloses) {
  session_.perform(kToolRectangle);
  session_.perform({kSetTargetDepth, 2});
  move(50);
  press();
  move(250);
  session_.finish_forecast();
  ASSERT_TRUE(session_.model().forecast);
  EXPECT_EQ(session_.model().forecast->faces, 3U);
  EXPECT_EQ(session_.model().forecast->depth, 2);
  move(150);
  session_.finish_forecast();
  EXPECT_EQ(session_.model().forecast->faces, 2U);
  const std::int64_t expected = faces_to_come() + session_.model().forecast->added_faces;
  release();
  EXPECT_EQ(faces_to_come(), expected);
}

TEST_F(PaintToolsTest, NothingIsToldWhileNothingIsKnown) {
  move(50);
  EXPECT_FALSE(session_.model().forecast && session_.model().forecast->faces == 0);
  session_.finish_forecast();
  ASSERT_TRUE(session_.model().forecast);
  held_.is_hovered = false;
  move(700);
  EXPECT_FALSE(session_.model().forecast) << "the cursor is gone";
  held_.is_hovered = true;
  session_.perform(kToolOrbit);
  move(50);
  session_.finish_forecast();
  EXPECT_FALSE(session_.model().forecast);
  session_.perform(kToolLower);
  move(50);
  ASSERT_TRUE(session_.model().forecast) << "nothing to lower is known at once";
  EXPECT_EQ(session_.model().forecast->faces, 0U);
  session_.perform({kSetScheme, std::string("catmull-clark")});
  session_.perform(kToolPaint);
  move(50);
  session_.finish_forecast();
  EXPECT_FALSE(session_.model().forecast) << "a scheme does not follow the painting";
}

TEST_F(PaintToolsTest, RulesForTheWholePaintingAreCommands) {
  session_.perform({kSetTargetDepth, 4});
  click(50);
  const auto painted = depths();
  session_.perform(kToggleMirrorX);
  session_.perform(kMirrorPainting);
  EXPECT_THAT(depths(), ElementsAre(4, 4, 0, 0, 0, 0));
  EXPECT_EQ(undo_name(), "mirror x (1 face)");
  session_.perform(kInvertPainting);
  EXPECT_THAT(depths(), ElementsAre(0, 0, 4, 4, 4, 4));
  session_.perform(kShrinkPainting);
  EXPECT_THAT(depths(), Each(0));
  session_.perform(kGrowPainting);
  EXPECT_EQ(session_.toasts().back().text, "No face changes by this.");
  session_.perform(kUndo);
  session_.perform(kGrowPainting);
  EXPECT_THAT(depths(), Each(4));
  session_.perform(kUndo);
  session_.perform(kUndo);
  session_.perform(kUndo);
  EXPECT_THAT(depths(), ElementsAreArray(painted));
  session_.perform(kSmoothPainting);
  EXPECT_EQ(undo_name(), "even out (5 faces)");
  EXPECT_EQ(std::ranges::count(depths(), 1), 5);
}

}  // namespace
}  // namespace limn::app
