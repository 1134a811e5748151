// Plays mouse input frame by frame over a picker that knows where three faces are.
#include "app/viewport_controller.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session.h"
#include "app/viewport_mouse.h"

namespace limn::app {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using ui::MouseButton;

/// Faces 0..5 are strips of 100 pixels, side by side.
class StripPicker final : public ViewportPicker {
 public:
  [[nodiscard]] std::optional<render::PickedFace> pick(render::FramebufferPoint point) override {
    if (point.x < 0.0 || point.x >= 600.0) {
      return std::nullopt;
    }
    render::PickedFace face;
    face.control_face = static_cast<std::uint32_t>(point.x / 100.0);
    face.drawn_face = face.control_face;
    face.view_depth = 3.0;
    return face;
  }

  /// Strips from the left to the right end of the region. Through, those of the other side too.
  [[nodiscard]] std::vector<std::uint32_t> faces_in(const render::ScreenRegion& region,
                                                    Reach reach) override {
    last_reach = reach;
    std::vector<std::uint32_t> faces;
    for (std::uint32_t face = 0; face < 6; ++face) {
      if (region.box().low.x < 100.0 * (face + 1) && region.box().high.x >= 100.0 * face) {
        faces.push_back(face);
      }
    }
    return faces;
  }

  std::optional<Reach> last_reach;
};

/// One face, wherever the mouse is.
class FacePickerStub final : public ViewportPicker {
 public:
  explicit FacePickerStub(std::uint32_t face) : face_(face) {}
  [[nodiscard]] std::optional<render::PickedFace> pick(render::FramebufferPoint) override {
    render::PickedFace face;
    face.control_face = face_;
    return face;
  }
  [[nodiscard]] std::vector<std::uint32_t> faces_in(const render::ScreenRegion&, Reach) override {
    return {face_};
  }

 private:
  std::uint32_t face_;
};

class ViewportControllerTest : public testing::Test, protected ViewportMouse {
 protected:
  ViewportControllerTest() {
    session_.perform({ui::ActionId::kOpenBundled, std::string("cube")});
    session_.perform({ui::ActionId::kSetBrushRadius, 4.0});
  }

  void frame(const ui::ViewportInput& input) override {
    controller_.update(input, place_, session_, picker_);
  }

  void move(std::vector<ui::WindowPoint> path) { move_along(std::move(path)); }
  void press(MouseButton button) { change(button, true); }
  void release(MouseButton button) { change(button, false); }

  [[nodiscard]] std::vector<int> depths() const {
    const auto values = session_.document().depths.values();
    return {values.begin(), values.end()};
  }

  ViewportPlace place_{{{10.0, 20.0}, {600.0, 400.0}}, {600, 400}};
  Session session_{{[] {}, {}}};
  StripPicker picker_;
  ViewportController controller_;
};

TEST_F(ViewportControllerTest, FastStrokeLeavesNoGapsAndIsOneCommand) {
  move({{60, 220}});
  press(MouseButton::kLeft);
  EXPECT_THAT(depths(), ElementsAre(1, 0, 0, 0, 0, 0));
  move({{460, 220}});
  EXPECT_THAT(depths(), ElementsAre(1, 1, 1, 1, 1, 0));
  move({{60, 220}});
  release(MouseButton::kLeft);
  EXPECT_THAT(depths(), ElementsAre(1, 1, 1, 1, 1, 0)) << "a face changes once a stroke";
  session_.perform(ui::ActionId::kUndo);
  EXPECT_THAT(depths(), ElementsAre(0, 0, 0, 0, 0, 0));
}

TEST_F(ViewportControllerTest, MovesBeforeThePressInTheSameFrameDoNotPaint) {
  move({{60, 220}});
  held_.buttons_down[0] = true;
  ui::ViewportInput input = held_;
  input.path = {{260, 220}};
  input.cursor = ui::WindowPoint{260, 220};
  input.button = ui::ButtonChanged{MouseButton::kLeft, true};
  input.owns_drag = true;
  frame(input);
  EXPECT_THAT(depths(), ElementsAre(0, 0, 1, 0, 0, 0));
}

TEST_F(ViewportControllerTest, MovesBeforeTheReleaseInTheSameFramePaint) {
  move({{60, 220}});
  press(MouseButton::kLeft);
  held_.buttons_down[0] = false;
  ui::ViewportInput input = held_;
  input.path = {{260, 220}};
  input.cursor = ui::WindowPoint{260, 220};
  input.button = ui::ButtonChanged{MouseButton::kLeft, false};
  input.owns_drag = true;
  frame(input);
  EXPECT_THAT(depths(), ElementsAre(1, 1, 1, 0, 0, 0));
  EXPECT_FALSE(session_.is_stroking());
}

TEST_F(ViewportControllerTest, ShiftAndCtrlLowerAndSetModeSets) {
  session_.perform(ui::ActionId::kRaiseAll);
  session_.perform({ui::ActionId::kSetTargetDepth, 5});
  move({{60, 220}});
  press(MouseButton::kLeft);
  release(MouseButton::kLeft);
  EXPECT_THAT(depths(), ElementsAre(5, 1, 1, 1, 1, 1));
  held_.modifiers.shift = true;
  press(MouseButton::kLeft);
  release(MouseButton::kLeft);
  held_.modifiers = {};
  held_.modifiers.ctrl = true;
  press(MouseButton::kLeft);
  release(MouseButton::kLeft);
  EXPECT_THAT(depths(), ElementsAre(3, 1, 1, 1, 1, 1));
}

TEST_F(ViewportControllerTest, AltLeftAndMiddleOrbitWithoutPainting) {
  const ViewState before = session_.view();
  move({{60, 220}});
  held_.modifiers.alt = true;
  press(MouseButton::kLeft);
  move({{160, 220}});
  release(MouseButton::kLeft);
  const ViewState after_alt = session_.view();
  EXPECT_NE(after_alt.yaw, before.yaw);
  EXPECT_EQ(after_alt.target, before.target);
  held_.modifiers = {};
  press(MouseButton::kMiddle);
  move({{60, 220}});
  release(MouseButton::kMiddle);
  EXPECT_NEAR(session_.view().yaw, before.yaw, 1e-9);
  EXPECT_EQ(session_.document().depths.deepest(), 0);
}

TEST_F(ViewportControllerTest, ShiftMiddleAndAltLeftRightPan) {
  const ViewState before = session_.view();
  move({{60, 220}});
  held_.modifiers.shift = true;
  press(MouseButton::kMiddle);
  move({{160, 260}});
  release(MouseButton::kMiddle);
  const ViewState panned = session_.view();
  EXPECT_NE(panned.target, before.target);
  EXPECT_EQ(panned.yaw, before.yaw);
  held_.modifiers = {};
  held_.modifiers.alt = true;
  press(MouseButton::kLeft);
  press(MouseButton::kRight);
  move({{60, 220}});
  EXPECT_EQ(session_.view().yaw, before.yaw) << "the second button turns the orbit into a pan";
  EXPECT_LT(glm::length(session_.view().target - before.target), 1e-9);
  release(MouseButton::kRight);
  release(MouseButton::kLeft);
}

TEST_F(ViewportControllerTest, AltRightAndWheelDolly) {
  const ViewState before = session_.view();
  move({{60, 220}});
  held_.modifiers.alt = true;
  press(MouseButton::kRight);
  move({{160, 220}});
  release(MouseButton::kRight);
  EXPECT_LT(session_.view().distance, before.distance);
  held_.modifiers = {};
  const double near = session_.view().distance;
  ui::ViewportInput input = held_;
  input.cursor = cursor_;
  input.wheel = {0.0, -1.0};
  frame(input);
  EXPECT_GT(session_.view().distance, near);
  EXPECT_EQ(session_.view().yaw, before.yaw);
}

TEST_F(ViewportControllerTest, CtrlWheelSizesTheBrush) {
  const ViewState before = session_.view();
  ui::ViewportInput input = held_;
  input.cursor = ui::WindowPoint{60, 220};
  input.modifiers.ctrl = true;
  input.wheel = {0.0, 2.0};
  frame(input);
  EXPECT_GT(session_.brush().radius, 4.0);
  EXPECT_EQ(session_.view(), before);
}

TEST_F(ViewportControllerTest, RingAndFacesFollowTheCursorInPixels) {
  place_.size = {1200, 800};  // Twice as many pixels as window units.
  move({{110, 220}});
  ASSERT_TRUE(controller_.ring().has_value());
  EXPECT_EQ(controller_.ring()->centre, (render::FramebufferPoint{200.0, 400.0}));
  EXPECT_EQ(controller_.ring()->radius, 8.0);
  EXPECT_THAT(controller_.highlighted(), ElementsAre(1, 2));
  EXPECT_EQ(session_.hover(), 2u);
  held_.is_hovered = false;
  move({{5, 5}});
  EXPECT_FALSE(controller_.ring().has_value());
  EXPECT_THAT(controller_.highlighted(), IsEmpty());
  EXPECT_FALSE(session_.hover().has_value());
}

TEST_F(ViewportControllerTest, EscEndsTheStrokeUntilTheButtonIsUp) {
  move({{60, 220}});
  press(MouseButton::kLeft);
  session_.perform(ui::ActionId::kCancel);
  move({{460, 220}});
  EXPECT_EQ(session_.document().depths.deepest(), 0);
  release(MouseButton::kLeft);
  press(MouseButton::kLeft);
  EXPECT_TRUE(session_.is_stroking());
  release(MouseButton::kLeft);
}

TEST_F(ViewportControllerTest, LostFocusEndsTheStrokeAndKeepsIt) {
  move({{60, 220}});
  press(MouseButton::kLeft);
  held_ = {};
  frame(held_);
  EXPECT_FALSE(session_.is_stroking());
  EXPECT_THAT(depths(), ElementsAre(1, 0, 0, 0, 0, 0));
  EXPECT_TRUE(session_.history().can_undo());
}

TEST_F(ViewportControllerTest, PickToolTakesTheDepthUnderTheCursor) {
  session_.begin_stroke(DepthChange::set(6));
  session_.touch(std::vector<std::uint32_t>{4});
  session_.end_stroke();
  session_.perform(ui::ActionId::kToolPick);
  move({{460, 220}});
  press(MouseButton::kLeft);
  release(MouseButton::kLeft);
  EXPECT_EQ(session_.brush().target_depth, 6);
}

class EdgeToolTest : public ViewportControllerTest {
 protected:
  EdgeToolTest() {
    session_.perform({ui::ActionId::kOpenBundled, std::string("icosahedron")});
    session_.set_aspect(1.5);
  }

  /// Where a part of an edge of the picker's face shows in the window.
  ui::WindowPoint on_edge(std::uint32_t edge, double part = 0.5) const {
    const ControlMesh& mesh = *session_.document().control;
    const auto& ends = mesh.topology().edge_vertices[edge];
    const render::Camera camera = render::make_camera(session_.view(), mesh.bounds(), place_.size);
    const auto shown = render::project(
        camera, (1.0 - part) * mesh.positions()[ends[0]] + part * mesh.positions()[ends[1]]);
    return {place_.rect.origin.x + shown->point.x, place_.rect.origin.y + shown->point.y};
  }
  std::uint32_t edge_of_face(std::size_t side) const {
    const FlatTopology& topology = session_.document().control->topology();
    return topology.corner_edges[topology.face_offsets[kFace] + side];
  }
  void frame_over(ui::WindowPoint at, std::optional<bool> left = std::nullopt) {
    ui::ViewportInput input = held_;
    input.path = {at};
    input.cursor = at;
    if (left) {
      held_.buttons_down[0] = input.buttons_down[0] = *left;
      input.button = ui::ButtonChanged{MouseButton::kLeft, *left};
      held_.owns_drag = *left;
      input.owns_drag = true;
    }
    controller_.update(input, place_, session_, face_picker_);
  }

  static constexpr std::uint32_t kFace = 5;
  FacePickerStub face_picker_{kFace};
};

TEST_F(EdgeToolTest, TheNearestEdgeOfTheFaceLightsUp) {
  session_.perform(ui::ActionId::kToolSplitEdge);
  for (std::size_t side = 0; side < 3; ++side) {
    frame_over(on_edge(edge_of_face(side), 0.4));
    EXPECT_EQ(session_.hover_edge(), edge_of_face(side));
    EXPECT_EQ(session_.hover(), kFace);
  }
  ui::WindowPoint off = on_edge(edge_of_face(0));
  off.x += 3000.0;
  frame_over(off);
  EXPECT_EQ(session_.hover_edge(), std::nullopt) << "out of reach";
  session_.perform(ui::ActionId::kToolPaint);
  frame_over(on_edge(edge_of_face(1)));
  EXPECT_EQ(session_.hover_edge(), std::nullopt) << "the brush takes faces";
}

TEST_F(EdgeToolTest, AClickSplitsAndAnotherToolFlips) {
  session_.perform(ui::ActionId::kToolSplitEdge);
  const ui::WindowPoint at = on_edge(edge_of_face(2));
  frame_over(at);
  frame_over(at, true);
  EXPECT_EQ(session_.document().control->vertex_count(), 13U);
  frame_over({at.x + 40.0, at.y}, false);
  EXPECT_EQ(session_.document().control->vertex_count(), 13U) << "a drag is one click";
  session_.perform(ui::ActionId::kUndo);
  session_.perform(ui::ActionId::kToolFlipEdge);
  const auto before = session_.document().control->topology().edge_vertices[edge_of_face(2)];
  frame_over(at, true);
  frame_over(at, false);
  EXPECT_EQ(session_.history().undo_name(), "flip edge");
  EXPECT_NE(session_.document().control->topology().edge_vertices[edge_of_face(2)], before);
}

TEST_F(ViewportControllerTest, InTheSecondHalfEveryDragMovesTheCameraOfBoth) {
  place_ = {{{10.0, 20.0}, {300.0, 400.0}}, {300, 400}, ui::WindowPoint{310.0, 20.0}};
  const ViewState before = session_.view();
  move({{460, 220}});
  EXPECT_FALSE(session_.hover());
  EXPECT_FALSE(controller_.ring());
  press(MouseButton::kLeft);
  move({{410, 220}});
  EXPECT_FALSE(session_.is_stroking());
  const ViewState turned = session_.view();
  EXPECT_NE(turned.yaw, before.yaw);
  move({{60, 220}});
  EXPECT_NE(session_.view().yaw, turned.yaw) << "a drag stays in the half it began in";
  release(MouseButton::kLeft);
  EXPECT_EQ(session_.document().depths.deepest(), 0);

  move({{60, 220}});
  EXPECT_EQ(session_.hover(), 0U);
  press(MouseButton::kLeft);
  release(MouseButton::kLeft);
  EXPECT_THAT(depths(), ElementsAre(1, 0, 0, 0, 0, 0)) << "the first half is painted on";
}

TEST_F(ViewportControllerTest, BothHalvesTurnAlike) {
  place_ = {{{10.0, 20.0}, {300.0, 400.0}}, {300, 400}, ui::WindowPoint{310.0, 20.0}};
  session_.perform(ui::ActionId::kToolOrbit);
  const ViewState before = session_.view();
  const auto turn = [&](double left) {
    session_.set_view(before);
    move({{left + 50, 220}});
    press(MouseButton::kLeft);
    move({{left + 120, 260}});
    release(MouseButton::kLeft);
    return session_.view();
  };
  EXPECT_EQ(turn(10.0), turn(310.0));
}

TEST_F(ViewportControllerTest, OrbitToolTurnsWithAPlainDrag) {
  session_.perform(ui::ActionId::kToolOrbit);
  const ViewState before = session_.view();
  move({{60, 220}});
  EXPECT_FALSE(controller_.ring().has_value());
  press(MouseButton::kLeft);
  move({{160, 220}});
  release(MouseButton::kLeft);
  EXPECT_NE(session_.view().yaw, before.yaw);
  EXPECT_EQ(session_.document().depths.deepest(), 0);
}

}  // namespace
}  // namespace limn::app
