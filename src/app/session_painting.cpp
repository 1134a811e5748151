// Painting and subdividing: each action that changes the document makes one command.
#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

#include <fmt/format.h>

#include "app/session.h"
#include "limn/document/commands.h"
#include "limn/mesh/refined_mesh.h"

namespace limn::app {

using enum ui::ActionId;
using Kind = ui::Toast::Kind;

namespace {

constexpr double kBrushStep = 1.15;

double clamp_radius(double radius) {
  return std::clamp(radius, ui::kMinBrushRadius, ui::kMaxBrushRadius);
}

/// "1 face", "12 faces".
std::string face_count(std::size_t faces) {
  return fmt::format("{} face{}", faces, faces == 1 ? "" : "s");
}

}  // namespace

bool Session::perform_rule(const ui::Action& action) {
  switch (action.id) {
    case kRaiseAll:
      paint(SelectAll{}, DepthChange::add(1), "raise all");
      return true;
    case kLowerAll:
      paint(SelectAll{}, DepthChange::add(-1), "lower all");
      return true;
    case kZeroAll:
      paint(SelectAll{}, DepthChange::set(0), "zero all");
      return true;
    case kRaiseVisible:
      paint(SelectVisible{}, DepthChange::add(1), "raise visible");
      return true;
    case kRaiseDihedral:
      paint(SelectDihedral{dihedral_threshold_}, DepthChange::add(1), "raise sharp");
      return true;
    case kSetDihedralThreshold:
      dihedral_threshold_ = std::clamp(std::get<double>(action.value), 0.0, 180.0);
      return true;
    default:
      return false;
  }
}

void Session::paint(const Selection& selection, DepthChange change, const std::string& what) {
  end_stroke();
  const auto faces =
      select_faces(*document_.control, document_.depths, selection, host_.visible_faces);
  if (!faces) {
    toast(Kind::kProblem, faces.error().message);
    return;
  }
  auto edits = plan_edits(document_.depths, *faces, change);
  if (edits.empty()) {
    toast(Kind::kNote, faces->empty() ? "No face is selected by this rule."
                                      : "No face changes: all are at the limit already.");
    return;
  }
  const std::string count = face_count(edits.size());
  execute(paint_command(std::move(edits), fmt::format("{} ({})", what, count)));
}

bool Session::perform_creases(const ui::Action& action) {
  switch (action.id) {
    case kSetCreaseSharpness:
      crease_sharpness_ =
          std::clamp(std::get<double>(action.value), 0.0, double{kInfiniteSharpness});
      return true;
    case kCreaseDihedral:
      crease(SharpenEdges{SelectEdgesOverAngle{dihedral_threshold_}, SharpenEdges::Kind::kSet,
                          static_cast<float>(crease_sharpness_)},
             facts_.dihedral_edges() == 0 ? "No edge is bent by more than the threshold."
                                          : "No edge changes: all of these are as sharp already.");
      return true;
    case kClearCreases:
      crease(ClearCreases{}, "Nothing is sharp: there is nothing to clear.");
      return true;
    default:
      return false;
  }
}

/// `nothing` is what to say where the rule changes nothing.
void Session::crease(const CreaseRule& rule, std::string_view nothing) {
  end_stroke();
  if (apply_crease_rule(*document_.control, rule) == document_.control->creases()) {
    toast(Kind::kNote, std::string(nothing));
    return;
  }
  execute(crease_command(document_, rule));
}

bool Session::perform_brush(const ui::Action& action) {
  switch (action.id) {
    case kToolPaint:
      brush_.tool = ui::Tool::kPaint;
      return true;
    case kToolLower:
      brush_.tool = ui::Tool::kLower;
      return true;
    case kToolPick:
      brush_.tool = ui::Tool::kPick;
      return true;
    case kToolOrbit:
      brush_.tool = ui::Tool::kOrbit;
      return true;
    case kToolSplitEdge:
      brush_.tool = ui::Tool::kSplitEdge;
      return true;
    case kToolFlipEdge:
      brush_.tool = ui::Tool::kFlipEdge;
      return true;
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
        brush_.target_depth = document_.depths[*hover_];
        brush_.sets_depth = true;
      } else {
        toast(Kind::kNote, "Point at a face to pick its depth.");
      }
      return true;
    case kBrushBigger:
      brush_.radius = clamp_radius(brush_.radius * kBrushStep);
      return true;
    case kBrushSmaller:
      brush_.radius = clamp_radius(brush_.radius / kBrushStep);
      return true;
    case kSetBrushRadius:
      brush_.radius = clamp_radius(std::get<double>(action.value));
      return true;
    default:
      return false;
  }
}

void Session::begin_stroke(DepthChange change) {
  end_stroke();
  stroke_.emplace(document_.depths, change);
}

bool Session::touch(std::span<const std::uint32_t> faces) {
  const bool is_changed = stroke_ && stroke_->touch(document_.depths, faces);
  if (is_changed) {
    ++document_.revisions.depths;
  }
  return is_changed;
}

void Session::end_stroke() {
  if (!stroke_) {
    return;
  }
  const auto edits = stroke_->edits();
  if (!edits.empty()) {
    try {
      history_.record(
          paint_command({edits.begin(), edits.end()}, "paint " + face_count(edits.size())));
    } catch (const std::bad_alloc&) {
      give_up_stroke();  // What cannot be undone is not to stay.
      toast(Kind::kProblem, "There is not enough memory to remember this stroke.");
      return;
    }
  }
  stroke_.reset();
}

void Session::give_up_stroke() {
  if (stroke_ && !stroke_->edits().empty()) {
    revert_edits(document_.depths, stroke_->edits());
    ++document_.revisions.depths;
  }
  stroke_.reset();
}

bool Session::perform_subdivision(const ui::Action& action) {
  SubdivisionSettings settings = document_.settings;
  switch (action.id) {
    case kRemoveIllegal:
      set_stage({true, document_.stage.levels}, "remove illegal vertices");
      return true;
    case kSubdivide:
      refinement_.restart();
      if (document_.scheme) {
        execute(scheme_command(std::nullopt, {true, kAllLevels}, "subdivide"));
      }
      set_stage({true, kAllLevels}, "subdivide");
      return true;
    case kSubdivideOneLevel:
      if (document_.scheme) {
        step_to(document_.stage.levels + 1);
      } else if (document_.stage.levels == kAllLevels) {
        toast(Kind::kNote, "The mesh is subdivided to the end already.");
      } else {
        refinement_.restart();
        set_stage({true, std::min(document_.stage.levels, kMaxDepth) + 1}, "subdivide one level");
      }
      return true;
    case kBackToControl:
      set_stage({}, "back to control mesh");
      return true;
    case kApply:
      apply_refined();
      return true;
    case kAdaptiveCatmullClark:
      settings.scheme = RefinementScheme::kCatmullClark;
      change_settings(settings);
      return true;
    case kAdaptiveLoop:
    case kAdaptiveLoopWarren:
      if (const auto fits = check_fits(*document_.control, Scheme::kLoop); !fits) {
        toast(Kind::kNote, fits.error().message);
        return true;
      }
      settings.scheme = RefinementScheme::kLoop;
      settings.weights = action.id == kAdaptiveLoop ? LoopWeights::kOriginal : LoopWeights::kWarren;
      change_settings(settings);
      return true;
    case kLegaliseLookAhead:
      settings.legalisation = LegalisationMethod::kLookAhead;
      change_settings(settings);
      return true;
    case kLegaliseGreedy:
      settings.legalisation = LegalisationMethod::kGreedy;
      change_settings(settings);
      return true;
    case kNonQuadsUniformFirstStep:
      settings.non_quads = NonQuadRule::kUniformFirstStep;
      change_settings(settings);
      return true;
    case kNonQuadsWherePainted:
      settings.non_quads = NonQuadRule::kWherePainted;
      change_settings(settings);
      return true;
    case kCornersSharp:
      settings.corners = CornerRule::kSharp;
      change_settings(settings);
      return true;
    case kCornersSmooth:
      settings.corners = CornerRule::kSmooth;
      change_settings(settings);
      return true;
    case kPointsLevel:
      settings.points = SurfacePoints::kLevel;
      change_settings(settings);
      return true;
    case kPointsLimit:
      settings.points = SurfacePoints::kLimit;
      change_settings(settings);
      return true;
    case kTextureSmoothInside:
      settings.texture = TextureRule::kSmoothInside;
      change_settings(settings);
      return true;
    case kTextureLinear:
      settings.texture = TextureRule::kLinear;
      change_settings(settings);
      return true;
    default:
      return false;
  }
}

void Session::set_stage(Stage stage, std::string name) {
  end_stroke();
  if (stage.levels > 0 && !document_.scheme && document_.depths.deepest() == 0) {
    toast(Kind::kNote, "Nothing is painted yet. Paint, and the refined mesh follows.");
  }
  if (stage.levels > 0 && display_.show == ui::ShowMode::kControl) {
    display_.show = ui::ShowMode::kRefined;
  }
  if (stage != document_.stage) {
    execute(stage_command(stage, std::move(name)));
  }
}

void Session::change_settings(const SubdivisionSettings& settings) {
  if (settings != document_.settings) {
    execute(settings_command(settings));
  }
}

void Session::apply_refined() {
  end_stroke();
  if (shown_levels() == 0) {
    toast(Kind::kNote, "Subdivide first: Apply makes the refined mesh the control mesh.");
    return;
  }
  refinement_.follow(document_, wish());
  const JobResult* refined = refinement_.refined();
  if (!refinement_.is_up_to_date() || refined == nullptr) {
    toast(Kind::kNote, "The refined mesh is not ready yet. Apply when it is.");
    return;
  }
  if (refined->refinement != nullptr && !refined->refinement->cracks.is_watertight()) {
    toast(Kind::kProblem, "The refined mesh has cracks and cannot become a control mesh.");
    return;
  }
  execute(
      replace_control_command(to_control_mesh(*refined->mesh, document_.control.get()), "apply"));
}

}  // namespace limn::app
