// Rules and subdividing: each action that changes the document makes one command.
#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

#include <fmt/format.h>

#include "app/session.h"
#include "limn/document/commands.h"
#include "limn/mesh/refined_mesh.h"
#include "limn/mesh/statistics.h"
#include "ui/format.h"

namespace limn::app {

using enum ui::ActionId;
using Kind = ui::Toast::Kind;

namespace {

/// "1 face", "12 faces".
std::string face_count(std::size_t faces) {
  return fmt::format("{} face{}", faces, faces == 1 ? "" : "s");
}

std::string capitalised(std::string text) {
  if (!text.empty() && text.front() >= 'a' && text.front() <= 'z') {
    text.front() = static_cast<char>(text.front() - 'a' + 'A');
  }
  return text;
}

}  // namespace

bool Session::perform_rule(const ui::Action& action) {
  switch (action.id) {
    case kRaiseAll:
      paint(ChangeFaces{SelectAll{}, DepthChange::add(1)}, "raise all");
      return true;
    case kLowerAll:
      paint(ChangeFaces{SelectAll{}, DepthChange::add(-1)}, "lower all");
      return true;
    case kZeroAll:
      paint(DepthFilter::kClear, "zero all");
      return true;
    case kRaiseVisible:
      paint(ChangeFaces{SelectVisible{}, DepthChange::add(1)}, "raise visible");
      return true;
    case kRaiseDihedral:
      paint(ChangeFaces{SelectDihedral{dihedral_threshold_}, DepthChange::add(1)}, "raise sharp");
      return true;
    case kGrowPainting:
      paint(DepthFilter::kGrow, "grow");
      return true;
    case kShrinkPainting:
      paint(DepthFilter::kShrink, "shrink");
      return true;
    case kSmoothPainting:
      paint(DepthFilter::kSmooth, "even out");
      return true;
    case kInvertPainting:
      paint(DepthFilter::kInvert, "invert");
      return true;
    case kMirrorPainting:
      paint(MirrorPainting{brush_.mirror}, "mirror " + to_string(brush_.mirror));
      return true;
    case kSetDihedralThreshold:
      dihedral_threshold_ = std::clamp(std::get<double>(action.value), 0.0, 180.0);
      return true;
    default:
      return false;
  }
}

void Session::paint(const PaintRule& rule, const std::string& what) {
  end_stroke();
  const PaintContext context{
      document_.settings, host_.visible_faces, {}, &document_.demands, nullptr};
  auto plan = plan_paint_rule(*document_.control, rule, context, document_.depths);
  if (!plan) {
    toast(Kind::kProblem, plan.error().message);
    return;
  }
  // Nothing is painted after that, on finer faces neither.
  DemandEdits demands;
  if (plan->drops_demands) {
    demands = FineDemands().edits_from(document_.demands);
  }
  if (plan->edits.empty() && demands.empty()) {
    toast(Kind::kNote, "No face changes by this.");
    return;
  }
  const std::size_t faces = plan->edits.size();
  const std::size_t finer = demands.removed.size();
  const std::string count = face_count(faces);
  execute(paint_command(std::move(plan->edits), fmt::format("{} ({})", what, count),
                        std::move(demands)));
  std::string text = fmt::format("{}: {} changed.", capitalised(what), ui::counted(faces, "face"));
  if (finer > 0) {
    text += fmt::format(" {} on finer faces gone.", ui::counted(finer, "demand"));
  }
  toast(Kind::kDone, std::move(text));
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
  const std::size_t edges = mesh_statistics(*document_.control).crease_edges;
  toast(Kind::kDone, edges == 0 ? std::string("Creases: none are left.")
                                : fmt::format("Creases: {} edge{} sharp now.", ui::grouped(edges),
                                              edges == 1 ? " is" : "s are"));
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
  if (stage.levels > 0 && !document_.scheme && deepest_painting(document_) == 0) {
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
  toast(Kind::kDone, fmt::format("Apply: the control mesh has {} now.",
                                 ui::counted(document_.control->face_count(), "face")));
}

}  // namespace limn::app
