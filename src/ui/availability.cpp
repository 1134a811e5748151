// One place answers for menus, buttons and keys alike.

#include "ui/availability.h"

#include <algorithm>

#include "limn/document/document.h"
#include "limn/mesh/control_mesh.h"
#include "limn/mesh/statistics.h"
#include "limn/painting/face_regions.h"
#include "limn/subdivision/crack_check.h"
#include "ui/scheme_text.h"

namespace limn::ui {
namespace {

/// As kSetScheme and kSetSecondScheme name it.
std::string word_of(const std::optional<SchemeSettings>& settings) {
  return settings ? scheme_word(*settings) : std::string();
}

/// Whether a toggle stands where the action would put it; without a value, whether it is on.
bool stands(bool is_on, const Action& action) {
  const auto* value = std::get_if<bool>(&action.value);
  return value != nullptr ? is_on == *value : is_on;
}

/// Whether a rule wants to know distances to the limit surface, which is Catmull-Clark's.
bool asks_for_errors(const AutoDepthSettings& settings) {
  return std::ranges::any_of(settings.rules,
                             [](const PaintRule& rule) { return aims_at_limit(rule); });
}

/// Whether what is set is what the preset that the action names says.
bool stands_for(const AutoDepthStatus& status, const Action& action) {
  const auto* name = std::get_if<std::string>(&action.value);
  if (name == nullptr) {
    return false;
  }
  const Result<std::vector<PaintRule>> rules = rules_of_preset(status.own_presets, *name);
  return rules && *rules == status.settings.rules;
}

/// The value of the action that would change nothing; -1 where there is none.
int standing(const AutoDepthSettings& settings, ActionId id) {
  const ChooseDepths* choose = settings.choice();
  if (choose == nullptr) {
    return -1;
  }
  if (id == ActionId::kSetDepthMerge) {
    return static_cast<int>(choose->merge);
  }
  if (id == ActionId::kSetDepthUnit) {
    return unit_of(choose->choice).value_or(-1);
  }
  if (const auto* budget = std::get_if<FaceBudget>(&choose->choice)) {
    return id == ActionId::kSetBudgetGoal ? static_cast<int>(budget->goal) : -1;
  }
  if (const auto* screen = std::get_if<ChooseByScreen>(&choose->choice)) {
    return id == ActionId::kSetSilhouettes ? screen->size.silhouettes : -1;
  }
  const auto* curve = std::get_if<ChooseByCurve>(&choose->choice);
  return curve != nullptr && id == ActionId::kSetCurveMeasure ? static_cast<int>(curve->measure)
                                                              : -1;
}

/// Whether what is set depends on views.
bool is_seen(const AutoDepthSettings& settings) {
  const ChooseDepths* choose = settings.choice();
  return choose != nullptr && views_of(choose->choice) != nullptr;
}

}  // namespace

std::size_t count_of(const Model& model, FlawKind kind) {
  switch (kind) {
    case FlawKind::kBoundary:
      return model.statistics.boundary_loops;
    case FlawKind::kTJunction:
      return model.t_junctions;
    case FlawKind::kCrack: {
      const auto& result = model.refinement.result;
      return result && result->cracks != nullptr ? result->cracks->crack_faces.size() : 0;
    }
  }
  return 0;
}

bool is_available(const Model& model, const Action& action) {
  const Document& document = model.document;
  const bool is_painted = std::any_of(model.depth_counts.begin() + 1, model.depth_counts.end(),
                                      [](std::size_t count) { return count > 0; });
  switch (action.id) {
    case ActionId::kUndo:
      return !model.history.undo_name.empty();
    case ActionId::kRedo:
      return !model.history.redo_name.empty();
    case ActionId::kRevert:
      return is_painted || !document.demands.empty() || document.control != document.opened ||
             document.stage != Stage{};
    case ActionId::kZeroAll:
    case ActionId::kFramePainted:
      return is_painted || !document.demands.empty();
    case ActionId::kLowerAll:
    case ActionId::kGrowPainting:
    case ActionId::kShrinkPainting:
    case ActionId::kSmoothPainting:
    case ActionId::kInvertPainting:
      return is_painted;
    case ActionId::kMirrorPainting:
      return is_painted && model.brush.mirror.any();
    case ActionId::kClearFine:
      return !document.demands.empty();
    case ActionId::kToggleFine:
      return !document.scheme && document.settings.scheme == RefinementScheme::kCatmullClark;
    case ActionId::kChooseDepths:
      return document.settings.scheme == RefinementScheme::kCatmullClark ||
             !asks_for_errors(model.auto_depth.settings);
    case ActionId::kKeepView:
      return is_seen(model.auto_depth.settings);
    case ActionId::kForgetViews:
      return model.auto_depth.kept_views > 0;
    case ActionId::kCompareBudget:
      return model.auto_depth.outcome && model.auto_depth.outcome->budget &&
             !model.auto_depth.baselines.running;
    case ActionId::kSavePreset: {
      const auto* name = std::get_if<std::string>(&action.value);
      return name != nullptr && check_preset_name(*name);
    }
    case ActionId::kDeletePreset:
      return std::ranges::any_of(model.auto_depth.own_presets, [&](const RulePreset& preset) {
        return action.value == ActionValue(preset.name);
      });
    case ActionId::kBackToControl:
      return document.stage != Stage{};
    case ActionId::kRemoveIllegal:
      return !document.stage.is_legalised;
    case ActionId::kApply:
      return model.refinement.result && model.refinement.result->levels > 0 &&
             !model.refinement.running;
    case ActionId::kAdaptiveLoop:
    case ActionId::kAdaptiveLoopWarren:
      return model.statistics.faces_by_sides.size() == 1 &&
             model.statistics.faces_by_sides.contains(3);
    case ActionId::kClearCreases:
      return model.statistics.crease_edges + model.statistics.sharp_vertices > 0;
    case ActionId::kTextureSmoothInside:
    case ActionId::kTextureLinear:
      return model.statistics.uv_points > 0;
    case ActionId::kToggleSteps:
      return document.settings.scheme == RefinementScheme::kCatmullClark || model.steps.is_shown;
    case ActionId::kStepFirst:
    case ActionId::kStepPrevious:
      return !model.steps.is_shown || model.steps.position > 0;
    case ActionId::kFrameStep:
      return !model.steps.candidates.empty() || !model.steps.falling.empty();
    case ActionId::kStepNext:
    case ActionId::kStepLast:
      return !model.steps.is_shown || model.steps.position < model.steps.size;
    case ActionId::kSplitEdge:
    case ActionId::kFlipEdge:
      return model.hover_edge.has_value();
    case ActionId::kSchemeForward:
      return document.scheme && !model.scheme.misfit && document.stage.levels < kMostSchemeLevels;
    case ActionId::kSchemeBack:
      return document.scheme && document.stage.levels > 0;
    case ActionId::kSetSchemeLevel:
      return document.scheme && !model.scheme.misfit;
    case ActionId::kLoopOriginal:
    case ActionId::kLoopWarren:
      return document.scheme && document.scheme->scheme == Scheme::kLoop;
    case ActionId::kLinearSplits:
    case ActionId::kLinearAverages:
      return document.scheme && document.scheme->scheme == Scheme::kLinear;
    case ActionId::kMakeFit:
      return document.scheme && model.scheme.misfit && model.scheme.misfit->fitting;
    case ActionId::kCompareSphere:
      return document.scheme && !model.scheme.misfit && !model.sphere.running;
    case ActionId::kMeasureDistance:
      return model.distance.can_measure && !model.distance.running;
    case ActionId::kNextFlaw:
    case ActionId::kPreviousFlaw:
      if (const auto* kind = std::get_if<int>(&action.value)) {
        return count_of(model, static_cast<FlawKind>(*kind)) > 0;
      }
      return false;
    case ActionId::kPickDepth:
    case ActionId::kFrameHovered:
      return model.hover.has_value();
    case ActionId::kToggleDesktopDialogs:
      return model.has_desktop_dialogs;
    case ActionId::kBrowse:
      return action.value != ActionValue(std::string());
    case ActionId::kBrushBigger:
      return model.brush.tool == Tool::kSmartFill ? model.brush.fill_angle < kMostFillAngle
                                                  : model.brush.radius < kMaxBrushRadius;
    case ActionId::kBrushSmaller:
      return model.brush.tool == Tool::kSmartFill ? model.brush.fill_angle > 0.0
                                                  : model.brush.radius > kMinBrushRadius;
    default:
      return true;
  }
}

std::string_view why_unavailable(const Model& model, const Action& action) {
  if (is_available(model, action)) {
    return {};
  }
  switch (action.id) {
    case ActionId::kToggleFine:
      return model.document.scheme
                 ? "A uniform scheme is shown, which takes no paint. Choose \"As painted\" first."
                 : "Loop's scheme has no faces within faces. Paint Catmull-Clark for that.";
    case ActionId::kClearFine:
      return "Nothing is painted finer than control faces.";
    default:
      return {};
  }
}

std::string_view why_not_fine(const Model& model) {
  const Tool tool = model.brush.tool;
  if (!model.brush.is_fine || !is_painting(tool)) {
    return {};
  }
  if (const std::string_view why = why_unavailable(model, ActionId::kToggleFine); !why.empty()) {
    return why;
  }
  if (is_fill(tool)) {
    return "Fills take whole control faces.";
  }
  if (model.display.show == ShowMode::kControl) {
    return "Whole faces are painted while the control mesh is shown.";
  }
  const bool is_painted = std::any_of(model.depth_counts.begin() + 1, model.depth_counts.end(),
                                      [](std::size_t count) { return count > 0; }) ||
                          !model.document.demands.empty();
  if (!is_painted) {
    return "Whole faces are painted until there is a refined mesh.";
  }
  if (model.steps.is_shown && model.steps.has_trace) {
    return "Whole faces are painted while legalisation is followed step by step.";
  }
  if (!model.display.live && model.document.stage.levels == 0) {
    return "Whole faces are painted until you subdivide.";
  }
  return {};
}

DepthCounts painted_counts(const Model& model) {
  DepthCounts counts = model.depth_counts;
  const Document& document = model.document;
  if (document.scheme || document.settings.scheme != RefinementScheme::kCatmullClark) {
    return counts;
  }
  const bool splits_all = document.settings.non_quads == NonQuadRule::kUniformFirstStep &&
                          !document.control->is_all_quads();
  for (const FineDemand& demand : document.demands.all()) {
    ++counts[demand.depth - (splits_all ? 1U : 0U)];
  }
  return counts;
}

bool is_checked(const Model& model, const Action& action) {
  const DisplaySettings& display = model.display;
  const SubdivisionSettings& settings = model.document.settings;
  switch (action.id) {
    case ActionId::kToolPaint:
      return model.brush.tool == Tool::kPaint;
    case ActionId::kToolLower:
      return model.brush.tool == Tool::kLower;
    case ActionId::kToolFill:
      return model.brush.tool == Tool::kFill;
    case ActionId::kToolSmartFill:
      return model.brush.tool == Tool::kSmartFill;
    case ActionId::kToolRectangle:
      return model.brush.tool == Tool::kRectangle;
    case ActionId::kToolLasso:
      return model.brush.tool == Tool::kLasso;
    case ActionId::kTogglePaintThrough:
      return stands(model.brush.goes_through, action);
    case ActionId::kToggleFine:
      return stands(model.brush.is_fine, action);
    case ActionId::kToggleShiftLine:
      return stands(model.brush.shift_draws_lines, action);
    case ActionId::kToggleMirrorX:
      return stands(model.brush.mirror.x, action);
    case ActionId::kToggleMirrorY:
      return stands(model.brush.mirror.y, action);
    case ActionId::kToggleMirrorZ:
      return stands(model.brush.mirror.z, action);
    case ActionId::kToolPick:
      return model.brush.tool == Tool::kPick;
    case ActionId::kToolOrbit:
      return model.brush.tool == Tool::kOrbit;
    case ActionId::kToolSplitEdge:
      return model.brush.tool == Tool::kSplitEdge;
    case ActionId::kToolFlipEdge:
      return model.brush.tool == Tool::kFlipEdge;
    case ActionId::kSetScheme:
      return action.value == ActionValue(word_of(model.document.scheme));
    case ActionId::kCompareUniform:
      return display.second && display.is_second_uniform;
    case ActionId::kSetSecondScheme:
      return action.value == ActionValue(word_of(display.second));
    case ActionId::kSetSchemeLevel:
      return action.value == ActionValue(model.document.stage.levels);
    case ActionId::kLoopOriginal:
      return model.document.scheme && model.document.scheme->weights == LoopWeights::kOriginal;
    case ActionId::kLoopWarren:
      return model.document.scheme && model.document.scheme->weights == LoopWeights::kWarren;
    case ActionId::kLinearSplits:
      return model.document.scheme && !model.document.scheme->averages;
    case ActionId::kLinearAverages:
      return model.document.scheme && model.document.scheme->averages;
    case ActionId::kBrushAdds:
      return !model.brush.sets_depth;
    case ActionId::kBrushSets:
      return model.brush.sets_depth;
    case ActionId::kSetTargetDepth:
      return action.value == ActionValue(model.brush.target_depth);
    case ActionId::kSetDepthSource: {
      const std::optional<DepthSource> source = model.auto_depth.settings.source();
      return source && action.value == ActionValue(static_cast<int>(*source));
    }
    case ActionId::kSetDepthRules:
      return action.value == ActionValue(text_of(model.auto_depth.settings.rules));
    case ActionId::kSetDepthUnit:
    case ActionId::kSetBudgetGoal:
    case ActionId::kSetSilhouettes:
    case ActionId::kSetCurveMeasure:
    case ActionId::kSetDepthMerge:
      return action.value == ActionValue(standing(model.auto_depth.settings, action.id));
    case ActionId::kSetDepthWithin:
      return action.value == ActionValue(within_text(model.auto_depth.settings));
    case ActionId::kUsePreset:
      return stands_for(model.auto_depth, action);
    case ActionId::kToggleMeasuredDepths: {
      const ChooseDepths* choose = model.auto_depth.settings.choice();
      const auto* tolerance =
          choose != nullptr ? std::get_if<ChooseByTolerance>(&choose->choice) : nullptr;
      return tolerance != nullptr && stands(tolerance->is_measured, action);
    }
    case ActionId::kToggleLiveDepths:
      return stands(model.auto_depth.settings.is_live, action);
    case ActionId::kToggleLimitDepths:
      return stands(model.auto_depth.settings.moves_to_limit, action);
    case ActionId::kAdaptiveCatmullClark:
      return settings.scheme == RefinementScheme::kCatmullClark;
    case ActionId::kAdaptiveLoop:
      return settings.scheme == RefinementScheme::kLoop &&
             settings.weights == LoopWeights::kOriginal;
    case ActionId::kAdaptiveLoopWarren:
      return settings.scheme == RefinementScheme::kLoop && settings.weights == LoopWeights::kWarren;
    case ActionId::kLegaliseLookAhead:
      return settings.legalisation == LegalisationMethod::kLookAhead;
    case ActionId::kLegaliseGreedy:
      return settings.legalisation == LegalisationMethod::kGreedy;
    case ActionId::kNonQuadsUniformFirstStep:
      return settings.non_quads == NonQuadRule::kUniformFirstStep;
    case ActionId::kNonQuadsWherePainted:
      return settings.non_quads == NonQuadRule::kWherePainted;
    case ActionId::kCornersSharp:
      return settings.corners == CornerRule::kSharp;
    case ActionId::kCornersSmooth:
      return settings.corners == CornerRule::kSmooth;
    case ActionId::kPointsLevel:
      return settings.points == SurfacePoints::kLevel;
    case ActionId::kPointsLimit:
      return settings.points == SurfacePoints::kLimit;
    case ActionId::kTextureSmoothInside:
      return settings.texture == TextureRule::kSmoothInside;
    case ActionId::kTextureLinear:
      return settings.texture == TextureRule::kLinear;
    case ActionId::kShowControl:
      return display.show == ShowMode::kControl;
    case ActionId::kShowRefined:
      return display.show == ShowMode::kRefined;
    case ActionId::kShowBoth:
      return display.show == ShowMode::kBoth;
    case ActionId::kToggleWireframe:
      return display.wireframe;
    case ActionId::kToggleSmooth:
      return display.smooth;
    case ActionId::kToggleLight:
      return display.light;
    case ActionId::kToggleLabels:
      return display.labels;
    case ActionId::kToggleIllegalMarks:
      return display.illegal_marks;
    case ActionId::kToggleCreases:
      return display.creases;
    case ActionId::kToggleFaces:
      return display.faces;
    case ActionId::kToggleValences:
      return display.valences;
    case ActionId::kToggleLive:
      return display.live;
    case ActionId::kToggleSteps:
      return model.steps.is_shown;
    case ActionId::kToggleNumbers:
      return display.numbers;
    case ActionId::kTintDepth:
      return display.tint == Tint::kDepth;
    case ActionId::kTintLevel:
      return display.tint == Tint::kLevel;
    case ActionId::kTintNone:
      return display.tint == Tint::kNone;
    case ActionId::kTintDistance:
      return display.tint == Tint::kDistance;
    case ActionId::kMaterialStudio:
      return display.material == Material::kStudio;
    case ActionId::kMaterialClay:
      return display.material == Material::kClay;
    case ActionId::kMaterialDark:
      return display.material == Material::kDark;
    case ActionId::kMaterialShiny:
      return display.material == Material::kShiny;
    case ActionId::kThemeDark:
      return display.theme == Theme::kDark;
    case ActionId::kThemeLight:
      return display.theme == Theme::kLight;
    case ActionId::kToggleOrthographic:
      return model.view.orthographic;
    case ActionId::kNavigationOriginal:
      return model.navigation.preset == NavigationPreset::kOriginal;
    case ActionId::kNavigationMouseOnly:
      return model.navigation.preset == NavigationPreset::kMouseOnly;
    case ActionId::kNavigationClassroom:
      return model.navigation.preset == NavigationPreset::kClassroom;
    case ActionId::kToggleOrbitPivot:
      return model.navigation.orbits_around_cursor;
    case ActionId::kKeymapOriginal:
      return model.keymap == KeymapId::kOriginal;
    case ActionId::kKeymapClassroom:
      return model.keymap == KeymapId::kClassroom;
    case ActionId::kToggleDesktopDialogs:
      return model.uses_desktop_dialogs && model.has_desktop_dialogs;
    case ActionId::kToggleHints:
      return model.hints.has_value();
    default:
      return false;
  }
}

}  // namespace limn::ui
