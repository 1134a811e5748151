#pragma once

#include <string_view>

#include "ui/action.h"
#include "ui/model.h"

namespace limn::ui {

/// Whether the action can do anything now. Buttons and menu entries are dimmed, and keys do
/// nothing, where it cannot.
[[nodiscard]] bool is_available(const Model& model, const Action& action);

/// Why not, a sentence, where the person cannot be expected to see it; empty otherwise.
[[nodiscard]] std::string_view why_unavailable(const Model& model, const Action& action);

/// Why the tool in hand takes control faces although *Fine* is on, a sentence; empty where it is
/// off or does not.
[[nodiscard]] std::string_view why_not_fine(const Model& model);

/// What is painted to each depth, as the legend counts it: control faces, and pieces of them that
/// finer faces are painted to by themselves.
[[nodiscard]] DepthCounts painted_counts(const Model& model);

/// Flaws of a kind that the surface has.
[[nodiscard]] std::size_t count_of(const Model& model, FlawKind kind);

/// Whether a toggle is on, or one of several choices is the chosen one; false for the others.
[[nodiscard]] bool is_checked(const Model& model, const Action& action);

}  // namespace limn::ui
