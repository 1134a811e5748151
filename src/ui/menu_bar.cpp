// The menus hold every action once more, by subject; at the right end stands what is open.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "limn/document/document.h"
#include "ui/panels.h"
#include "ui/scheme_text.h"
#include "ui/widgets.h"

namespace limn::ui {
namespace {

using enum ActionId;

bool begin_menu(PanelContext& context, const char* title) {
  const bool is_open = ImGui::BeginMenu(title);
  remember(context, std::string("menu: ") + title);
  return is_open;
}

void items(PanelContext& context, std::initializer_list<ActionId> ids) {
  for (const ActionId id : ids) {
    action_menu_item(context, id);
  }
}

void file_menu(PanelContext& context) {
  if (!begin_menu(context, "File")) {
    return;
  }
  items(context, {kOpen});
  if (begin_menu(context, "Open bundled mesh")) {
    for (const std::string& name : context.model.bundled_meshes) {
      action_menu_item(context, Action(kOpenBundled, name), name);
    }
    ImGui::EndMenu();
  }
  if (begin_menu(context, "Open recent")) {
    for (const std::string& path : context.model.recent_files) {
      action_menu_item(context, Action(kOpen, path), path);
    }
    if (context.model.recent_files.empty()) {
      ImGui::TextDisabled("Files that you open or save are listed here.");
      remember(context, "no recent files");
    }
    ImGui::EndMenu();
  }
  ImGui::Separator();
  items(context, {kSaveProject, kSaveProjectAs, kExportRefined, kReplaceMesh, kScreenshot});
  ImGui::Separator();
  items(context, {kToggleDesktopDialogs, kQuit});
  ImGui::EndMenu();
}

void edit_menu(PanelContext& context) {
  if (!begin_menu(context, "Edit")) {
    return;
  }
  const HistoryStatus& history = context.model.history;
  const auto with_name = [](const char* verb, const std::string& name) {
    return name.empty() ? std::string(verb) : verb + (": " + name);
  };
  action_menu_item(context, kUndo, with_name("Undo", history.undo_name));
  action_menu_item(context, kRedo, with_name("Redo", history.redo_name));
  items(context, {kRevert});
  ImGui::Separator();
  items(context, {kRaiseAll, kLowerAll, kZeroAll, kRaiseVisible, kRaiseDihedral});
  if (begin_menu(context, "Whole painting")) {
    items(context, {kGrowPainting, kShrinkPainting, kSmoothPainting, kInvertPainting,
                    kMirrorPainting, kClearFine});
    ImGui::EndMenu();
  }
  items(context, {kChooseDepths});
  if (begin_menu(context, "Depth preset")) {
    for (const std::span<const RulePreset> presets :
         {bundled_presets(), context.model.auto_depth.own_presets}) {
      for (const RulePreset& preset : presets) {
        action_menu_item(context, Action(kUsePreset, preset.name), preset.name);
      }
    }
    ImGui::EndMenu();
  }
  items(context, {kCreaseDihedral, kClearCreases});
  ImGui::Separator();
  if (begin_menu(context, "Tool")) {
    items(context, {kToolPaint, kToolLower, kToolFill, kToolSmartFill, kToolRectangle, kToolLasso,
                    kToolPick, kToolOrbit, kToolSplitEdge, kToolFlipEdge});
    ImGui::EndMenu();
  }
  if (begin_menu(context, "Brush")) {
    items(context, {kBrushAdds, kBrushSets, kPickDepth, kBrushBigger, kBrushSmaller});
    ImGui::Separator();
    items(context, {kToggleFine, kTogglePaintThrough, kToggleShiftLine, kToggleMirrorX,
                    kToggleMirrorY, kToggleMirrorZ});
    ImGui::EndMenu();
  }
  ImGui::EndMenu();
}

void view_menu(PanelContext& context) {
  if (!begin_menu(context, "View")) {
    return;
  }
  items(context, {kShowControl, kShowRefined, kShowBoth});
  ImGui::Separator();
  items(context, {kToggleFaces, kToggleWireframe, kToggleSmooth, kToggleLight, kToggleLabels,
                  kToggleIllegalMarks, kToggleCreases, kToggleValences, kToggleNumbers});
  ImGui::Separator();
  items(context, {kCompareUniform});
  if (begin_menu(context, "Face colours")) {
    items(context, {kTintDepth, kTintLevel, kTintDistance, kTintNone});
    ImGui::EndMenu();
  }
  if (begin_menu(context, "Material")) {
    items(context, {kMaterialStudio, kMaterialClay, kMaterialDark, kMaterialShiny});
    ImGui::EndMenu();
  }
  ImGui::Separator();
  items(context, {kFrameAll, kFramePainted, kFrameHovered, kZoomIn, kZoomOut});
  ImGui::Separator();
  if (begin_menu(context, "Look from")) {
    items(context, {kViewFront, kViewBack, kViewLeft, kViewRight, kViewTop, kViewBottom, kViewIso});
    ImGui::EndMenu();
  }
  items(context, {kToggleOrthographic});
  if (begin_menu(context, "Navigation")) {
    items(context, {kNavigationOriginal, kNavigationMouseOnly, kNavigationClassroom});
    ImGui::Separator();
    items(context, {kToggleOrbitPivot});
    ImGui::EndMenu();
  }
  ImGui::Separator();
  items(context, {kThemeDark, kThemeLight, kToggleHints});
  ImGui::EndMenu();
}

void mesh_menu(PanelContext& context) {
  if (!begin_menu(context, "Mesh")) {
    return;
  }
  items(context, {kToggleLive, kSubdivide, kSubdivideOneLevel, kBackToControl, kRemoveIllegal});
  ImGui::Separator();
  if (begin_menu(context, "Painted faces")) {
    items(context, {kAdaptiveCatmullClark, kAdaptiveLoop, kAdaptiveLoopWarren});
    ImGui::EndMenu();
  }
  if (begin_menu(context, "Illegal vertices")) {
    items(context, {kLegaliseLookAhead, kLegaliseGreedy});
    ImGui::EndMenu();
  }
  if (begin_menu(context, "Step by step")) {
    items(context, {kToggleSteps, kStepFirst, kStepPrevious, kStepNext, kStepLast, kFrameStep});
    ImGui::EndMenu();
  }
  if (begin_menu(context, "Faces that are not quads")) {
    items(context, {kNonQuadsUniformFirstStep, kNonQuadsWherePainted});
    ImGui::EndMenu();
  }
  if (begin_menu(context, "Boundary corners")) {
    items(context, {kCornersSharp, kCornersSmooth});
    ImGui::EndMenu();
  }
  if (begin_menu(context, "Vertices")) {
    items(context, {kPointsLevel, kPointsLimit});
    ImGui::EndMenu();
  }
  if (begin_menu(context, "Texture coordinates")) {
    items(context, {kTextureSmoothInside, kTextureLinear});
    ImGui::EndMenu();
  }
  ImGui::Separator();
  if (begin_menu(context, "Scheme")) {
    action_menu_item(context, Action(kSetScheme, std::string()), "As painted");
    for (const SchemeSettings& settings : scheme_variants()) {
      action_menu_item(context, Action(kSetScheme, scheme_word(settings)), scheme_title(settings));
    }
    ImGui::EndMenu();
  }
  items(context, {kSchemeForward, kSchemeBack, kMakeFit, kCompareSphere});
  ImGui::Separator();
  items(context, {kApply, kRevert});
  ImGui::EndMenu();
}

void help_menu(PanelContext& context) {
  if (!begin_menu(context, "Help")) {
    return;
  }
  items(context, {kHelp});
  ImGui::Separator();
  items(context, {kKeymapOriginal, kKeymapClassroom});
  ImGui::EndMenu();
}

/// When a copy of what is not saved was kept, or that none could be; ends at `end`, where there is
/// room for it.
void copy_status(PanelContext& context, float begin, float end) {
  const CopyStatus& copies = context.model.copies;
  if (copies.when.empty() && copies.problem.empty()) {
    return;
  }
  const bool is_well = copies.problem.empty();
  const std::string text = is_well ? "copy kept " + copies.when : std::string("no copy kept");
  ImGui::PushFont(context.fonts.small);
  const float width = ImGui::CalcTextSize(text.c_str()).x;
  if (end - width >= begin) {
    const float y = ImGui::GetCursorScreenPos().y;
    ImGui::SetCursorPosX(end - width);
    ImGui::SetCursorPosY(ImGui::GetCursorPosY());
    ImGui::PushStyleColor(ImGuiCol_Text,
                          is_well ? context.colours.dim_text : context.colours.problem);
    const ImVec2 at{ImGui::GetCursorScreenPos().x,
                    std::floor(y + (ImGui::GetFrameHeight() - ImGui::GetFontSize()) / 2.0F)};
    ImGui::Dummy({width, ImGui::GetFrameHeight()});
    ImGui::GetWindowDrawList()->AddText(at, ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
    ImGui::PopStyleColor();
    remember(context, "copy status");
    ImGui::PopFont();
    if (is_well) {
      explain(context, "Copy of unsaved work",
              "Should Limn or the machine end all of a sudden, the next start offers what was kept "
              "at " +
                  copies.when + ". It is no substitute for saving.");
    } else {
      explain(context, "No copy of unsaved work",
              "Copies for the case that Limn or the machine ends all of a sudden cannot be kept: " +
                  copies.problem + " Save the project yourself.");
    }
    return;
  }
  ImGui::PopFont();
}

/// The name of the document, with a dot in the accent colour while it has unsaved changes.
void document_name(PanelContext& context) {
  const float padding = context.px(16);
  const float begin = ImGui::GetCursorPosX() + padding;
  const float available = room() - padding - context.px(40);
  if (available < context.px(40)) {
    return;
  }
  ImGui::PushFont(context.fonts.body_strong);
  const std::string name = fit_text(context.model.document.name, available);
  const float width = ImGui::CalcTextSize(name.c_str()).x;
  const float left = ImGui::GetWindowWidth() - padding - width;
  ImGui::SetCursorPosX(left);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::TextUnformatted(name.c_str());
  ImGui::PopFont();
  if (context.model.is_modified) {
    const ImVec2 centre{at.x - context.px(12), at.y + ImGui::GetFrameHeight() / 2.0F};
    ImGui::GetWindowDrawList()->AddCircleFilled(centre, context.px(4), context.colours.accent);
  }
  explain(context, "Open document",
          context.model.is_modified ? "It has changes that are not saved yet." : "All is saved.");
  ImGui::SameLine();
  copy_status(context, begin, left - context.px(28));
}

}  // namespace

float draw_menu_bar(PanelContext& context) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {context.px(10), context.px(7)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {context.px(10), context.px(8)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {context.px(10), context.px(7)});
  float height = 0.0F;
  if (ImGui::BeginMainMenuBar()) {
    height = ImGui::GetWindowHeight();
    file_menu(context);
    edit_menu(context);
    view_menu(context);
    mesh_menu(context);
    help_menu(context);
    document_name(context);
    const float y = height - 0.5F;
    ImGui::GetWindowDrawList()->AddLine({0.0F, y}, {ImGui::GetWindowWidth(), y},
                                        context.colours.hairline, 1.0F);
    ImGui::EndMainMenuBar();
  }
  ImGui::PopStyleVar(3);
  return height;
}

}  // namespace limn::ui
