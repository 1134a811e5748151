#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace limn::detail {

/// Reads a whole word as a decimal number, correctly rounded, whatever the locale; also `nan` and
/// `inf`. Numbers too large for a double become infinite, ones too small 0.
[[nodiscard]] bool parse_number(std::string_view word, double& value);

/// Reads a whole word as an integer, perhaps with a sign; nothing where it is none or does not fit
/// 64 bits.
[[nodiscard]] std::optional<std::int64_t> parse_index(std::string_view word);

}  // namespace limn::detail
