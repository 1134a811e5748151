// The brush and the other painting tools: what they are set to, strokes, and what a click would
// reach and cost.
#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

#include <fmt/format.h>

#include "app/session.h"
#include "limn/document/commands.h"
#include "limn/painting/face_regions.h"

namespace limn::app {

using enum ui::ActionId;
using Kind = ui::Toast::Kind;

namespace {

constexpr double kBrushStep = 1.15;

double clamp_radius(double radius) {
  return std::clamp(radius, ui::kMinBrushRadius, ui::kMaxBrushRadius);
}

std::optional<ui::Tool> tool_of(ui::ActionId id) {
  switch (id) {
    case kToolPaint:
      return ui::Tool::kPaint;
    case kToolLower:
      return ui::Tool::kLower;
    case kToolFill:
      return ui::Tool::kFill;
    case kToolSmartFill:
      return ui::Tool::kSmartFill;
    case kToolRectangle:
      return ui::Tool::kRectangle;
    case kToolLasso:
      return ui::Tool::kLasso;
    case kToolPick:
      return ui::Tool::kPick;
    case kToolOrbit:
      return ui::Tool::kOrbit;
    case kToolSplitEdge:
      return ui::Tool::kSplitEdge;
    case kToolFlipEdge:
      return ui::Tool::kFlipEdge;
    default:
      return std::nullopt;
  }
}

void set_or_flip_brush(bool& setting, const ui::Action& action) {
  const auto* value = std::get_if<bool>(&action.value);
  setting = value != nullptr ? *value : !setting;
}

}  // namespace

bool Session::perform_tool(const ui::Action& action) {
  if (const auto tool = tool_of(action.id)) {
    if (*tool != brush_.tool) {
      end_stroke();
    }
    brush_.tool = *tool;
    return true;
  }
  switch (action.id) {
    case kSetFillAngle:
      brush_.fill_angle = std::clamp(std::get<double>(action.value), 0.0, kMostFillAngle);
      return true;
    case kTogglePaintThrough:
      set_or_flip_brush(brush_.goes_through, action);
      return true;
    case kToggleShiftLine:
      set_or_flip_brush(brush_.shift_draws_lines, action);
      return true;
    case kToggleMirrorX:
      set_or_flip_brush(brush_.mirror.x, action);
      return true;
    case kToggleMirrorY:
      set_or_flip_brush(brush_.mirror.y, action);
      return true;
    case kToggleMirrorZ:
      set_or_flip_brush(brush_.mirror.z, action);
      return true;
    default:
      return false;
  }
}

bool Session::perform_brush(const ui::Action& action) {
  switch (action.id) {
    case kBrushAdds:
      brush_.sets_depth = false;
      return true;
    case kBrushSets:
      brush_.sets_depth = true;
      return true;
    case kSetTargetDepth:
      // Whoever names a depth wants to paint that depth.
      brush_.target_depth = std::clamp(std::get<int>(action.value), 0, kMaxDepth);
      brush_.sets_depth = true;
      return true;
    case kPickDepth:
      if (hover_) {
        const auto finer = fine_hover();
        brush_.target_depth = finer ? finer->depth : document_.depths[*hover_];
        brush_.sets_depth = true;
      } else {
        toast(Kind::kNote, "Point at a face to pick its depth.");
      }
      return true;
    case kBrushBigger:
      size_brush(1);
      return true;
    case kBrushSmaller:
      size_brush(-1);
      return true;
    case kSetBrushRadius:
      brush_.radius = clamp_radius(std::get<double>(action.value));
      return true;
    default:
      return perform_tool(action);
  }
}

void Session::size_brush(int steps) {
  if (brush_.tool == ui::Tool::kSmartFill) {
    perform({kSetFillAngle, brush_.fill_angle + ui::kFillAngleStep * steps});
  } else {
    brush_.radius = clamp_radius(brush_.radius * std::pow(kBrushStep, steps));
  }
}

void Session::begin_stroke(DepthChange change, std::string name) {
  end_stroke();
  stroke_.emplace(document_.depths, change);
  stroke_name_ = std::move(name);
}

bool Session::touch(std::span<const std::uint32_t> faces) {
  const bool is_changed = stroke_ && stroke_->touch(document_.depths, with_images(faces));
  if (is_changed) {
    ++document_.revisions.depths;
  }
  return is_changed;
}

void Session::end_stroke() {
  if (fine_stroke_) {
    end_fine_stroke();
  }
  if (!stroke_) {
    return;
  }
  const auto edits = stroke_->edits();
  if (!edits.empty()) {
    try {
      history_.record(paint_command(
          {edits.begin(), edits.end()},
          fmt::format("{} {} face{}", stroke_name_, edits.size(), edits.size() == 1 ? "" : "s")));
    } catch (const std::bad_alloc&) {
      give_up_stroke();  // What cannot be undone is not to stay.
      toast(Kind::kProblem, "There is not enough memory to remember this stroke.");
      return;
    }
    learn(&ui::HintCard::has_painted);
  }
  stroke_.reset();
}

void Session::give_up_stroke() {
  if (stroke_ && !stroke_->edits().empty()) {
    revert_edits(document_.depths, stroke_->edits());
    ++document_.revisions.depths;
  }
  stroke_.reset();
  fine_stroke_.reset();
}

std::vector<std::uint32_t> Session::fill_region(std::uint32_t seed) {
  const ControlMesh& mesh = *document_.control;
  return brush_.tool == ui::Tool::kSmartFill
             ? smart_region(mesh, aids_.edge_angles(document_.control), seed, brush_.fill_angle)
             : flood_region(mesh, document_.depths.values(), seed);
}

std::vector<std::uint32_t> Session::with_images(std::span<const std::uint32_t> faces) {
  return aids_.mirror(document_.control, brush_.mirror).with_images(faces);
}

void Session::propose(std::span<const std::uint32_t> faces, DepthChange change) {
  if (document_.scheme) {
    withdraw_proposal();  // What is shown does not follow from the painting.
    return;
  }
  std::vector<DepthEdit> edits = plan_edits(document_.depths, faces, change);
  ui::PaintForecast proposal{edits.size()};
  if (edits.empty()) {
    forecast_.forget();
    proposal_ = proposal;
    return;
  }
  const bool is_same_depth = std::ranges::all_of(
      edits, [&](const DepthEdit& edit) { return edit.after == edits.front().after; });
  if (is_same_depth) {
    proposal.depth = edits.front().after;
  }
  proposal.amount = change.amount;
  proposal_ = proposal;
  forecast_.ask({document_.control,
                 document_.depths,
                 std::move(edits),
                 document_.settings,
                 shown_levels() > 0 ? shown_levels() : kAllLevels,
                 document_.demands,
                 {}});
}

void Session::withdraw_proposal() {
  proposal_.reset();
  forecast_.forget();
}

std::optional<ui::PaintForecast> Session::forecast() const {
  if (!proposal_ || proposal_->faces == 0) {
    return proposal_;
  }
  const auto added = forecast_.added_faces();
  if (!added) {
    return std::nullopt;
  }
  ui::PaintForecast forecast = *proposal_;
  forecast.added_faces = *added;
  return forecast;
}

void Session::finish_forecast() {
  forecast_.wait_until_idle();
  forecast_.update();
}

}  // namespace limn::app
