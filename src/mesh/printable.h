#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace limn::detail {

/// A word from a file, fit for a message: cut to `longest` characters and an ellipsis, and `?` for
/// every byte that is not printable ASCII, since a file need not be UTF-8.
[[nodiscard]] inline std::string printable(std::string_view word, std::size_t longest = 32) {
  std::string shown(word.substr(0, longest));
  for (char& c : shown) {
    if (c < 0x20 || c == 0x7f) {
      c = '?';
    }
  }
  return word.size() > longest ? shown + "..." : shown;
}

}  // namespace limn::detail
