// What the tool in hand does, then what can be done to many faces at once.

#include <array>
#include <cmath>
#include <string>

#include "limn/painting/face_regions.h"
#include "limn/subdivision/settings.h"
#include "ui/action_table.h"
#include "ui/availability.h"
#include "ui/format.h"
#include "ui/keymap.h"
#include "ui/panels.h"
#include "ui/widgets.h"

namespace limn::ui {
namespace {

/// A row of swatches, one a depth. Pressing one also makes the brush set depths, since that is
/// what a target depth is for.
void target_depth_row(PanelContext& context) {
  const BrushSettings& brush = context.model.brush;
  const float gap = context.px(3);
  constexpr int kCount = kMaxDepth + 1;
  const float pitch = (room() + gap) / static_cast<float>(kCount);
  const float height = context.px(28);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushFont(context.fonts.small);
  for (int depth = 0; depth < kCount; ++depth) {
    const Action action(ActionId::kSetTargetDepth, depth);
    const ImVec2 low{std::floor(origin.x + pitch * static_cast<float>(depth)), origin.y};
    const ImVec2 high{std::floor(origin.x + pitch * static_cast<float>(depth + 1) - gap),
                      origin.y + height};
    ImGui::SetCursorScreenPos(low);
    ImGui::PushID(depth);
    const bool is_pressed = ImGui::InvisibleButton("##depth", {high.x - low.x, height});
    ImGui::PopID();
    const bool is_target = is_checked(context.model, action);
    const float strength = brush.sets_depth || ImGui::IsItemHovered() ? 1.0F : 0.55F;
    list.AddRectFilled(low, high, faded(swatch_colour(depth), strength), context.px(4));
    if (is_target) {
      const float inset = context.px(1);
      list.AddRect({low.x - inset, low.y - inset}, {high.x + inset, high.y + inset},
                   context.colours.accent, context.px(5), 0, context.px(2.5F));
    }
    const std::string digit = std::to_string(depth);
    const ImVec2 size = ImGui::CalcTextSize(digit.c_str());
    list.AddText({std::floor((low.x + high.x - size.x) / 2.0F),
                  std::floor((low.y + high.y - size.y) / 2.0F)},
                 text_on_swatch(depth), digit.c_str());
    ImGui::PushFont(context.fonts.body);
    explain(context, "Depth " + digit,
            "The brush sets this depth: each face becomes up to " +
                grouped(std::uint64_t{1} << (2U * static_cast<unsigned>(depth))) +
                (depth == 0 ? " face." : " faces."),
            all_keys_text(context.model.keymap, action));
    ImGui::PopFont();
    remember(context, "depth " + digit);
    if (is_pressed) {
      context.emit(action);
      if (!brush.sets_depth) {
        context.emit(ActionId::kBrushSets);
      }
    }
  }
  ImGui::PopFont();
}

/// The action's label, with how much it concerns where that is known.
std::string with_count(ActionId id, std::optional<std::size_t> count, const char* what) {
  std::string label(info(id).label);
  if (count) {
    label += " (" + counted(*count, what) + ")";
  }
  return label;
}

/// What only some of the tools have; at least one line of it for each.
void tool_options(PanelContext& context) {
  const BrushSettings& brush = context.model.brush;
  if (brush.tool == Tool::kSmartFill) {
    action_slider(context, ActionId::kSetFillAngle, brush.fill_angle,
                  {.label = "Fill angle", .format = "%.0f°", .low = 0.0, .high = kMostFillAngle});
    return;
  }
  if (!is_area(brush.tool) && !is_fill(brush.tool)) {
    action_slider(context, ActionId::kSetBrushRadius, brush.radius,
                  {.label = "Brush radius",
                   .format = "%.0f px",
                   .low = kMinBrushRadius,
                   .high = kMaxBrushRadius,
                   .is_logarithmic = true});
  }
  if (is_fill(brush.tool)) {
    return;
  }
  const float half = std::floor(room() / 2.0F);
  action_toggle(context, ActionId::kTogglePaintThrough, half);
  if (brush.tool == Tool::kPaint) {
    ImGui::SameLine(0.0F, 0.0F);
    action_toggle(context, ActionId::kToggleShiftLine, room());
  }
}

/// A button with one letter that stays down while its axis is on.
void axis_toggle(PanelContext& context, ActionId id, const char* letter) {
  const bool is_on = is_checked(context.model, id);
  const float side = context.px(28);
  const bool is_pressed = ImGui::InvisibleButton(letter, {side, side});
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  const ThemeColours& c = context.colours;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 off = ImGui::IsItemHovered() ? c.control_hovered : c.control;
  list.AddRectFilled(low, high, is_on ? c.accent : off, context.px(5));
  const ImVec2 size = ImGui::CalcTextSize(letter);
  list.AddText(
      {std::floor((low.x + high.x - size.x) / 2.0F), std::floor((low.y + high.y - size.y) / 2.0F)},
      is_on ? c.on_accent : c.text, letter);
  explain(context, id);
  remember(context, info(id).label);
  if (is_pressed) {
    context.emit(Action(id, !is_on));
  }
}

/// The axes, and whether faces of the refined mesh are painted instead of control faces; how many
/// faces the one leaves out, and why the other may not be.
void mirror_and_fine_row(PanelContext& context) {
  const float gap = context.px(6);
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, context.colours.dim_text);
  ImGui::TextUnformatted("Mirror");
  ImGui::PopStyleColor();
  ImGui::SameLine(0.0F, context.px(12));
  axis_toggle(context, ActionId::kToggleMirrorX, "X");
  ImGui::SameLine(0.0F, gap);
  axis_toggle(context, ActionId::kToggleMirrorY, "Y");
  ImGui::SameLine(0.0F, gap);
  axis_toggle(context, ActionId::kToggleMirrorZ, "Z");
  ImGui::SameLine(0.0F, context.px(28));
  action_toggle(context, ActionId::kToggleFine, room());
  if (const std::size_t lone = context.model.lone_faces; lone > 0) {
    ImGui::PushStyleColor(ImGuiCol_Text, context.colours.dim_text);
    ImGui::PushFont(context.fonts.small);
    const std::string note =
        counted(lone, "face") + (lone == 1 ? " has no mirror image" : " have no mirror image");
    ImGui::TextUnformatted(fit_text(note, room()).c_str());
    ImGui::PopFont();
    ImGui::PopStyleColor();
  }
  if (const std::string_view why = why_not_fine(context.model); !why.empty()) {
    ImGui::PushFont(context.fonts.small);
    wrapped_text(context, context.colours.dim_text, why);
    ImGui::PopFont();
  }
}

}  // namespace

void draw_paint_section(PanelContext& context) {
  using enum ActionId;
  action_choice(context, std::array{Choice{kBrushAdds, "Add 1"}, Choice{kBrushSets, "Set depth"}});
  target_depth_row(context);
  tool_options(context);
  mirror_and_fine_row(context);

  sub_heading(context, "Whole mesh");
  action_row(context, std::array<Action, 3>{kRaiseAll, kLowerAll, kZeroAll});
  action_row(context, std::array<Action, 2>{kRaiseVisible, kMirrorPainting});
  action_row(context, std::array<Action, 4>{kGrowPainting, kShrinkPainting, kSmoothPainting,
                                            kInvertPainting});

  sub_heading(context, "Sharp places");
  action_slider(context, kSetDihedralThreshold, context.model.dihedral_threshold,
                {.label = "Bent by over", .format = "%.0f°", .low = 0.0, .high = 180.0});
  action_button(context, kRaiseDihedral,
                {.label = with_count(kRaiseDihedral, context.model.dihedral_faces, "face")});
  const double sharpness = context.model.crease_sharpness;
  action_slider(context, kSetCreaseSharpness, sharpness,
                {.label = "Sharpness",
                 .format = sharpness >= double{kInfiniteSharpness} ? "infinite" : "%.1f",
                 .low = 0.0,
                 .high = double{kInfiniteSharpness}});
  action_button(context, kCreaseDihedral,
                {.label = with_count(kCreaseDihedral, context.model.dihedral_edges, "edge")});
  action_button(context, kClearCreases);
}

}  // namespace limn::ui
