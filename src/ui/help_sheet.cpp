// Made from the action table and the keymap in use, so it cannot lie. Two columns of groups.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "ui/action_table.h"
#include "ui/keymap.h"
#include "ui/mouse_map.h"
#include "ui/panels.h"
#include "ui/widgets.h"

namespace limn::ui {
namespace {

struct MouseLine {
  std::string_view what;
  std::string_view how;
};

constexpr std::array<MouseLine, 3> kToolMouse{{{"Use the tool", "Left drag"},
                                               {"Lower by 1", "Shift or Ctrl + left drag"},
                                               {"Straight line (lower tool)", "Shift + click"}}};
constexpr std::array<MouseLine, 3> kOtherMouse{{{"Brush size", "Ctrl + wheel"},
                                                {"Type a value", "Ctrl + click on a slider"},
                                                {"Open a file", "Drop it on the window"}}};

std::string_view name_of(CameraGesture gesture) {
  constexpr std::array<std::string_view, kCameraGestureCount> kNames{"Orbit", "Pan", "Zoom"};
  return kNames[static_cast<std::size_t>(gesture)];
}

void line(PanelContext& context, std::string_view what, std::string_view how) {
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const float width = room();
  const float height = context.px(20);
  ImGui::Dummy({width, height});
  const float y = std::floor(start.y + (height - ImGui::GetFontSize()) / 2.0F);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::string keys(how);
  const float keys_width = ImGui::CalcTextSize(keys.c_str()).x;
  const std::string label = fit_text(what, width - keys_width - context.px(12));
  list.AddText({start.x, y}, context.colours.text, label.c_str());
  list.AddText({std::floor(start.x + width - keys_width), y}, context.colours.dim_text,
               keys.c_str());
}

void group_title(PanelContext& context, std::string_view text) {
  ImGui::Dummy({0.0F, context.px(6)});
  ImGui::PushFont(context.fonts.body_strong);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopFont();
}

void group(PanelContext& context, ActionGroup which) {
  group_title(context, heading(which));
  const KeymapId keymap = context.model.keymap;
  for (const ActionInfo& action : action_table()) {
    const bool is_with_number = action.id == ActionId::kSetTargetDepth;
    const std::string keys =
        is_with_number ? std::string("0 to 9, Shift+0 for 10") : all_keys_text(keymap, action.id);
    if (action.group == which && !keys.empty()) {
      line(context, action.label, keys);
      explain(context, action.label, action.tooltip, keys);
    }
  }
}

}  // namespace

void draw_help_sheet(PanelContext& context) {
  ImGui::PushFont(context.fonts.body_strong);
  const bool is_original = context.model.keymap == KeymapId::kOriginal;
  ImGui::TextUnformatted(is_original ? "Keys and mouse: original keys"
                                     : "Keys and mouse: classroom keys");
  ImGui::PopFont();

  const float foot = context.px(28) + ImGui::GetStyle().ItemSpacing.y;
  ImGui::BeginChild("##help", {0.0F, ImGui::GetContentRegionAvail().y - foot});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {context.px(8), context.px(2)});
  const bool is_wide = room() > context.px(640);
  const float gap = context.px(40);
  const float column = is_wide ? std::floor((room() - gap) / 2.0F) : room();
  const auto in_column = [&](const char* id, auto&& contents) {
    ImGui::BeginGroup();
    ImGui::BeginTable(id, 1, ImGuiTableFlags_None, {column, 0.0F});
    ImGui::TableNextColumn();
    contents();
    ImGui::EndTable();
    ImGui::EndGroup();
  };
  in_column("##first", [&] {
    group_title(context, "Mouse");
    for (const MouseLine& entry : kToolMouse) {
      line(context, entry.what, entry.how);
    }
    for (const GestureLine& entry : gesture_lines(context.model.navigation.preset)) {
      line(context, name_of(entry.gesture), entry.how);
      remember(context, "help: " + std::string(entry.how));
    }
    for (const MouseLine& entry : kOtherMouse) {
      line(context, entry.what, entry.how);
    }
    group(context, ActionGroup::kPaint);
    group(context, ActionGroup::kSchemes);
    group(context, ActionGroup::kEdges);
    group(context, ActionGroup::kProgram);
  });
  if (is_wide) {
    ImGui::SameLine(0.0F, gap);
  }
  in_column("##second", [&] {
    group(context, ActionGroup::kFile);
    group(context, ActionGroup::kEdit);
    group(context, ActionGroup::kRefine);
    group(context, ActionGroup::kDisplay);
    group(context, ActionGroup::kCamera);
  });
  ImGui::PopStyleVar();
  ImGui::EndChild();

  const float width = context.px(96);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room() - width);
  action_button(context, ActionId::kCancel, {.label = "Close", .width = width, .is_primary = true});
  if (is_enter_pressed() || ImGui::IsKeyPressed(static_cast<int>(Key::kF1), false)) {
    context.emit(ActionId::kCancel);
  }
}

}  // namespace limn::ui
