#pragma once

#include <vector>

#include "ui/action.h"
#include "ui/input.h"
#include "ui/model.h"

namespace limn::ui {

/// What the keys pressed in this frame do. While a dialog is open only Esc counts. While a text
/// field has the keyboard (`wants_text`) keys are text: none counts but the Esc that closes a
/// dialog. Actions that are not available are left out, and repeated keys repeat only what may
/// repeat.
[[nodiscard]] std::vector<Action> key_actions(const InputFrame& input, const Model& model,
                                              bool wants_text);

}  // namespace limn::ui
