#pragma once

#include <string>

#include "ui/model.h"

namespace limn::ui {

/// "Step 3 of 17"; before the first: "Before the first of 17 steps".
[[nodiscard]] std::string step_count_text(const StepperStatus& steps);

/// Which vertex the next step picks, and why; at the end, what has come of it.
[[nodiscard]] std::string step_reason(const StepperStatus& steps);

/// What a candidate is weighed by: "3 / 1" of the greedy, "1.6" of look-ahead.
[[nodiscard]] std::string step_key(const StepperStatus& steps,
                                   const LegalisationCandidate& candidate);

}  // namespace limn::ui
