// Greys from a few steps of lightness, one accent, corners of 4 units, hairlines instead of boxes.

#include "ui/theme.h"

#include <algorithm>

#include "limn/painting/depth_palette.h"

namespace limn::ui {
namespace {

constexpr ImU32 rgb(unsigned hex, unsigned alpha = 0xFF) {
  return IM_COL32((hex >> 16U) & 0xFFU, (hex >> 8U) & 0xFFU, hex & 0xFFU, alpha);
}

constexpr ThemeColours kDark{
    .panel = rgb(0x242629),
    .chrome = rgb(0x1E2023),
    .popup = rgb(0x2B2E32),
    .text = rgb(0xE6E6E6),
    .dim_text = rgb(0x9AA0A6),
    .hairline = rgb(0x383B40),
    .field = rgb(0x191A1D),
    .control = rgb(0x36393E),
    .control_hovered = rgb(0x41454B),
    .control_pressed = rgb(0x4C5158),
    .selected = rgb(0x484C53),
    .accent = rgb(0xF5A623),
    .on_accent = rgb(0x1B1C1F),
    .problem = rgb(0xE8559F),
    .overlay = rgb(0x1E2023, 0xD8),
};

constexpr ThemeColours kLight{
    .panel = rgb(0xF7F8FA),
    .chrome = rgb(0xECEEF1),
    .popup = rgb(0xFFFFFF),
    .text = rgb(0x202124),
    .dim_text = rgb(0x5F6368),
    .hairline = rgb(0xD3D6DB),
    .field = rgb(0xEBEDF1),
    .control = rgb(0xE1E4E9),
    .control_hovered = rgb(0xD6DAE0),
    .control_pressed = rgb(0xC9CED6),
    .selected = rgb(0xFFFFFF),
    .accent = rgb(0xF5A623),
    .on_accent = rgb(0x1B1C1F),
    .problem = rgb(0xC01F80),
    .overlay = rgb(0xF7F8FA, 0xE0),
};

ImU32 opaque(Rgb colour) {
  return IM_COL32(colour.red, colour.green, colour.blue, 0xFF);
}

}  // namespace

const ThemeColours& theme_colours(Theme theme) noexcept {
  return theme == Theme::kDark ? kDark : kLight;
}

ImU32 swatch_colour(int depth) noexcept {
  return opaque(depth_colour(depth));
}

ImU32 text_on_swatch(int depth) noexcept {
  return opaque(text_colour_on(depth_colour(depth)));
}

ImU32 faded(ImU32 colour, float alpha) noexcept {
  const float old = static_cast<float>(colour >> IM_COL32_A_SHIFT);
  const auto alpha_byte = static_cast<ImU32>(old * std::clamp(alpha, 0.0F, 1.0F) + 0.5F);
  return (colour & ~IM_COL32_A_MASK) | (alpha_byte << IM_COL32_A_SHIFT);
}

void apply_style(ImGuiStyle& style, Theme theme, float unit) {
  style = ImGuiStyle();
  const ThemeColours& c = theme_colours(theme);

  style.WindowPadding = {16.0F, 12.0F};
  style.WindowRounding = 0.0F;
  style.WindowBorderSize = 0.0F;
  style.ChildRounding = 4.0F;
  style.ChildBorderSize = 1.0F;
  style.PopupRounding = 4.0F;
  style.PopupBorderSize = 1.0F;
  style.FramePadding = {10.0F, 5.0F};
  style.FrameRounding = 4.0F;
  style.ItemSpacing = {8.0F, 8.0F};
  style.ItemInnerSpacing = {8.0F, 4.0F};
  style.CellPadding = {4.0F, 2.0F};
  style.IndentSpacing = 16.0F;
  style.ScrollbarSize = 10.0F;
  style.ScrollbarRounding = 5.0F;
  style.GrabMinSize = 12.0F;
  style.GrabRounding = 3.0F;
  style.WindowMinSize = {16.0F, 16.0F};
  style.ScaleAllSizes(unit);
  style.ChildBorderSize = 1.0F;
  style.PopupBorderSize = 1.0F;

  const auto set = [&style](ImGuiCol which, ImU32 colour) {
    style.Colors[which] = ImGui::ColorConvertU32ToFloat4(colour);
  };
  for (int i = 0; i < ImGuiCol_COUNT; ++i) {
    set(i, c.control);
  }
  const bool is_dark = theme == Theme::kDark;
  set(ImGuiCol_Text, c.text);
  set(ImGuiCol_TextDisabled, faded(c.dim_text, 0.7F));
  set(ImGuiCol_WindowBg, c.panel);
  set(ImGuiCol_ChildBg, faded(c.field, 0.0F));
  set(ImGuiCol_PopupBg, c.popup);
  set(ImGuiCol_Border, c.hairline);
  set(ImGuiCol_BorderShadow, 0);
  set(ImGuiCol_FrameBg, c.field);
  set(ImGuiCol_FrameBgHovered, is_dark ? rgb(0x1F2124) : rgb(0xDEE1E6));
  set(ImGuiCol_FrameBgActive, is_dark ? rgb(0x1F2124) : rgb(0xDEE1E6));
  set(ImGuiCol_MenuBarBg, c.chrome);
  set(ImGuiCol_ScrollbarBg, 0);
  set(ImGuiCol_ScrollbarGrab, c.control);
  set(ImGuiCol_ScrollbarGrabHovered, c.control_hovered);
  set(ImGuiCol_ScrollbarGrabActive, c.control_pressed);
  set(ImGuiCol_CheckMark, c.accent);
  set(ImGuiCol_SliderGrab, is_dark ? rgb(0x5D636B) : rgb(0xAEB4BD));
  set(ImGuiCol_SliderGrabActive, c.accent);
  set(ImGuiCol_Button, c.control);
  set(ImGuiCol_ButtonHovered, c.control_hovered);
  set(ImGuiCol_ButtonActive, c.control_pressed);
  set(ImGuiCol_Header, faded(c.accent, 0.28F));
  set(ImGuiCol_HeaderHovered, c.control_hovered);
  set(ImGuiCol_HeaderActive, c.control_pressed);
  set(ImGuiCol_Separator, c.hairline);
  set(ImGuiCol_SeparatorHovered, c.accent);
  set(ImGuiCol_SeparatorActive, c.accent);
  set(ImGuiCol_ResizeGrip, 0);
  set(ImGuiCol_PlotHistogram, c.accent);
  set(ImGuiCol_TextSelectedBg, faded(c.accent, 0.35F));
  set(ImGuiCol_NavHighlight, c.accent);
  set(ImGuiCol_ModalWindowDimBg, IM_COL32(0, 0, 0, 0x73));
}

}  // namespace limn::ui
