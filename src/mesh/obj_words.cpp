// Words are views into the text they are taken off.
#include "mesh/obj_words.h"

#include <fmt/format.h>

#include "mesh/printable.h"

namespace limn::detail {

std::string_view take_word(std::string_view& text) {
  std::size_t begin = 0;
  while (begin < text.size() && is_blank(text[begin])) {
    ++begin;
  }
  std::size_t end = begin;
  while (end < text.size() && !is_blank(text[end])) {
    ++end;
  }
  std::string_view word = text.substr(begin, end - begin);
  if (word.starts_with('#')) {
    word = {};
    end = text.size();
  }
  text.remove_prefix(end);
  return word;
}

std::string quoted(std::string_view word) {
  return fmt::format("\"{}\"", printable(word));
}

}  // namespace limn::detail
