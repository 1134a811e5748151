// A pan holds what was under the cursor when it began, an orbit goes round it; a dolly goes by the
// mouse's way alone.
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

std::optional<ui::CameraGesture> CameraDrag::gesture_at(const ViewportFrame& frame,
                                                        render::FramebufferPoint at) {
  const ui::ViewportInput& input = frame.input;
  const ui::NavigationPreset preset = frame.session.navigation().preset;
  ui::MouseGrip grip;
  grip.left = input.is_down(MouseButton::kLeft);
  grip.right = input.is_down(MouseButton::kRight);
  grip.middle = input.is_down(MouseButton::kMiddle);
  grip.modifiers = input.modifiers;
  grip.is_left_free = frame.is_in_second || frame.session.brush().tool == ui::Tool::kOrbit;
  // Areas are begun beside the mesh as often as on it.
  grip.is_beside_mesh = grip.left && ui::asks_for_background(preset) &&
                        !ui::is_area(frame.session.brush().tool) && !frame.pick(at);
  return ui::camera_gesture(preset, grip);
}

void CameraDrag::begin(ui::CameraGesture gesture, const ViewportFrame& frame,
                       render::FramebufferPoint at) {
  gesture_ = gesture;
  pivot_.reset();
  if (gesture == ui::CameraGesture::kPan) {
    const auto grabbed = frame.pick_in_first(at);
    grabbed_depth_ = grabbed ? grabbed->view_depth : frame.camera().target_depth;
  } else if (gesture == ui::CameraGesture::kOrbit &&
             frame.session.navigation().orbits_around_cursor) {
    if (const auto under_cursor = frame.pick_in_first(at)) {
      pivot_ = under_cursor->position;
    }
  }
}

void CameraDrag::move(const ViewportFrame& frame, render::FramebufferPoint from,
                      render::FramebufferPoint to) const {
  Session& session = frame.session;
  const ViewState& view = session.view();
  const double height = frame.place.size.height;
  const double dx = (to.x - from.x) / height;
  const double dy = (to.y - from.y) / height;
  switch (gesture_) {
    case ui::CameraGesture::kOrbit:
      session.set_view(render::orbit_about(view, dx, dy, pivot_.value_or(view.target)));
      break;
    case ui::CameraGesture::kPan:
      session.set_view(render::pan(view, frame.place.size, {from, to, grabbed_depth_}));
      break;
    case ui::CameraGesture::kZoom:
      // Right and up come closer, as in the original.
      session.set_view(render::dolly(view, std::pow(kDollyPerHeight, dy - dx),
                                     session.document().control->bounds()));
      break;
  }
}

void CameraDrag::turn_wheel(const ViewportFrame& frame, render::FramebufferPoint at,
                            double notches) {
  Session& session = frame.session;
  const render::Camera camera = frame.camera();
  const auto under_cursor = frame.pick_in_first(at);
  const glm::dvec3 anchor =
      under_cursor ? under_cursor->position : render::world_at(camera, at, camera.target_depth);
  session.set_view(render::dolly(session.view(), std::pow(kDollyPerNotch, notches), anchor,
                                 session.document().control->bounds()));
}

}  // namespace limn::app
