#pragma once

#include <imgui.h>

#include "ui/model.h"

namespace limn::ui {

/// The colours of a theme beside ImGui's own table. One accent, kept for what is active.
struct ThemeColours {
  ImU32 panel;
  ImU32 chrome;  ///< Menu bar, tool strip, status line.
  ImU32 popup;
  ImU32 text;
  ImU32 dim_text;
  ImU32 hairline;
  ImU32 field;    ///< What holds a value: tracks, text fields.
  ImU32 control;  ///< What can be pressed.
  ImU32 control_hovered;
  ImU32 control_pressed;
  ImU32 selected;  ///< The chosen one of several.
  ImU32 accent;
  ImU32 on_accent;  ///< Text over the accent.
  ImU32 problem;
  ImU32 overlay;  ///< Ground of what lies over the viewport.
};

[[nodiscard]] const ThemeColours& theme_colours(Theme theme) noexcept;

/// Palette colour of a depth; those past the palette's end have its last.
[[nodiscard]] ImU32 swatch_colour(int depth) noexcept;
/// Black or white, whichever reads better on that colour.
[[nodiscard]] ImU32 text_on_swatch(int depth) noexcept;

/// The same colour with its alpha multiplied.
[[nodiscard]] ImU32 faded(ImU32 colour, float alpha) noexcept;

/// Sets ImGui's style: `unit` is window units per design unit.
void apply_style(ImGuiStyle& style, Theme theme, float unit);

}  // namespace limn::ui
