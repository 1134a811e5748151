#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "limn/error.h"

// What the readers of paint rules and crease rules share.
namespace limn::rule_text {

/// Without the blanks at either end.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// The text in quotes, fit for a message: short, and without control characters.
[[nodiscard]] std::string quoted(std::string_view text);

/// kUsage.
[[nodiscard]] tl::unexpected<Error> misread(std::string message);

/// A whole text as an angle from 0 to `most` degrees; nothing where it is none.
[[nodiscard]] std::optional<double> read_degrees(std::string_view text, double most = 180.0);

/// A whole text of digits alone, no sign; nothing where it is anything else, or too big.
[[nodiscard]] std::optional<std::uint32_t> read_whole_number(std::string_view text);

}  // namespace limn::rule_text
