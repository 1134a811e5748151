#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ui/icons.h"
#include "ui/panel_context.h"

/// The few kinds of control that Limn's panels are made of. Those that take an action show its
/// label, dim themselves where it is not available, explain it in a tooltip that names its keys,
/// and emit it.
namespace limn::ui {

struct ButtonLook {
  std::string_view label = {};  ///< In place of the action's own.
  float width = 0.0F;           ///< Window units; 0: as wide as there is room.
  bool is_primary = false;      ///< In the accent colour: the one thing to do here.
};
/// True when pressed.
bool action_button(PanelContext& context, const Action& action, const ButtonLook& look = {});

/// A button of the primary look that emits nothing; true when pressed.
[[nodiscard]] bool plain_button(PanelContext& context, std::string_view label, float width,
                                bool is_enabled);

/// A square button with an icon, marked where the action is checked.
bool icon_button(PanelContext& context, const Action& action, Icon icon, float side);

/// A row of buttons, of equal width unless a name needs more than its share.
void action_row(PanelContext& context, std::span<const Action> actions);

/// A check box with its label, `width` wide.
void action_toggle(PanelContext& context, const Action& action, float width);

/// One of several things side by side, under a name short enough for its place.
struct Choice {
  Action action;
  std::string_view label;
};
void action_choice(PanelContext& context, std::span<const Choice> choices);

/// One of many things, in a list that unfolds below.
struct ComboEntry {
  Action action;
  std::string label;
  std::string meaning;  ///< Tooltip.
};
/// `what` explains the choice as a whole; `entries` are of that action. Shows the entry that is
/// checked.
void action_combo(PanelContext& context, ActionId what, std::span<const ComboEntry> entries);

/// A menu entry with its key.
void action_menu_item(PanelContext& context, const Action& action, std::string_view label = {});

struct SliderLook {
  std::string_view label;       ///< Before the slider.
  const char* format = "%.0f";  ///< printf, one double.
  double low = 0.0;
  double high = 1.0;
  bool is_logarithmic = false;
  int digits = 0;  ///< Significant ones that values are rounded to; 0: as many as `format` shows.
};
/// Emits `id` with the new value while it is dragged.
void action_slider(PanelContext& context, ActionId id, double value, const SliderLook& look);

/// A heading that folds what is below it; true where that is to be drawn.
[[nodiscard]] bool begin_section(PanelContext& context, const char* title, bool& is_open);

/// Dim lines in the place of what is not there yet: what would fill it.
void empty_note(PanelContext& context, std::string_view text);

/// Text over several lines in the room there is.
void wrapped_text(const PanelContext& context, ImU32 colour, std::string_view text);

/// A dim heading within a section.
void sub_heading(PanelContext& context, std::string_view text);

struct ValueRow {
  std::string_view label;
  std::string value;         ///< Right-aligned.
  std::string_view meaning;  ///< Tooltip.
  bool is_problem = false;
};
/// A label and its figure on one line. Always as high, whatever the value.
void value_row(PanelContext& context, const ValueRow& row);

/// Text on one line, cut with an ellipsis where it does not fit into `width`.
[[nodiscard]] std::string fit_text(std::string_view text, float width);

/// Tooltip and status hint of the item drawn last.
void explain(PanelContext& context, const Action& action);
void explain(PanelContext& context, std::string_view title, std::string_view text,
             std::string_view keys = {});
/// The same of what is drawn under the cursor without being an item.
void explain_here(PanelContext& context, const Action& action);
void explain_here(PanelContext& context, std::string_view title, std::string_view text,
                  std::string_view keys = {});

/// Remembers where the item drawn last is.
void remember(PanelContext& context, std::string_view name);

/// The width that is left in the line.
[[nodiscard]] float room();

}  // namespace limn::ui
