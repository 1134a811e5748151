#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ui/action.h"
#include "ui/input.h"
#include "ui/model.h"

namespace limn::ui {

/// A key with the modifiers held beside it.
struct Chord {
  Key key = Key::kEscape;
  Modifiers modifiers;

  [[nodiscard]] bool operator==(const Chord&) const = default;
};

/// A chord and what it does.
struct Binding {
  Chord chord;
  Action action;
};

/// Every binding of a keymap, those that all keymaps share included. No chord stands twice.
[[nodiscard]] std::span<const Binding> bindings(KeymapId keymap);

/// The action of a chord; nothing where the keymap leaves it free.
[[nodiscard]] std::optional<Action> action_for(KeymapId keymap, const Chord& chord);

/// The chord to name in tooltips and menus: the first one bound to that very action.
[[nodiscard]] std::optional<Chord> chord_for(KeymapId keymap, const Action& action);

/// "Ctrl+Shift+Z", "Space", "[", "Numpad 1".
[[nodiscard]] std::string to_text(const Chord& chord);
/// Reads what `to_text` writes; nothing for anything else.
[[nodiscard]] std::optional<Chord> chord_from_text(std::string_view text);

/// "Ctrl+Z" of the action in this keymap; empty where it has no key.
[[nodiscard]] std::string key_text(KeymapId keymap, const Action& action);

/// "Ctrl+Z or B": every chord of the action; empty where it has none.
[[nodiscard]] std::string all_keys_text(KeymapId keymap, const Action& action);

/// Whether holding the key down repeats the action (brush size, zoom, undo).
[[nodiscard]] bool repeats(ActionId id) noexcept;

}  // namespace limn::ui
