#pragma once

#include <string>
#include <string_view>

#include "limn/error.h"
#include "limn/painting/selection.h"

namespace limn::rule_text {

/// Reads `all`, `visible`, `painted`, `unpainted`, `dihedral>30`, `curvature>12deg`, `edge<0.01d`,
/// `faces=0,3-9`, `flood=12`, `smart=12,40`, `connected=12`.
/// Errors: kUsage.
[[nodiscard]] Result<Selection> parse_selection(std::string_view text);

/// The selection as `parse_selection` reads it.
[[nodiscard]] std::string to_text(const Selection& selection);

}  // namespace limn::rule_text
