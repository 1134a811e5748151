// What was done, a step a line: those that are undone are dim, the one in force is marked, and any
// of them can be gone to. Only lines that show are made.

#include <algorithm>
#include <string>

#include "limn/document/history.h"
#include "ui/format.h"
#include "ui/panels.h"
#include "ui/widgets.h"

namespace limn::ui {
namespace {

constexpr int kListedSteps = 9;

/// "Paint 3 faces"
std::string capitalised(std::string text) {
  if (!text.empty() && text.front() >= 'a' && text.front() <= 'z') {
    text.front() = static_cast<char>(text.front() - 'a' + 'A');
  }
  return text;
}

std::string step_name(const History& history, std::size_t step) {
  if (step > 0) {
    return capitalised(history.name(step - 1));
  }
  return history.has_forgotten() ? "As far back as it goes" : "As opened";
}

void draw_step(PanelContext& context, const History& history, std::size_t step, float height) {
  const ThemeColours& c = context.colours;
  const bool is_current = step == history.position();
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = room();
  ImGui::PushID(static_cast<int>(step));
  const bool is_pressed = ImGui::InvisibleButton("##step", {width, height});
  ImGui::PopID();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 high{low.x + width, low.y + height};
  if (is_current || ImGui::IsItemHovered()) {
    list.AddRectFilled(low, high, is_current ? c.selected : c.control_hovered, context.px(3));
  }
  if (is_current) {
    list.AddRectFilled(low, {low.x + context.px(3), high.y}, c.accent, context.px(1.5F));
  }
  const float pad = context.px(10);
  const bool is_saved = history.saved_position() == step;
  const std::string name = step_name(history, step);
  const std::string shown = fit_text(name, width - 2.0F * pad - (is_saved ? context.px(44) : 0.0F));
  const float y = std::floor(low.y + (height - ImGui::GetFontSize()) / 2.0F);
  list.AddText({low.x + pad, y}, step <= history.position() ? c.text : c.dim_text, shown.c_str());
  if (is_saved) {
    const ImVec2 size = ImGui::CalcTextSize("saved");
    list.AddText({std::floor(high.x - pad - size.x), y}, c.dim_text, "saved");
  }
  explain(context, name, "Undo or redo until the document is as it was after this step.");
  remember(context, "step " + std::to_string(step));
  if (is_pressed && !is_current) {
    context.emit(Action(ActionId::kGoToStep, static_cast<int>(step)));
  }
}

}  // namespace

void draw_history_section(PanelContext& context) {
  const History* history = context.model.history.steps;
  if (history == nullptr) {
    return;
  }
  const float height = context.px(24);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0F, 0.0F});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
  ImGui::BeginChild("##steps", {room(), height * kListedSteps});
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(history->size()) + 1, height);
  while (clipper.Step()) {
    for (int step = clipper.DisplayStart; step < clipper.DisplayEnd; ++step) {
      draw_step(context, *history, static_cast<std::size_t>(step), height);
    }
  }
  clipper.End();
  if (history->size() == 0) {
    ImGui::Dummy({0.0F, context.px(6)});
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + context.px(10));
    empty_note(context, "Nothing was changed yet. What you do is listed here.");
  }
  if (context.state.shown_step != history->position()) {
    context.state.shown_step = history->position();
    const float line = static_cast<float>(history->position()) * height;
    const float top = ImGui::GetScrollY();
    if (line < top || line + height > top + height * kListedSteps) {
      ImGui::SetScrollY(line - height * (kListedSteps / 2));
    }
  }
  ImGui::EndChild();
  ImGui::PopStyleVar(2);
  value_row(context,
            {"Kept", bytes_text(context.model.history.bytes),
             "The memory that undoing needs. Above 256 MiB the oldest steps are forgotten."});
}

}  // namespace limn::ui
