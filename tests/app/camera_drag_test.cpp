// Camera drags over a mesh that shows in the left two thirds of the viewport, as deep as asked for.
#include <optional>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "app/session.h"
#include "app/viewport_controller.h"
#include "app/viewport_mouse.h"

namespace limn::app {
namespace {

using ui::MouseButton;

constexpr render::FramebufferSize kSize{600, 400};
constexpr ui::WindowPoint kOnMesh{110.0, 120.0};
constexpr ui::WindowPoint kBeside{560.0, 220.0};

/// Something shows left of column 400, nearer than the target.
class SheetPicker final : public ViewportPicker {
 public:
  explicit SheetPicker(const Session& session) : session_(session) {}

  [[nodiscard]] std::optional<render::PickedFace> pick(render::FramebufferPoint point) override {
    if (point.x >= 400.0) {
      return std::nullopt;
    }
    const render::Camera camera =
        render::make_camera(session_.view(), session_.document().control->bounds(), kSize);
    render::PickedFace face;
    face.view_depth = 0.7 * camera.target_depth;
    face.position = render::world_at(camera, point, face.view_depth);
    return face;
  }
  [[nodiscard]] std::vector<std::uint32_t> faces_in(const render::ScreenRegion& region,
                                                    Reach) override {
    return region.box().low.x < 400.0 ? std::vector<std::uint32_t>{0}
                                      : std::vector<std::uint32_t>{};
  }

 private:
  const Session& session_;
};

class CameraDrags : public testing::Test, protected ViewportMouse {
 protected:
  CameraDrags() { session_.perform({ui::ActionId::kOpenBundled, std::string("cube")}); }

  void frame(const ui::ViewportInput& input) override {
    controller_.update(input, place_, session_, picker_);
  }
  void move(ui::WindowPoint to) { move_along({to}); }
  /// A drag of one button from a place by so much.
  void drag(MouseButton button, ui::WindowPoint from, double dx, double dy) {
    move(from);
    change(button, true);
    move({from.x + 0.5 * dx, from.y + 0.5 * dy});
    move({from.x + dx, from.y + dy});
    change(button, false);
  }
  [[nodiscard]] bool is_painted() const { return session_.document().depths.deepest() > 0; }

  ViewportPlace place_{{{10.0, 20.0}, {600.0, 400.0}}, kSize};
  Session session_{{[] {}, {}}};
  SheetPicker picker_{session_};
  ViewportController controller_;
};

TEST_F(CameraDrags, AnOrbitGoesRoundWhatIsUnderTheCursorWhenItBegins) {
  const render::FramebufferPoint pressed = place_.to_pixel(kOnMesh);
  const glm::dvec3 pivot = picker_.pick(pressed)->position;
  const ViewState before = session_.view();
  drag(MouseButton::kMiddle, kOnMesh, 90.0, 40.0);
  EXPECT_NE(session_.view().yaw, before.yaw);
  EXPECT_NE(session_.view().target, before.target);
  const auto shown =
      render::project(render::make_camera(session_.view(), Bounds{pivot, pivot}, kSize), pivot);
  ASSERT_TRUE(shown);
  EXPECT_NEAR(shown->point.x, pressed.x, 1e-6);
  EXPECT_NEAR(shown->point.y, pressed.y, 1e-6);
  EXPECT_EQ(session_.view().distance, before.distance);
}

TEST_F(CameraDrags, AnOrbitThatBeginsBesideTheMeshGoesRoundTheTarget) {
  const ViewState before = session_.view();
  drag(MouseButton::kMiddle, kBeside, -200.0, 40.0);  // Over the mesh as it goes on.
  EXPECT_NE(session_.view().yaw, before.yaw);
  EXPECT_LT(glm::length(session_.view().target - before.target), 1e-12);
}

TEST_F(CameraDrags, TheOrbitGoesRoundTheTargetWhereThatIsWished) {
  session_.perform(ui::ActionId::kToggleOrbitPivot);
  EXPECT_FALSE(session_.navigation().orbits_around_cursor);
  const ViewState before = session_.view();
  drag(MouseButton::kMiddle, kOnMesh, 90.0, 40.0);
  EXPECT_LT(glm::length(session_.view().target - before.target), 1e-12);
  session_.perform({ui::ActionId::kToggleOrbitPivot, true});
  drag(MouseButton::kMiddle, kOnMesh, 90.0, 40.0);
  EXPECT_GT(glm::length(session_.view().target - before.target), 1e-3);
}

TEST_F(CameraDrags, TheSecondHalfGoesRoundTheSamePlace) {
  place_ = {{{10.0, 20.0}, {300.0, 400.0}}, {300, 400}, ui::WindowPoint{310.0, 20.0}};
  const ViewState before = session_.view();
  drag(MouseButton::kMiddle, {60.0, 120.0}, 40.0, 20.0);
  const ViewState turned = session_.view();
  session_.set_view(before);
  drag(MouseButton::kMiddle, {360.0, 120.0}, 40.0, 20.0);
  EXPECT_EQ(session_.view(), turned);
}

TEST_F(CameraDrags, WithTheMouseAloneLeftBesideTheMeshTurnsAndOnItPaints) {
  session_.perform(ui::ActionId::kNavigationMouseOnly);
  const ViewState before = session_.view();
  drag(MouseButton::kLeft, kBeside, -250.0, 0.0);
  EXPECT_NE(session_.view().yaw, before.yaw);
  EXPECT_FALSE(is_painted()) << "a drag stays what it was when it began";
  const ViewState turned = session_.view();
  drag(MouseButton::kLeft, kOnMesh, 20.0, 0.0);
  EXPECT_EQ(session_.view(), turned);
  EXPECT_TRUE(is_painted());
}

TEST_F(CameraDrags, WithTheMouseAloneAreasMayBeginBesideTheMesh) {
  session_.perform(ui::ActionId::kNavigationMouseOnly);
  session_.perform(ui::ActionId::kToolRectangle);
  const ViewState before = session_.view();
  drag(MouseButton::kLeft, kBeside, -250.0, -100.0);
  EXPECT_EQ(session_.view(), before);
}

TEST_F(CameraDrags, WithTheMouseAloneMiddlePansAndRightTurns) {
  session_.perform(ui::ActionId::kNavigationMouseOnly);
  const ViewState before = session_.view();
  drag(MouseButton::kMiddle, kOnMesh, 60.0, 0.0);
  EXPECT_EQ(session_.view().yaw, before.yaw);
  EXPECT_NE(session_.view().target, before.target);
  drag(MouseButton::kRight, kOnMesh, 60.0, 0.0);
  EXPECT_NE(session_.view().yaw, before.yaw);
  held_.modifiers.ctrl = true;
  drag(MouseButton::kRight, kOnMesh, 60.0, 0.0);
  EXPECT_LT(session_.view().distance, before.distance);
  EXPECT_FALSE(is_painted());
}

TEST_F(CameraDrags, InClassRightPansAndMiddleZooms) {
  session_.perform(ui::ActionId::kKeymapClassroom);
  EXPECT_EQ(session_.navigation().preset, ui::NavigationPreset::kClassroom);
  const ViewState before = session_.view();
  drag(MouseButton::kRight, kOnMesh, 60.0, 0.0);
  EXPECT_EQ(session_.view().yaw, before.yaw);
  EXPECT_NE(session_.view().target, before.target);
  EXPECT_EQ(session_.view().distance, before.distance);
  drag(MouseButton::kMiddle, kOnMesh, 0.0, -60.0);
  EXPECT_LT(session_.view().distance, before.distance);
  drag(MouseButton::kLeft, kOnMesh, 60.0, 0.0);
  EXPECT_NE(session_.view().yaw, before.yaw) << "the orbit tool is taken up with those keys";
  EXPECT_FALSE(is_painted());
  session_.perform(ui::ActionId::kToolPaint);
  drag(MouseButton::kLeft, kOnMesh, 10.0, 0.0);
  EXPECT_TRUE(is_painted());
}

TEST_F(CameraDrags, NavigationIsChosenApartFromTheKeys) {
  session_.perform(ui::ActionId::kKeymapClassroom);
  session_.perform(ui::ActionId::kNavigationOriginal);
  EXPECT_EQ(session_.keymap(), ui::KeymapId::kClassroom);
  const ViewState before = session_.view();
  drag(MouseButton::kRight, kOnMesh, 60.0, 0.0);
  EXPECT_NE(session_.view().yaw, before.yaw);
}

}  // namespace
}  // namespace limn::app
