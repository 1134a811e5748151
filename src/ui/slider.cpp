// A thin track with a round knob over ImGui's slider, which does the work unseen. The figure stands
// beside it, not under the knob.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <imgui_internal.h>

#include "ui/action_table.h"
#include "ui/widgets.h"

namespace limn::ui {
namespace {

float slider_part(const SliderLook& look, double value) {
  const double part = look.is_logarithmic
                          ? std::log(value / look.low) / std::log(look.high / look.low)
                          : (value - look.low) / (look.high - look.low);
  return static_cast<float>(std::clamp(part, 0.0, 1.0));
}

double rounded_to(double value, int digits) {
  if (value == 0.0) {
    return value;
  }
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) + 1.0 - digits);
  return unit < 1.0 ? std::round(value / unit) / std::round(1.0 / unit)
                    : std::round(value / unit) * unit;
}

/// Track and knob over the slider drawn last; `part` is 0..1.
void draw_slider(const PanelContext& context, float part) {
  const ThemeColours& c = context.colours;
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  const float y = (low.y + high.y) / 2.0F;
  const float radius = context.px(7);
  const float left = low.x + radius;
  const float x = left + (high.x - radius - left) * part;
  const float half = context.px(2);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({low.x, y - half}, {high.x, y + half}, c.control, half);
  list.AddRectFilled({low.x, y - half}, {x, y + half}, faded(c.dim_text, 0.8F), half);
  const bool is_held = ImGui::IsItemActive();
  list.AddCircleFilled({x, y}, radius, c.panel);
  list.AddCircleFilled({x, y}, radius - context.px(1), is_held ? c.accent : c.text);
}

}  // namespace

void action_slider(PanelContext& context, ActionId id, double value, const SliderLook& look) {
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, context.colours.dim_text);
  ImGui::TextUnformatted(look.label.data(), look.label.data() + look.label.size());
  ImGui::PopStyleColor();
  ImGui::SameLine(context.px(108) + ImGui::GetStyle().WindowPadding.x);
  const float value_width = context.px(54);
  ImGui::SetNextItemWidth(room() - value_width);
  ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp;
  if (look.is_logarithmic) {
    flags |= ImGuiSliderFlags_Logarithmic;
  }
  // What is rounded to significant digits, ImGui takes as precisely as may be: it makes of a
  // format's digits the least value of a logarithmic scale.
  const char* format = look.digits > 0 ? "%.10g" : look.format;
  // ImGui's slider does the work unseen, except while a value is typed into it.
  const std::string name = "##" + std::to_string(static_cast<int>(id));
  const bool is_typing = ImGui::TempInputIsActive(ImGui::GetID(name.c_str()));
  if (!is_typing) {
    for (const ImGuiCol which :
         {ImGuiCol_Text, ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive,
          ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive}) {
      ImGui::PushStyleColor(which, 0);
    }
  }
  const double before = value;
  const bool is_changed = ImGui::SliderScalar(name.c_str(), ImGuiDataType_Double, &value, &look.low,
                                              &look.high, format, flags);
  if (is_changed && look.digits > 0 && !is_typing) {
    value = rounded_to(value, look.digits);
  }
  if (!is_typing) {
    ImGui::PopStyleColor(6);
    draw_slider(context, slider_part(look, before));
  }
  std::array<char, 32> text{};
  ImFormatString(text.data(), text.size(), look.format, before);
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  const float text_width = ImGui::CalcTextSize(text.data()).x;
  ImGui::GetWindowDrawList()->AddText({std::floor(high.x + value_width - text_width),
                                       std::floor((low.y + high.y - ImGui::GetFontSize()) / 2.0F)},
                                      context.colours.text, text.data());
  explain(context, id);
  remember(context, info(id).label);
  if (is_changed) {
    context.emit(Action(id, value));
  }
}

}  // namespace limn::ui
