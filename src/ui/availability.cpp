// One place answers for menus, buttons and keys alike.

#include "ui/availability.h"

#include <algorithm>

#include "limn/document/document.h"
#include "limn/mesh/statistics.h"

namespace limn::ui {

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
      return is_painted || document.control != document.opened || document.stage != Stage{};
    case ActionId::kLowerAll:
    case ActionId::kZeroAll:
    case ActionId::kFramePainted:
      return is_painted;
    case ActionId::kBackToControl:
      return document.stage != Stage{};
    case ActionId::kRemoveIllegal:
      return !document.stage.is_legalised;
    case ActionId::kExportRefined:
    case ActionId::kApply:
      return model.refinement.result.has_value() && !model.refinement.running;
    case ActionId::kClearCreases:
      return model.statistics.crease_edges + model.statistics.sharp_vertices > 0;
    case ActionId::kTextureSmoothInside:
    case ActionId::kTextureLinear:
      return model.statistics.uv_points > 0;
    case ActionId::kPickDepth:
    case ActionId::kFrameHovered:
      return model.hover.has_value();
    case ActionId::kBrowse:
      return action.value != ActionValue(std::string());
    case ActionId::kBrushBigger:
      return model.brush.radius < kMaxBrushRadius;
    case ActionId::kBrushSmaller:
      return model.brush.radius > kMinBrushRadius;
    default:
      return true;
  }
}

bool is_checked(const Model& model, const Action& action) {
  const DisplaySettings& display = model.display;
  const SubdivisionSettings& settings = model.document.settings;
  switch (action.id) {
    case ActionId::kToolPaint:
      return model.brush.tool == Tool::kPaint;
    case ActionId::kToolLower:
      return model.brush.tool == Tool::kLower;
    case ActionId::kToolPick:
      return model.brush.tool == Tool::kPick;
    case ActionId::kToolOrbit:
      return model.brush.tool == Tool::kOrbit;
    case ActionId::kBrushAdds:
      return !model.brush.sets_depth;
    case ActionId::kBrushSets:
      return model.brush.sets_depth;
    case ActionId::kSetTargetDepth:
      return action.value == ActionValue(model.brush.target_depth);
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
    case ActionId::kThemeDark:
      return display.theme == Theme::kDark;
    case ActionId::kThemeLight:
      return display.theme == Theme::kLight;
    case ActionId::kToggleOrthographic:
      return model.view.orthographic;
    case ActionId::kKeymapOriginal:
      return model.keymap == KeymapId::kOriginal;
    case ActionId::kKeymapClassroom:
      return model.keymap == KeymapId::kClassroom;
    default:
      return false;
  }
}

}  // namespace limn::ui
