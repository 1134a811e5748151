#pragma once

#include <string>
#include <string_view>

namespace limn::detail {

[[nodiscard]] constexpr bool is_blank(char c) noexcept {
  return c == ' ' || c == '\t';
}

/// Takes the first word off `text`; empty at the end and before a comment.
[[nodiscard]] std::string_view take_word(std::string_view& text);

/// A word of a file in quotes, fit for a message.
[[nodiscard]] std::string quoted(std::string_view word);

}  // namespace limn::detail
