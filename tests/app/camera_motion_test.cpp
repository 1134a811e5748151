// Framing: what is framed fills the view, and the camera goes there within 150 ms.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "app/session.h"
#include "render/camera.h"

namespace limn::app {
namespace {

using enum ui::ActionId;

class CameraMotions : public testing::Test {
 protected:
  CameraMotions() {
    session_.perform({kOpenBundled, std::string("creature")});
    session_.set_aspect(static_cast<double>(kSize.width) / kSize.height);
  }

  /// Lets the camera come to rest.
  void rest() {
    now_ += 1.0;
    session_.update(now_);
    session_.update(now_ += 1.0);
  }
  /// How far towards the image's border the outermost of the points shows, 1 being on it.
  [[nodiscard]] double fullness(std::span<const std::uint32_t> vertices) const {
    const ControlMesh& mesh = *session_.document().control;
    const render::Camera camera = render::make_camera(session_.view(), mesh.bounds(), kSize);
    double fullest = 0.0;
    for (const std::uint32_t v : vertices) {
      const auto shown = render::project(camera, mesh.positions()[v]);
      EXPECT_TRUE(shown) << "before the near plane";
      if (shown) {
        fullest = std::max({fullest, std::abs(2.0 * shown->point.x / kSize.width - 1.0),
                            std::abs(2.0 * shown->point.y / kSize.height - 1.0)});
      }
    }
    return fullest;
  }
  void expect_framed(std::span<const std::uint32_t> vertices) const {
    EXPECT_LT(fullness(vertices), 1.0);
    EXPECT_GT(fullness(vertices), 0.8);
  }

  static constexpr render::FramebufferSize kSize{900, 600};
  Session session_{{[] {}, {}}};
  double now_ = 10.0;
};

TEST_F(CameraMotions, WhatIsFramedFillsTheView) {
  const ControlMesh& mesh = *session_.document().control;
  for (const bool is_orthographic : {false, true}) {
    session_.perform({kToggleOrthographic, is_orthographic});
    std::vector<std::uint32_t> all(mesh.vertex_count());
    for (std::uint32_t v = 0; v < all.size(); ++v) {
      all[v] = v;
    }
    session_.perform(kFrameAll);
    rest();
    expect_framed(all);

    for (const std::uint32_t face : {0U, 17U, 400U}) {
      session_.set_hover(face);
      session_.perform(kFrameHovered);
      rest();
      expect_framed(mesh.face(face));
    }

    session_.perform(kZeroAll);
    session_.begin_stroke(DepthChange::add(1));
    session_.touch(std::vector<std::uint32_t>{3, 4, 5});
    session_.end_stroke();
    session_.perform(kFramePainted);
    rest();
    std::vector<std::uint32_t> painted;
    for (const std::uint32_t face : {3U, 4U, 5U}) {
      painted.insert(painted.end(), mesh.face(face).begin(), mesh.face(face).end());
    }
    expect_framed(painted);
  }
}

TEST_F(CameraMotions, FramingEasesWithin150Milliseconds) {
  rest();
  const ViewState before = session_.view();
  session_.set_hover(17);
  session_.perform(kFrameHovered);
  EXPECT_EQ(session_.view(), before) << "nothing jumps";
  session_.update(now_ + 0.05);
  const ViewState third = session_.view();
  session_.update(now_ + 0.1);
  const ViewState two_thirds = session_.view();
  EXPECT_LT(third.distance, before.distance);
  EXPECT_LT(two_thirds.distance, third.distance);
  EXPECT_LE(session_.next_update(), now_ + 0.1) << "the next frame comes at once";
  session_.update(now_ + 0.16);
  const ViewState there = session_.view();
  EXPECT_LT(there.distance, two_thirds.distance);
  session_.update(now_ + 5.0);
  EXPECT_EQ(session_.view(), there);
}

TEST_F(CameraMotions, TheMouseTakesOverWhileTheCameraEases) {
  session_.set_hover(17);
  session_.perform(kFrameHovered);
  session_.update(now_ + 0.05);
  ViewState held = session_.view();
  held.yaw += 10.0;
  session_.set_view(held);
  session_.update(now_ + 0.1);
  EXPECT_EQ(session_.view(), held);
}

TEST_F(CameraMotions, AxisViewsLookFromWhereTheySay) {
  const std::pair<ui::ActionId, glm::dvec3> expected[] = {
      {kViewRight, {1, 0, 0}},   {kViewLeft, {-1, 0, 0}}, {kViewTop, {0, 1, 0}},
      {kViewBottom, {0, -1, 0}}, {kViewFront, {0, 0, 1}}, {kViewBack, {0, 0, -1}}};
  for (const auto& [id, towards_eye] : expected) {
    session_.perform(id);
    rest();
    const render::Camera camera =
        render::make_camera(session_.view(), session_.document().control->bounds(), kSize);
    EXPECT_LT(glm::length(camera.back - towards_eye), 1e-12);
  }
}

TEST_F(CameraMotions, OrthographicKeepsTheSizeOfWhatIsInTheMiddle) {
  session_.perform(kFrameAll);
  rest();
  const auto pixel = [&] {
    const render::Camera camera =
        render::make_camera(session_.view(), session_.document().control->bounds(), kSize);
    return render::pixel_size_at(camera, camera.target_depth);
  };
  const double before = pixel();
  session_.perform(kToggleOrthographic);
  EXPECT_TRUE(session_.view().orthographic);
  EXPECT_NEAR(pixel() / before, 1.0, 1e-12);
}

}  // namespace
}  // namespace limn::app
