// Controls are ImGui's where its own look will do, and otherwise an invisible button with a
// drawing over it.

#include "ui/widgets.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "ui/action_table.h"
#include "ui/availability.h"
#include "ui/keymap.h"

namespace limn::ui {
namespace {

constexpr double kTooltipDelay = 0.45;  // Seconds.
constexpr float kButtonHeight = 28.0F;  // Design units.

std::string widget_id(const Action& action) {
  std::string id = "##" + std::to_string(static_cast<int>(action.id));
  if (const int* number = std::get_if<int>(&action.value)) {
    id += ':' + std::to_string(*number);
  } else if (const auto* text = std::get_if<std::string>(&action.value)) {
    id += ':' + *text;
  }
  return id;
}

std::string_view label_of(const Action& action, std::string_view instead) {
  return instead.empty() ? info(action.id).label : instead;
}

ImVec2 text_size(std::string_view text) {
  return ImGui::CalcTextSize(text.data(), text.data() + text.size());
}

void draw_text(ImVec2 at, ImU32 colour, std::string_view text) {
  ImGui::GetWindowDrawList()->AddText(at, colour, text.data(), text.data() + text.size());
}

ImVec2 item_centre() {
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  return {(low.x + high.x) / 2.0F, (low.y + high.y) / 2.0F};
}

void draw_centred(ImU32 colour, std::string_view text) {
  const ImVec2 size = text_size(text);
  const ImVec2 centre = item_centre();
  draw_text({std::floor(centre.x - size.x / 2.0F), std::floor(centre.y - size.y / 2.0F)}, colour,
            text);
}

ImU32 control_fill(const ThemeColours& colours) {
  if (ImGui::IsItemActive()) {
    return colours.control_pressed;
  }
  return ImGui::IsItemHovered() ? colours.control_hovered : colours.control;
}

void fill_item(ImU32 colour, float rounding) {
  ImGui::GetWindowDrawList()->AddRectFilled(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                            colour, rounding);
}

/// The face of a button over the item drawn last.
void draw_button(const PanelContext& context, std::string_view whole_label, bool is_enabled,
                 bool is_primary) {
  const ThemeColours& c = context.colours;
  const std::string label = fit_text(whole_label, ImGui::GetItemRectSize().x);
  const float rounding = context.px(4);
  if (is_primary && is_enabled) {
    const float strength = ImGui::IsItemActive() ? 0.8F : (ImGui::IsItemHovered() ? 0.92F : 1.0F);
    fill_item(faded(c.accent, strength), rounding);
    draw_centred(c.on_accent, label);
    return;
  }
  fill_item(is_enabled ? control_fill(c) : faded(c.control, 0.5F), rounding);
  draw_centred(is_enabled ? c.text : faded(c.dim_text, 0.6F), label);
}

/// Between ImGui::BeginDisabled and EndDisabled.
bool is_in_disabled_part() {
  return (ImGui::GetCurrentContext()->CurrentItemFlags & ImGuiItemFlags_Disabled) != 0;
}

/// Where each of several names side by side ends: all of one width, unless a name needs more than
/// that.
std::vector<float> ends_of(const PanelContext& context, std::span<const std::string_view> names,
                           float width) {
  const auto count = static_cast<float>(names.size());
  std::vector<float> ends(names.size());
  float named = 0.0F;
  float longest = 0.0F;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const float name = text_size(names[i]).x;
    named += name;
    longest = std::max(longest, name);
    ends[i] = named;
  }
  const bool fits = longest + context.px(10) <= width / count;
  const float rest = (width - named) / count;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const auto place = static_cast<float>(i + 1);
    ends[i] = fits ? width * place / count : ends[i] + rest * place;
  }
  return ends;
}

}  // namespace

float room() {
  return ImGui::GetContentRegionAvail().x;
}

std::string fit_text(std::string_view text, float width) {
  if (text_size(text).x <= width) {
    return std::string(text);
  }
  std::string cut(text);
  const auto ends_in_continuation = [&cut] {
    return !cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xC0U) == 0x80U;
  };
  while (!cut.empty() && text_size(cut + "…").x > width) {
    while (ends_in_continuation()) {
      cut.pop_back();
    }
    if (!cut.empty()) {
      cut.pop_back();
    }
  }
  return cut + "…";
}

void remember(PanelContext& context, std::string_view name) {
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 size = ImGui::GetItemRectSize();
  context.items.push_back({std::string(name), {{low.x, low.y}, {size.x, size.y}}});
}

void explain(PanelContext& context, const Action& action) {
  std::string text(info(action.id).tooltip);
  if (const std::string_view why = why_unavailable(context.model, action); !why.empty()) {
    text += '\n';
    text += why;
  }
  explain(context, info(action.id).label, text, all_keys_text(context.model.keymap, action));
}

void explain(PanelContext& context, std::string_view title, std::string_view text,
             std::string_view keys) {
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
    explain_here(context, title, text, keys);
  }
}

void explain_here(PanelContext& context, const Action& action) {
  explain_here(context, info(action.id).label, info(action.id).tooltip,
               all_keys_text(context.model.keymap, action));
}

void explain_here(PanelContext& context, std::string_view title, std::string_view text,
                  std::string_view keys) {
  context.hint = std::string(title) + ": " + std::string(text);
  std::replace(context.hint.begin(), context.hint.end(), '\n', ' ');
  const ImGuiID id = ImGui::GetID(title.data(), title.data() + title.size());
  if (context.state.hovered_control != id) {
    context.state.hovered_control = id;
    context.state.hover_seconds = 0.0;
  } else {
    context.state.hover_seconds += ImGui::GetIO().DeltaTime;
  }
  if (ImGui::IsAnyMouseDown()) {
    return;
  }
  if (context.state.hover_seconds < kTooltipDelay) {
    context.state.awaits_tooltip = true;
    return;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {context.px(12), context.px(10)});
  if (context.tooltip_corner) {
    ImGui::SetNextWindowPos(*context.tooltip_corner, ImGuiCond_Always, {1.0F, 0.0F});
  }
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(context.px(300));
  ImGui::PushFont(context.fonts.body_strong);
  ImGui::TextUnformatted(title.data(), title.data() + title.size());
  ImGui::PopFont();
  if (!keys.empty()) {
    ImGui::SameLine(0.0F, context.px(12));
    ImGui::PushStyleColor(ImGuiCol_Text, context.colours.dim_text);
    ImGui::TextUnformatted(keys.data(), keys.data() + keys.size());
    ImGui::PopStyleColor();
  }
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

bool plain_button(PanelContext& context, std::string_view label, float width, bool is_enabled) {
  const std::string id(label);
  const bool is_pressed = ImGui::InvisibleButton(id.c_str(), {width, context.px(kButtonHeight)});
  draw_button(context, label, is_enabled, true);
  remember(context, label);
  return is_pressed;
}

bool action_button(PanelContext& context, const Action& action, const ButtonLook& look) {
  const std::string_view label = label_of(action, look.label);
  const bool is_enabled = is_available(context.model, action) && !is_in_disabled_part();
  ImGui::BeginDisabled(!is_enabled);
  const float width = look.width > 0.0F ? look.width : room();
  const bool is_pressed =
      ImGui::InvisibleButton(widget_id(action).c_str(), {width, context.px(kButtonHeight)});
  ImGui::EndDisabled();
  draw_button(context, label, is_enabled, look.is_primary);
  explain(context, action);
  remember(context, label);
  if (is_pressed) {
    context.emit(action);
  }
  return is_pressed;
}

bool icon_button(PanelContext& context, const Action& action, Icon icon, float side) {
  const bool is_enabled = is_available(context.model, action);
  const bool is_on = is_checked(context.model, action);
  ImGui::BeginDisabled(!is_enabled);
  const bool is_pressed = ImGui::InvisibleButton(widget_id(action).c_str(), {side, side});
  ImGui::EndDisabled();
  const ThemeColours& c = context.colours;
  ImU32 ink = is_enabled ? c.dim_text : faded(c.dim_text, 0.4F);
  if (is_on) {
    fill_item(c.accent, context.px(4));
    ink = c.on_accent;
  } else if (is_enabled && ImGui::IsItemHovered()) {
    fill_item(control_fill(c), context.px(4));
    ink = c.text;
  }
  draw_icon(*ImGui::GetWindowDrawList(), icon, item_centre(), context.px(22), ink);
  explain(context, action);
  remember(context, "tool: " + std::string(info(action.id).label));
  if (is_pressed) {
    context.emit(action);
  }
  return is_pressed;
}

void action_row(PanelContext& context, std::span<const Action> actions) {
  const float gap = context.px(6);
  const auto count = static_cast<float>(actions.size());
  std::vector<std::string_view> names;
  for (const Action& action : actions) {
    names.push_back(info(action.id).label);
  }
  const std::vector<float> ends = ends_of(context, names, room() - gap * (count - 1.0F));
  for (std::size_t i = 0; i < actions.size(); ++i) {
    if (i > 0) {
      ImGui::SameLine(0.0F, gap);
    }
    const float begin = i > 0 ? std::floor(ends[i - 1]) : 0.0F;
    action_button(context, actions[i], {.width = std::floor(ends[i]) - begin});
  }
}

void action_toggle(PanelContext& context, const Action& action, float width) {
  const bool is_on = is_checked(context.model, action);
  const bool is_enabled = is_available(context.model, action);
  const float strength = is_enabled ? 1.0F : 0.45F;
  const float height = context.px(26);
  ImGui::BeginDisabled(!is_enabled);
  const bool is_pressed = ImGui::InvisibleButton(widget_id(action).c_str(), {width, height});
  ImGui::EndDisabled();
  const ThemeColours& c = context.colours;
  const ImVec2 low = ImGui::GetItemRectMin();
  const float side = context.px(16);
  const ImVec2 box{low.x, std::floor(low.y + (height - side) / 2.0F)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 off = ImGui::IsItemHovered() ? c.control_hovered : c.control;
  list.AddRectFilled(box, {box.x + side, box.y + side}, faded(is_on ? c.accent : off, strength),
                     context.px(4));
  if (is_on) {
    const std::array<ImVec2, 3> tick{ImVec2{box.x + side * 0.24F, box.y + side * 0.52F},
                                     ImVec2{box.x + side * 0.43F, box.y + side * 0.71F},
                                     ImVec2{box.x + side * 0.77F, box.y + side * 0.31F}};
    list.AddPolyline(tick.data(), static_cast<int>(tick.size()), c.on_accent, ImDrawFlags_None,
                     context.px(1.8F));
  }
  const std::string_view label = info(action.id).label;
  draw_text(
      {box.x + side + context.px(8), std::floor(low.y + (height - ImGui::GetFontSize()) / 2.0F)},
      faded(c.text, strength), fit_text(label, width - side - context.px(8)));
  explain(context, action);
  remember(context, label);
  if (is_pressed) {
    context.emit(Action(action.id, !is_on));
  }
}

void action_choice(PanelContext& context, std::span<const Choice> choices) {
  const ThemeColours& c = context.colours;
  const float height = context.px(kButtonHeight);
  const float width = room();
  std::vector<std::string_view> names;
  for (const Choice& choice : choices) {
    names.push_back(choice.label);
  }
  const std::vector<float> ends = ends_of(context, names, width);
  const float inset = context.px(3);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(origin, {origin.x + width, origin.y + height}, c.field, context.px(5));
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const Action& action = choices[i].action;
    const float left = std::floor(origin.x + (i > 0 ? ends[i - 1] : 0.0F));
    const float right = std::floor(origin.x + ends[i]);
    ImGui::SetCursorScreenPos({left, origin.y});
    const bool is_pressed =
        ImGui::InvisibleButton(widget_id(action).c_str(), {right - left, height});
    const bool is_on = is_checked(context.model, action);
    const bool is_offered = is_available(context.model, action);
    if (is_on) {
      list.AddRectFilled({left + inset, origin.y + inset},
                         {right - inset, origin.y + height - inset}, c.selected, context.px(4));
    }
    const ImU32 ink = is_on || ImGui::IsItemHovered() ? c.text : c.dim_text;
    draw_centred(is_offered ? ink : faded(c.dim_text, 0.6F),
                 fit_text(choices[i].label, right - left - context.px(4)));
    explain(context, action);
    remember(context, choices[i].label);
    if (is_pressed && !is_on && is_offered) {
      context.emit(action);
    }
  }
}

void action_menu_item(PanelContext& context, const Action& action, std::string_view label) {
  const std::string text(label_of(action, label));
  const bool is_on = is_checked(context.model, action);
  const bool is_pressed = ImGui::MenuItem((text + widget_id(action)).c_str(),
                                          key_text(context.model.keymap, action).c_str(), is_on,
                                          is_available(context.model, action));
  explain(context, action);
  remember(context, "menu: " + text);
  if (is_pressed) {
    context.emit(action);
  }
}

bool begin_section(PanelContext& context, const char* title, bool& is_open) {
  const ThemeColours& c = context.colours;
  const float padding = ImGui::GetStyle().WindowPadding.x;
  const ImVec2 start = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float left = start.x - padding;
  const float width = room() + 2.0F * padding;
  if (ImGui::GetCursorPosY() > context.px(16)) {
    list.AddLine({left, start.y}, {left + width, start.y}, c.hairline, 1.0F);
  }
  const float height = context.px(34);
  if (ImGui::InvisibleButton(title, {room(), height})) {
    is_open = !is_open;
  }
  const ImU32 ink = ImGui::IsItemHovered() ? c.text : c.dim_text;
  ImGui::PushFont(context.fonts.head);
  draw_text({start.x, std::floor(start.y + (height - ImGui::GetFontSize()) / 2.0F)}, ink, title);
  ImGui::PopFont();
  const ImVec2 tip{start.x + room() - context.px(6), start.y + height / 2.0F};
  const float r = context.px(4);
  const std::array<ImVec2, 3> chevron =
      is_open
          ? std::array<ImVec2, 3>{ImVec2{tip.x - r, tip.y - r / 2}, ImVec2{tip.x, tip.y + r / 2},
                                  ImVec2{tip.x + r, tip.y - r / 2}}
          : std::array<ImVec2, 3>{ImVec2{tip.x - r / 2, tip.y - r}, ImVec2{tip.x + r / 2, tip.y},
                                  ImVec2{tip.x - r / 2, tip.y + r}};
  list.AddPolyline(chevron.data(), 3, ink, ImDrawFlags_None, context.px(1.5F));
  explain(context, title,
          is_open ? "Click to fold this section." : "Click to unfold this section.");
  remember(context, title);
  return is_open;
}

void empty_note(PanelContext& context, std::string_view text) {
  ImGui::PushFont(context.fonts.small);
  ImGui::PushStyleColor(ImGuiCol_Text, context.colours.dim_text);
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + room());
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ImGui::PopFont();
  remember(context, text);
}

void sub_heading(PanelContext& context, std::string_view text) {
  ImGui::Dummy({0.0F, context.px(2)});
  ImGui::PushFont(context.fonts.small);
  ImGui::PushStyleColor(ImGuiCol_Text, context.colours.dim_text);
  ImGui::TextUnformatted(fit_text(text, room()).c_str());
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

void value_row(PanelContext& context, const ValueRow& row) {
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const float width = room();
  const float height = context.px(22);
  ImGui::Dummy({width, height});
  const float baseline = std::floor(start.y + (height - ImGui::GetFontSize()) / 2.0F);
  draw_text({start.x, baseline}, context.colours.dim_text, row.label);
  const float label_width = text_size(row.label).x + context.px(12);
  const std::string value = fit_text(row.value, width - label_width);
  draw_text({std::floor(start.x + width - text_size(value).x), baseline},
            row.is_problem ? context.colours.problem : context.colours.text, value);
  remember(context, "value: " + std::string(row.label));
  explain(context, row.label, row.meaning);
}

void wrapped_text(const PanelContext& context, ImU32 colour, std::string_view text) {
  ImGui::PushFont(context.fonts.small);
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::PushTextWrapPos(0.0F);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

}  // namespace limn::ui
