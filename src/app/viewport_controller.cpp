// A frame's path is played before its button change, since that is the order in which things
// happened.
#include "app/viewport_controller.h"

#include <cmath>
#include <utility>

#include "app/edge_tools.h"
#include "app/session.h"

namespace limn::app {
namespace {

using ui::MouseButton;

constexpr double kBrushPerNotch = 1.12;

/// What the face of the refined mesh at a place is called, where one paints on such.
std::optional<FineFace> fine_name_at(const ViewportFrame& frame, render::FramebufferPoint at) {
  if (!frame.session.paints_fine()) {
    return std::nullopt;
  }
  const std::vector<FineFace> names = names_of(frame.picker.shown_face_at(at));
  return names.empty() ? std::nullopt : std::optional(names.front());
}

}  // namespace

void ViewportController::update(const ui::ViewportInput& input, const ViewportPlace& place,
                                Session& session, ViewportPicker& picker) {
  ViewportFrame frame{input, place, session, picker, is_in_second_};
  if (place.size.is_empty()) {
    tools_.leave(session);
    return;
  }
  if (drag_ == Drag::kPaint && tools_.take_given_up(session)) {
    drag_ = Drag::kIdle;
  }
  for (const ui::WindowPoint& point : input.path) {
    enter(frame, point);
    move(frame, frame.to_pixel(point));
  }
  if (input.cursor) {
    enter(frame, *input.cursor);
    last_ = frame.to_pixel(*input.cursor);
  }
  if (input.button) {
    input.button->is_down ? press(frame) : release(frame);
  } else if (!input.owns_drag && drag_ != Drag::kNone) {
    release(frame);  // The window lost the focus, and with it the button.
  }
  turn_wheel(frame);
  hover(frame);
}

void ViewportController::enter(ViewportFrame& frame, ui::WindowPoint at) {
  const bool is_in_second = frame.place.second && at.x >= frame.place.second->x;
  if (drag_ == Drag::kNone && is_in_second != is_in_second_) {
    is_in_second_ = frame.is_in_second = is_in_second;
    last_ = frame.to_pixel(at);
  }
}

void ViewportController::press(const ViewportFrame& frame) {
  const bool adds_button =
      drag_ == Drag::kCamera && frame.input.modifiers.alt && camera_.takes_second_button();
  if (drag_ != Drag::kNone && !adds_button) {
    return;  // A second button changes nothing, but Alt + left and right together pan.
  }
  if (const auto gesture = CameraDrag::gesture_at(frame, last_)) {
    drag_ = Drag::kCamera;
    camera_.begin(*gesture, frame, last_);
  } else if (ui::picks_edges(frame.session.brush().tool)) {
    drag_ = Drag::kEdge;
    edge_tools::press(frame, last_);
  } else {
    drag_ = Drag::kPaint;
    tools_.press(frame, last_);
  }
}

void ViewportController::release(const ViewportFrame& frame) {
  const ui::ViewportInput& input = frame.input;
  if (drag_ == Drag::kPaint && !input.is_down(MouseButton::kLeft)) {
    tools_.release(frame, last_);
    drag_ = Drag::kIdle;
  }
  const bool any_down = input.is_down(MouseButton::kLeft) || input.is_down(MouseButton::kRight) ||
                        input.is_down(MouseButton::kMiddle);
  if (!any_down || !input.owns_drag) {
    drag_ = Drag::kNone;
  }
}

void ViewportController::move(const ViewportFrame& frame, render::FramebufferPoint to) {
  const render::FramebufferPoint from = std::exchange(last_, to);
  if (drag_ == Drag::kPaint) {
    tools_.move(frame, from, to);
  } else if (drag_ == Drag::kCamera) {
    camera_.move(frame, from, to);
  }
}

void ViewportController::turn_wheel(const ViewportFrame& frame) {
  const double notches = frame.input.wheel.y;
  if (notches == 0.0) {
    return;
  }
  if (frame.input.modifiers.ctrl) {
    const ui::BrushSettings& brush = frame.session.brush();
    if (brush.tool == ui::Tool::kSmartFill) {
      frame.session.perform(
          {ui::ActionId::kSetFillAngle, brush.fill_angle + ui::kFillAngleStep * notches});
    } else {
      frame.session.perform(
          {ui::ActionId::kSetBrushRadius, brush.radius * std::pow(kBrushPerNotch, notches)});
    }
  } else {
    CameraDrag::turn_wheel(frame, last_, notches);
  }
}

void ViewportController::hover(const ViewportFrame& frame) {
  const bool is_here = frame.input.is_hovered && frame.input.cursor && !frame.is_in_second;
  Session& session = frame.session;
  if (!is_here || drag_ == Drag::kCamera ||
      (frame.input.wheel.y != 0.0 && !frame.input.modifiers.ctrl)) {
    tools_.leave(session);
    session.set_hover_edge(std::nullopt);
    if (!is_here) {
      session.set_hover(std::nullopt);
      session.set_hover_name(std::nullopt);
    }
    return;
  }
  if (drag_ == Drag::kEdge) {
    tools_.leave(session);
    return;  // The edge has been changed, and the picture with it.
  }
  const auto face = frame.pick(last_);
  session.set_hover(face ? std::optional(face->control_face) : std::nullopt);
  session.set_hover_edge(face && ui::picks_edges(session.brush().tool)
                             ? edge_tools::edge_at(frame, face->control_face, last_)
                             : std::nullopt);
  session.set_hover_name(face ? fine_name_at(frame, last_) : std::nullopt);
  tools_.hover(frame, last_);
}

}  // namespace limn::app
