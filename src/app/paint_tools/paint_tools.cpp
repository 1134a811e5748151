// A face changes once a stroke: the session's stroke sees to that, whatever is touched how often.
#include "app/paint_tools/paint_tools.h"

#include "app/session.h"
#include "app/viewport_frame.h"

namespace limn::app {
namespace {

double brush_radius(const ViewportFrame& frame) {
  return frame.session.brush().radius * frame.place.density();
}

bool is_brush(ui::Tool tool) {
  return tool == ui::Tool::kPaint || tool == ui::Tool::kLower;
}

void pick_depth(const ViewportFrame& frame, render::FramebufferPoint at) {
  if (const auto face = frame.pick(at)) {
    frame.session.set_hover(face->control_face);
    frame.session.perform(ui::ActionId::kPickDepth);
  }
}

}  // namespace

void PaintTools::press(const ViewportFrame& frame, render::FramebufferPoint at) {
  const ui::BrushSettings& brush = frame.session.brush();
  is_stroke_ = is_brush(brush.tool);
  if (!is_stroke_) {
    pick_depth(frame, at);
    return;
  }
  const ui::Modifiers& held = frame.input.modifiers;
  const bool lowers = brush.tool == ui::Tool::kLower || held.shift || held.ctrl;
  frame.session.begin_stroke(lowers             ? DepthChange::add(-1)
                             : brush.sets_depth ? DepthChange::set(brush.target_depth)
                                                : DepthChange::add(1));
  frame.session.touch(frame.picker.brush({at, at, brush_radius(frame)}));
}

void PaintTools::move(const ViewportFrame& frame, render::FramebufferPoint from,
                      render::FramebufferPoint to) {
  if (is_stroke_) {
    frame.session.touch(frame.picker.brush({from, to, brush_radius(frame)}));
  } else {
    pick_depth(frame, to);
  }
}

void PaintTools::release(Session& session) {
  if (is_stroke_) {
    session.end_stroke();
  }
}

bool PaintTools::is_given_up(const Session& session) const {
  return is_stroke_ && !session.is_stroking();
}

void PaintTools::hover(const ViewportFrame& frame, render::FramebufferPoint at) {
  if (!is_brush(frame.session.brush().tool)) {
    leave();
    return;
  }
  ring_ = BrushRing{at, brush_radius(frame)};
  highlighted_ = frame.picker.brush({at, at, brush_radius(frame)});
}

void PaintTools::leave() {
  ring_.reset();
  highlighted_.clear();
}

}  // namespace limn::app
