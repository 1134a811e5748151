#pragma once

#include <imgui.h>

#include "ui/gui.h"

namespace limn::ui {

/// The four cuts in use: two weights, and a smaller size of each.
struct Fonts {
  ImFont* body = nullptr;         ///< 15 px.
  ImFont* body_strong = nullptr;  ///< 15 px semi-bold: names, titles.
  ImFont* small = nullptr;        ///< 13 px.
  ImFont* head = nullptr;         ///< 12 px semi-bold: section heads.
};

/// Fills the atlas. All figures of a font get the width of its widest one, so that numbers that
/// change do not move. Damaged or empty font files: ImGui's own font.
[[nodiscard]] Fonts build_fonts(ImFontAtlas& atlas, FontFiles& files, const Scale& scale);

}  // namespace limn::ui
