// A frame's path is played before its button change, since that is the order in which things
// happened; a stroke covers the whole way between two places of the cursor, so it leaves no gaps.
#include "app/viewport_controller.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/session.h"
#include "render/navigation.h"
#include "render/picking/edge_picking.h"

namespace limn::app {
namespace {

using ui::MouseButton;

constexpr double kDollyPerNotch = 0.87;
constexpr double kDollyPerHeight = 6.0;  ///< Factor for a drag over the whole height.
constexpr double kBrushPerNotch = 1.12;
constexpr double kEdgeReach = 12.0;  // Window units.

}  // namespace

render::FramebufferPoint ViewportPlace::to_pixel(ui::WindowPoint point) const noexcept {
  const double width = std::max(rect.size.width, 1.0);
  const double height = std::max(rect.size.height, 1.0);
  return {(point.x - rect.origin.x) * size.width / width,
          (point.y - rect.origin.y) * size.height / height};
}

double ViewportPlace::density() const noexcept {
  return rect.size.height > 0.0 ? size.height / rect.size.height : 1.0;
}

struct ViewportController::Context {
  const ui::ViewportInput& input;
  const ViewportPlace& place;
  Session& session;
  ViewportPicker& picker;

  [[nodiscard]] render::Camera camera() const {
    return render::make_camera(session.view(), session.document().control->bounds(), place.size);
  }
  [[nodiscard]] double brush_radius() const { return session.brush().radius * place.density(); }
};

void ViewportController::update(const ui::ViewportInput& input, const ViewportPlace& place,
                                Session& session, ViewportPicker& picker) {
  const Context context{input, place, session, picker};
  if (place.size.is_empty()) {
    ring_.reset();
    highlighted_.clear();
    return;
  }
  if (drag_ == Drag::kStroke && !session.is_stroking()) {
    drag_ = Drag::kIdle;  // Given up by Esc.
  }
  for (const ui::WindowPoint& point : input.path) {
    enter(context, point);
    move(context, to_pixel(context, point));
  }
  if (input.cursor) {
    enter(context, *input.cursor);
    last_ = to_pixel(context, *input.cursor);
  }
  if (input.button) {
    input.button->is_down ? press(context) : release(context);
  } else if (!input.owns_drag && drag_ != Drag::kNone) {
    release(context);  // The window lost the focus, and with it the button.
  }
  turn_wheel(context);
  hover(context);
}

void ViewportController::enter(const Context& context, ui::WindowPoint at) {
  const ViewportPlace& place = context.place;
  const bool is_in_second = place.second && at.x >= place.second->x;
  if (drag_ == Drag::kNone && is_in_second != is_in_second_) {
    is_in_second_ = is_in_second;
    last_ = to_pixel(context, at);
  }
}

render::FramebufferPoint ViewportController::to_pixel(const Context& context,
                                                      ui::WindowPoint at) const {
  const ViewportPlace& place = context.place;
  if (is_in_second_ && place.second) {
    at.x += place.rect.origin.x - place.second->x;
    at.y += place.rect.origin.y - place.second->y;
  }
  return place.to_pixel(at);
}

ViewportController::Drag ViewportController::drag_for(const ui::ViewportInput& input,
                                                      const Session& session) const {
  const bool left = input.is_down(MouseButton::kLeft);
  const bool right = input.is_down(MouseButton::kRight);
  if (input.modifiers.alt) {
    if (input.is_down(MouseButton::kMiddle) || (left && right)) {
      return Drag::kPan;
    }
    return left ? Drag::kOrbit : Drag::kDolly;
  }
  if (!left) {
    return input.modifiers.shift ? Drag::kPan : Drag::kOrbit;
  }
  if (is_in_second_) {
    return input.modifiers.shift ? Drag::kPan : Drag::kOrbit;
  }
  switch (session.brush().tool) {
    case ui::Tool::kSplitEdge:
    case ui::Tool::kFlipEdge:
      return Drag::kEdge;
    case ui::Tool::kPaint:
    case ui::Tool::kLower:
      return Drag::kStroke;
    case ui::Tool::kPick:
      return Drag::kPick;
    case ui::Tool::kOrbit:
      return input.modifiers.shift ? Drag::kPan : Drag::kOrbit;
  }
  return Drag::kIdle;
}

void ViewportController::press(const Context& context) {
  const bool is_camera = drag_ == Drag::kOrbit || drag_ == Drag::kDolly;
  const bool adds_button = is_camera && context.input.modifiers.alt;
  if (drag_ != Drag::kNone && !adds_button) {
    return;  // A second button changes nothing, but Alt + left and right together pan.
  }
  drag_ = drag_for(context.input, context.session);
  switch (drag_) {
    case Drag::kStroke: {
      const ui::BrushSettings& brush = context.session.brush();
      const ui::Modifiers& held = context.input.modifiers;
      const bool lowers = brush.tool == ui::Tool::kLower || held.shift || held.ctrl;
      context.session.begin_stroke(lowers             ? DepthChange::add(-1)
                                   : brush.sets_depth ? DepthChange::set(brush.target_depth)
                                                      : DepthChange::add(1));
      context.session.touch(context.picker.brush({last_, last_, context.brush_radius()}));
      break;
    }
    case Drag::kPick:
      pick_depth(context, last_);
      break;
    case Drag::kEdge:
      take_edge(context);
      break;
    case Drag::kPan: {
      const auto grabbed = pick(context, last_);
      grabbed_depth_ = grabbed ? grabbed->view_depth : context.camera().target_depth;
      break;
    }
    default:
      break;
  }
}

void ViewportController::release(const Context& context) {
  const ui::ViewportInput& input = context.input;
  if (drag_ == Drag::kStroke && !input.is_down(MouseButton::kLeft)) {
    context.session.end_stroke();
    drag_ = Drag::kIdle;
  }
  const bool any_down = input.is_down(MouseButton::kLeft) || input.is_down(MouseButton::kRight) ||
                        input.is_down(MouseButton::kMiddle);
  if (!any_down || !input.owns_drag) {
    drag_ = Drag::kNone;
  }
}

void ViewportController::move(const Context& context, render::FramebufferPoint to) {
  const render::FramebufferPoint from = std::exchange(last_, to);
  Session& session = context.session;
  const double height = context.place.size.height;
  switch (drag_) {
    case Drag::kStroke:
      session.touch(context.picker.brush({from, to, context.brush_radius()}));
      break;
    case Drag::kPick:
      pick_depth(context, to);
      break;
    case Drag::kOrbit:
      session.set_view(
          render::orbit(session.view(), (to.x - from.x) / height, (to.y - from.y) / height));
      break;
    case Drag::kPan:
      session.set_view(render::pan(session.view(), context.place.size, {from, to, grabbed_depth_}));
      break;
    case Drag::kDolly: {
      // Right and up come closer, as in the original.
      const double way = ((to.x - from.x) - (to.y - from.y)) / height;
      session.set_view(render::dolly(session.view(), std::pow(kDollyPerHeight, -way),
                                     session.document().control->bounds()));
      break;
    }
    case Drag::kEdge:
    case Drag::kNone:
    case Drag::kIdle:
      break;
  }
}

std::optional<render::PickedFace> ViewportController::pick(const Context& context,
                                                           render::FramebufferPoint at) const {
  return is_in_second_ ? std::nullopt : context.picker.pick(at);
}

std::optional<std::uint32_t> ViewportController::edge_at(const Context& context, std::uint32_t face,
                                                         render::FramebufferPoint at) {
  return render::nearest_edge(*context.session.document().control, context.camera(), face,
                              {at, kEdgeReach * context.place.density()});
}

void ViewportController::take_edge(const Context& context) {
  Session& session = context.session;
  const auto face = pick(context, last_);
  const auto edge = face ? edge_at(context, face->control_face, last_) : std::nullopt;
  session.set_hover(face ? std::optional(face->control_face) : std::nullopt);
  session.set_hover_edge(edge);
  if (edge) {
    session.perform(session.brush().tool == ui::Tool::kSplitEdge ? ui::ActionId::kSplitEdge
                                                                 : ui::ActionId::kFlipEdge);
  }
}

void ViewportController::pick_depth(const Context& context, render::FramebufferPoint at) {
  if (const auto face = pick(context, at)) {
    context.session.set_hover(face->control_face);
    context.session.perform(ui::ActionId::kPickDepth);
  }
}

void ViewportController::turn_wheel(const Context& context) {
  const double notches = context.input.wheel.y;
  if (notches == 0.0) {
    return;
  }
  Session& session = context.session;
  if (context.input.modifiers.ctrl) {
    session.perform({ui::ActionId::kSetBrushRadius,
                     session.brush().radius * std::pow(kBrushPerNotch, notches)});
    return;
  }
  const render::Camera camera = context.camera();
  const auto under_cursor = pick(context, last_);
  const glm::dvec3 anchor =
      under_cursor ? under_cursor->position : render::world_at(camera, last_, camera.target_depth);
  session.set_view(render::dolly(session.view(), std::pow(kDollyPerNotch, notches), anchor,
                                 session.document().control->bounds()));
}

void ViewportController::hover(const Context& context) {
  ring_.reset();
  const bool is_camera = drag_ == Drag::kOrbit || drag_ == Drag::kPan || drag_ == Drag::kDolly;
  const bool is_here = context.input.is_hovered && context.input.cursor && !is_in_second_;
  Session& session = context.session;
  if (!is_here || is_camera || context.input.wheel.y != 0.0) {
    highlighted_.clear();
    session.set_hover_edge(std::nullopt);
    if (!is_here) {
      session.set_hover(std::nullopt);
    }
    return;
  }
  if (drag_ == Drag::kEdge) {
    highlighted_.clear();
    return;  // The edge has been changed, and the picture with it.
  }
  const auto face = context.picker.pick(last_);
  session.set_hover(face ? std::optional(face->control_face) : std::nullopt);
  const ui::Tool tool = session.brush().tool;
  session.set_hover_edge(face && ui::picks_edges(tool) ? edge_at(context, face->control_face, last_)
                                                       : std::nullopt);
  if (tool == ui::Tool::kPaint || tool == ui::Tool::kLower) {
    ring_ = Ring{last_, context.brush_radius()};
    highlighted_ = context.picker.brush({last_, last_, context.brush_radius()});
  } else {
    highlighted_.clear();
  }
}

}  // namespace limn::app
