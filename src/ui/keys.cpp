#include "ui/keys.h"

#include <optional>

#include "ui/availability.h"
#include "ui/keymap.h"

namespace limn::ui {

std::vector<Action> key_actions(const InputFrame& input, const Model& model, bool wants_text) {
  const bool is_modal = !std::holds_alternative<std::monostate>(model.modal);
  std::vector<Action> actions;
  for (const KeyPress& press : input.presses) {
    const std::optional<Action> action = action_for(model.keymap, {press.key, press.modifiers});
    if (!action || !is_available(model, *action) || (press.is_repeat && !repeats(action->id))) {
      continue;
    }
    const bool is_cancel = action->id == ActionId::kCancel;
    if (is_cancel ? wants_text && !is_modal : is_modal || wants_text) {
      continue;
    }
    actions.push_back(*action);
  }
  return actions;
}

}  // namespace limn::ui
