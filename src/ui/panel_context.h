#pragma once

#include <imgui.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "ui/action.h"
#include "ui/fonts.h"
#include "ui/gui.h"
#include "ui/input.h"
#include "ui/model.h"
#include "ui/theme.h"

namespace limn::ui {

/// What the panels remember from frame to frame.
struct UiState {
  PanelLayout layout;
  std::size_t open_modal = 0;  ///< Index in Modal of what was drawn last; 0 is none.

  struct PathPromptState {
    std::uint64_t serial = 0;  ///< Of the prompt the fields belong to; 0 is none.
    std::string folder;        ///< As typed.
    std::string name;
    std::string listed_folder;  ///< The model's folder that `folder` was last set from.
    bool wants_focus = false;
  } path_prompt;

  std::string preset_name;     ///< As typed.
  std::size_t shown_step = 0;  ///< Position of the history that its list was last scrolled to.

  double hover_seconds = 0.0;  ///< How long the cursor has rested on the same control.
  ImGuiID hovered_control = 0;
  bool awaits_tooltip = false;  ///< It has not rested there long enough yet.
};

/// What one panel needs to draw itself and to say what the person wants.
struct PanelContext {
  const Model& model;
  const InputFrame& input;
  UiState& state;
  const Fonts& fonts;
  const ThemeColours& colours;
  float unit;  ///< Window units per design unit.
  std::vector<Action>& actions;
  std::vector<ItemRect>& items;
  /// Where the upper right corner of the next tooltip goes; nothing: beside the cursor.
  std::optional<ImVec2> tooltip_corner{};
  std::string hint;  ///< What the control under the cursor does; for the status line.

  [[nodiscard]] float px(float design_units) const { return design_units * unit; }
  void emit(Action action) { actions.push_back(std::move(action)); }
};

}  // namespace limn::ui
