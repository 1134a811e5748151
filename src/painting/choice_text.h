#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "limn/error.h"
#include "limn/painting/depth_choice.h"

namespace limn::rule_text {

/// Whether a rule begins as one that chooses depths: "tolerance", "budget", "screen" or "curve" and
/// "=".
[[nodiscard]] bool is_choice(std::string_view text);

/// Reads `tolerance=0.001d`, `tolerance=0.5px@camera.json`, `budget=50000`,
/// `budget=20000t,greatest`, `screen=4px`, `screen=16px2,silhouettes=2@a.json@b.json`,
/// `curve=curvature,5/0,40/3`. Errors: kUsage.
[[nodiscard]] Result<DepthChoice> parse_choice(std::string_view text);

/// A word for how depths go together, as in `tolerance=0.001d:max`; nothing where it is none.
[[nodiscard]] std::optional<DepthMerge> parse_merge(std::string_view word);

/// As the functions above read them.
[[nodiscard]] std::string to_text(const DepthChoice& choice);
[[nodiscard]] std::string_view to_text(DepthMerge merge);

/// A value with the measure's unit, which may be left out: "12deg". Nothing where it is none.
[[nodiscard]] std::optional<double> read_measure(FaceMeasure measure, std::string_view text);

}  // namespace limn::rule_text
