#pragma once

#include "ui/action.h"
#include "ui/model.h"

namespace limn::ui {

/// Whether the action can do anything now. Buttons and menu entries are dimmed, and keys do
/// nothing, where it cannot.
[[nodiscard]] bool is_available(const Model& model, const Action& action);

/// Flaws of a kind that the surface has.
[[nodiscard]] std::size_t count_of(const Model& model, FlawKind kind);

/// Whether a toggle is on, or one of several choices is the chosen one; false for the others.
[[nodiscard]] bool is_checked(const Model& model, const Action& action);

}  // namespace limn::ui
