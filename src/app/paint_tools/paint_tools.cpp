// A face changes once a stroke: the session's stroke sees to that, whatever is touched how often.
// A rectangle or lasso is a stroke that touches nothing until it ends.
#include "app/paint_tools/paint_tools.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/session.h"
#include "app/viewport_frame.h"
#include "render/picking/screen_region.h"

namespace limn::app {
namespace {

constexpr double kLassoStep = 2.0;  // Window units: what a lasso passes by.
constexpr double kLeastArea = 3.0;  // Window units: below, a drag is a click.

double brush_radius(const ViewportFrame& frame) {
  return frame.session.brush().radius * frame.place.density();
}

Reach reach_of(const ViewportFrame& frame) {
  return frame.session.brush().goes_through ? Reach::kThrough : Reach::kVisible;
}

/// Whether a press paints a straight line from where the last stroke ended.
bool draws_line(const ViewportFrame& frame) {
  const ui::BrushSettings& brush = frame.session.brush();
  return frame.input.modifiers.shift &&
         (brush.tool == ui::Tool::kLower ||
          (brush.tool == ui::Tool::kPaint && brush.shift_draws_lines));
}

DepthChange change_of(const ViewportFrame& frame) {
  const ui::BrushSettings& brush = frame.session.brush();
  const ui::Modifiers& held = frame.input.modifiers;
  const bool lowers =
      brush.tool == ui::Tool::kLower || held.ctrl || (held.shift && !draws_line(frame));
  return lowers             ? DepthChange::add(-1)
         : brush.sets_depth ? DepthChange::set(brush.target_depth)
                            : DepthChange::add(1);
}

const char* name_of(ui::Tool tool) {
  switch (tool) {
    case ui::Tool::kFill:
      return "fill";
    case ui::Tool::kSmartFill:
      return "smart fill";
    case ui::Tool::kRectangle:
      return "rectangle,";
    case ui::Tool::kLasso:
      return "lasso,";
    default:
      return "paint";
  }
}

void pick_depth(const ViewportFrame& frame, render::FramebufferPoint at) {
  if (const auto face = frame.pick(at)) {
    frame.session.set_hover(face->control_face);
    frame.session.perform(ui::ActionId::kPickDepth);
  }
}

double distance(render::FramebufferPoint a, render::FramebufferPoint b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

}  // namespace

void PaintTools::press(const ViewportFrame& frame, render::FramebufferPoint at) {
  Session& session = frame.session;
  const ui::Tool tool = session.brush().tool;
  if (!ui::is_painting(tool)) {
    gesture_ = Gesture::kPick;
    pick_depth(frame, at);
    return;
  }
  change_ = change_of(frame);
  is_fine_ = session.paints_fine();
  if (ui::is_area(tool)) {
    gesture_ = Gesture::kArea;
    begin_stroke(frame, name_of(tool));
    area_tool_ = tool;
    area_.clear();
    add_to_area(frame, at);
  } else if (ui::is_fill(tool)) {
    gesture_ = Gesture::kFill;
    const auto face = frame.pick(at);
    const std::vector<std::uint32_t> region =
        face ? fill_region(frame, face->control_face) : std::vector<std::uint32_t>{};
    session.begin_stroke(change_, name_of(tool));
    session.touch(region);
  } else {
    gesture_ = Gesture::kStroke;
    const auto start = draws_line(frame) ? line_start(frame) : std::nullopt;
    begin_stroke(frame, name_of(tool));
    touch(frame, render::BrushCapsule{start.value_or(at), at, brush_radius(frame)});
  }
}

void PaintTools::begin_stroke(const ViewportFrame& frame, const char* name) {
  if (is_fine_) {
    frame.session.begin_fine_stroke(change_, name);
  } else {
    frame.session.begin_stroke(change_, name);
  }
}

void PaintTools::touch(const ViewportFrame& frame, const render::ScreenRegion& region) const {
  if (is_fine_) {
    frame.session.touch(frame.picker.shown_faces_in(region, reach_of(frame)));
  } else {
    frame.session.touch(faces_in(frame, region));
  }
}

void PaintTools::move(const ViewportFrame& frame, render::FramebufferPoint from,
                      render::FramebufferPoint to) {
  switch (gesture_) {
    case Gesture::kStroke:
      touch(frame, render::BrushCapsule{from, to, brush_radius(frame)});
      break;
    case Gesture::kArea:
      add_to_area(frame, to);
      break;
    case Gesture::kPick:
      pick_depth(frame, to);
      break;
    case Gesture::kFill:
    case Gesture::kNone:
      break;
  }
}

void PaintTools::release(const ViewportFrame& frame, render::FramebufferPoint at) {
  Session& session = frame.session;
  if (gesture_ == Gesture::kArea) {
    if (frame.input.button) {
      touch(frame, area(frame));
      session.end_stroke();
    } else {
      session.give_up_stroke();
    }
  } else if (gesture_ == Gesture::kStroke) {
    session.end_stroke();
    remember_end(frame, at);
  } else if (gesture_ == Gesture::kFill) {
    session.end_stroke();
  }
  gesture_ = Gesture::kNone;
  outline_ = {};
}

bool PaintTools::take_given_up(const Session& session) {
  const bool is_given_up =
      gesture_ != Gesture::kNone && gesture_ != Gesture::kPick && !session.is_stroking();
  if (is_given_up) {
    gesture_ = Gesture::kNone;
    outline_ = {};
  }
  return is_given_up;
}

void PaintTools::add_to_area(const ViewportFrame& frame, render::FramebufferPoint at) {
  // What lies outside of the viewport cannot be seen, and so is not meant.
  const render::FramebufferPoint inside{std::clamp(at.x, 0.0, double(frame.place.size.width)),
                                        std::clamp(at.y, 0.0, double(frame.place.size.height))};
  if (area_tool_ == ui::Tool::kRectangle) {
    area_.resize(1, inside);
    area_.push_back(inside);
    const auto& [a, b] = std::pair{area_[0], area_[1]};
    outline_ = {{a, {b.x, a.y}, b, {a.x, b.y}}, true};
    return;
  }
  if (area_.empty() || distance(area_.back(), inside) >= kLassoStep * frame.place.density()) {
    area_.push_back(inside);
  }
  outline_ = {area_, true};
}

render::ScreenRegion PaintTools::area(const ViewportFrame& frame) const {
  const bool is_click = std::ranges::all_of(area_, [&](const render::FramebufferPoint& point) {
    return distance(point, area_.front()) < kLeastArea * frame.place.density();
  });
  if (is_click) {
    return render::BrushCapsule{area_.front(), area_.front(), 0.0};
  }
  return area_tool_ == ui::Tool::kRectangle
             ? render::ScreenRegion::rectangle(area_.front(), area_.back())
             : render::ScreenRegion(area_);
}

std::vector<std::uint32_t> PaintTools::faces_in(const ViewportFrame& frame,
                                                const render::ScreenRegion& region) const {
  return frame.picker.faces_in(region, reach_of(frame));
}

std::optional<render::FramebufferPoint> PaintTools::line_start(const ViewportFrame& frame) const {
  if (!last_end_ || last_end_->mesh.lock() != frame.session.document().control) {
    return std::nullopt;
  }
  const auto shown = render::project(frame.camera(), last_end_->position);
  return shown ? std::optional(shown->point) : std::nullopt;
}

void PaintTools::remember_end(const ViewportFrame& frame, render::FramebufferPoint at) {
  const auto face = frame.pick(at);
  const render::Camera camera = frame.camera();
  last_end_ = {frame.session.document().control,
               face ? face->position : render::world_at(camera, at, camera.target_depth)};
}

const std::vector<std::uint32_t>& PaintTools::fill_region(const ViewportFrame& frame,
                                                          std::uint32_t seed) {
  Session& session = frame.session;
  const Document& document = session.document();
  const ui::BrushSettings& brush = session.brush();
  const bool is_known =
      fill_ && fill_->mesh.lock() == document.control &&
      fill_->depths_revision == document.revisions.depths && fill_->tool == brush.tool &&
      fill_->angle == brush.fill_angle &&
      (fill_->seed == seed ||
       // A flood is the same from whichever of its faces it begins.
       (brush.tool == ui::Tool::kFill && std::ranges::binary_search(fill_->region, seed)));
  if (!is_known) {
    fill_ = Fill{document.control, document.revisions.depths, seed,
                 brush.tool,       brush.fill_angle,          session.fill_region(seed)};
  }
  return fill_->region;
}

void PaintTools::hover(const ViewportFrame& frame, render::FramebufferPoint at) {
  Session& session = frame.session;
  const ui::Tool tool = session.brush().tool;
  const bool is_idle = gesture_ == Gesture::kNone;
  const bool is_fine = is_idle ? session.paints_fine() : is_fine_;
  ring_.reset();
  if (is_idle) {
    outline_ = {};
  }
  std::optional<render::ScreenRegion> region;
  std::vector<std::uint32_t> faces;
  if (gesture_ == Gesture::kArea) {
    region = area(frame);
  } else if (ui::is_brush(tool)) {
    ring_ = BrushRing{at, brush_radius(frame)};
    const auto start = is_idle && draws_line(frame) ? line_start(frame) : std::nullopt;
    if (start) {
      outline_ = {{*start, at}, false};
    }
    region = render::BrushCapsule{start.value_or(at), at, ring_->radius};
  } else if (ui::is_area(tool) && is_fine) {
    region = render::BrushCapsule{at, at, 0.0};
  } else if (ui::is_painting(tool)) {
    const auto face = frame.pick(at);
    if (face && ui::is_fill(tool)) {
      faces = fill_region(frame, face->control_face);
    } else if (face) {
      faces = {face->control_face};
    }
  }
  const bool proposes = ui::is_painting(tool) && (is_idle || gesture_ == Gesture::kArea);
  const DepthChange change = is_idle ? change_of(frame) : change_;
  if (region && is_fine) {
    light(frame, *region, proposes ? std::optional(change) : std::nullopt);
    return;
  }
  lit_.reset();
  if (region) {
    faces = faces_in(frame, *region);
  }
  highlighted_ = session.with_images(faces);
  if (proposes && !faces.empty()) {
    session.propose(highlighted_, change);
  } else {
    session.withdraw_proposal();
  }
}

void PaintTools::light(const ViewportFrame& frame, const render::ScreenRegion& region,
                       std::optional<DepthChange> proposed) {
  Session& session = frame.session;
  ShownFaces under = frame.picker.shown_faces_in(region, reach_of(frame));
  if (proposed && !under.faces.empty()) {
    session.propose(under, *proposed);
  } else {
    session.withdraw_proposal();
  }
  highlighted_.clear();
  const ShownFaces* touched = session.touched();
  if (touched != nullptr && touched->refined == under.refined) {
    std::vector<std::uint32_t> all;
    std::ranges::set_union(touched->faces, under.faces, std::back_inserter(all));
    under.faces = std::move(all);
  }
  lit_ = session.with_images(under);
}

void PaintTools::leave(Session& session) {
  ring_.reset();
  highlighted_.clear();
  lit_.reset();
  session.withdraw_proposal();
  if (gesture_ == Gesture::kNone) {
    outline_ = {};
  }
}

}  // namespace limn::app
