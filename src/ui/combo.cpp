// A field with the chosen entry, and a popup of its width below it with all of them.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "ui/action_table.h"
#include "ui/availability.h"
#include "ui/widgets.h"

namespace limn::ui {
namespace {

constexpr float kHeight = 28.0F;  // Design units.

void draw_field(const PanelContext& context, std::string_view shown) {
  const ThemeColours& c = context.colours;
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, high, ImGui::IsItemHovered() ? c.control_hovered : c.control,
                     context.px(4));
  const float pad = context.px(10);
  const float y = std::floor((low.y + high.y - ImGui::GetFontSize()) / 2.0F);
  const std::string text = fit_text(shown, high.x - low.x - 3.0F * pad - context.px(8));
  list.AddText({low.x + pad, y}, c.text, text.c_str());
  const ImVec2 tip{high.x - pad - context.px(4), (low.y + high.y) / 2.0F};
  const float r = context.px(4);
  const std::array<ImVec2, 3> chevron{ImVec2{tip.x - r, tip.y - r / 2.0F},
                                      ImVec2{tip.x, tip.y + r / 2.0F},
                                      ImVec2{tip.x + r, tip.y - r / 2.0F}};
  list.AddPolyline(chevron.data(), 3, c.dim_text, ImDrawFlags_None, context.px(1.5F));
}

}  // namespace

void action_combo(PanelContext& context, ActionId what, std::span<const ComboEntry> entries) {
  const auto chosen = std::ranges::find_if(
      entries, [&](const ComboEntry& entry) { return is_checked(context.model, entry.action); });
  const std::string name(info(what).label);
  ImGui::PushID(static_cast<int>(what));
  const float width = room();
  if (ImGui::InvisibleButton("##field", {width, context.px(kHeight)})) {
    ImGui::OpenPopup("##entries");
  }
  draw_field(context, chosen != entries.end() ? std::string_view(chosen->label) : "…");
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  explain(context, what);
  remember(context, name);

  // Below the field, or as far up as is needed to be on the screen.
  const float padding = context.px(8);
  const float spacing = context.px(7);
  const float line = ImGui::GetFontSize() + spacing;
  const float height = static_cast<float>(entries.size()) * line - spacing + 2.0F * padding;
  const float lowest = ImGui::GetIO().DisplaySize.y - height - context.px(4);
  ImGui::SetNextWindowPos(
      {low.x, std::max(0.0F, std::floor(std::min(high.y + context.px(2), lowest)))});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {context.px(10), padding});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {context.px(8), spacing});
  if (ImGui::BeginPopup("##entries")) {
    for (const ComboEntry& entry : entries) {
      const bool is_on = is_checked(context.model, entry.action);
      const bool is_pressed =
          ImGui::Selectable(entry.label.c_str(), is_on, 0, {width - context.px(20), 0.0F});
      // Beside the list: it would hide the entries below.
      context.tooltip_corner = ImVec2(low.x - context.px(28), ImGui::GetItemRectMin().y);
      explain(context, entry.label, entry.meaning);
      context.tooltip_corner.reset();
      remember(context, name + ": " + entry.label);
      if (is_pressed && !is_on) {
        context.emit(entry.action);
      }
    }
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar(2);
  ImGui::PopID();
}

}  // namespace limn::ui
