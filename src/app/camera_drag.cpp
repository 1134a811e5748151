// A pan holds what was under the cursor when it began; orbit and dolly go by the mouse's way alone.
#include "app/camera_drag.h"

#include <cmath>

#include "app/session.h"
#include "app/viewport_frame.h"
#include "render/navigation.h"

namespace limn::app {
namespace {

using ui::MouseButton;

constexpr double kDollyPerNotch = 0.87;
constexpr double kDollyPerHeight = 6.0;  ///< Factor for a drag over the whole height.

}  // namespace

CameraDrag::Kind CameraDrag::kind_of(const ui::ViewportInput& input) noexcept {
  const bool left = input.is_down(MouseButton::kLeft);
  const bool right = input.is_down(MouseButton::kRight);
  if (!input.modifiers.alt) {
    return input.modifiers.shift ? Kind::kPan : Kind::kOrbit;
  }
  if (input.is_down(MouseButton::kMiddle) || (left && right)) {
    return Kind::kPan;
  }
  return left ? Kind::kOrbit : Kind::kDolly;
}

void CameraDrag::begin(Kind kind, const ViewportFrame& frame, render::FramebufferPoint at) {
  kind_ = kind;
  if (kind == Kind::kPan) {
    const auto grabbed = frame.pick(at);
    grabbed_depth_ = grabbed ? grabbed->view_depth : frame.camera().target_depth;
  }
}

void CameraDrag::move(const ViewportFrame& frame, render::FramebufferPoint from,
                      render::FramebufferPoint to) const {
  Session& session = frame.session;
  const double height = frame.place.size.height;
  switch (kind_) {
    case Kind::kOrbit:
      session.set_view(
          render::orbit(session.view(), (to.x - from.x) / height, (to.y - from.y) / height));
      break;
    case Kind::kPan:
      session.set_view(render::pan(session.view(), frame.place.size, {from, to, grabbed_depth_}));
      break;
    case Kind::kDolly: {
      // Right and up come closer, as in the original.
      const double way = ((to.x - from.x) - (to.y - from.y)) / height;
      session.set_view(render::dolly(session.view(), std::pow(kDollyPerHeight, -way),
                                     session.document().control->bounds()));
      break;
    }
  }
}

void CameraDrag::turn_wheel(const ViewportFrame& frame, render::FramebufferPoint at,
                            double notches) {
  Session& session = frame.session;
  const render::Camera camera = frame.camera();
  const auto under_cursor = frame.pick(at);
  const glm::dvec3 anchor =
      under_cursor ? under_cursor->position : render::world_at(camera, at, camera.target_depth);
  session.set_view(render::dolly(session.view(), std::pow(kDollyPerNotch, notches), anchor,
                                 session.document().control->bounds()));
}

}  // namespace limn::app
