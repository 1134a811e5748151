// Plain pointers: every byte is looked at once, and a backslash's blanks twice.
#include "mesh/formats/text_cursor.h"

namespace limn::detail {

std::string_view without_byte_order_mark(std::string_view text) noexcept {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

TextCursor::TextCursor(std::string_view text, TextRules rules) : rules_(rules) {
  text = without_byte_order_mark(text);
  at_ = text.data();
  end_ = text.data() + text.size();
}

bool TextCursor::is_continuation(const char* backslash) const noexcept {
  const char* after = backslash + 1;
  while (after < end_ && is_blank(*after)) {
    ++after;
  }
  return after == end_ || is_line_end(*after);
}

void TextCursor::take_line_end() noexcept {
  if (at_ < end_) {
    const bool is_pair = *at_ == '\r' && at_ + 1 < end_ && at_[1] == '\n';
    at_ += is_pair ? 2 : 1;
    ++line_;
  }
}

void TextCursor::skip_line() noexcept {
  while (at_ < end_ && !is_line_end(*at_)) {
    ++at_;
  }
}

bool TextCursor::next_line() {
  skip_line();
  take_line_end();
  return at_ < end_;
}

std::string_view TextCursor::next_word() {
  while (true) {
    while (at_ < end_ && is_blank(*at_)) {
      ++at_;
    }
    if (at_ == end_ || is_line_end(*at_)) {
      return {};
    }
    if (rules_.comment != '\0' && *at_ == rules_.comment) {
      skip_line();
      return {};
    }
    if (!rules_.has_continuations || *at_ != '\\' || !is_continuation(at_)) {
      break;
    }
    skip_line();
    take_line_end();
  }
  const char* const begin = at_;
  while (at_ < end_ && !is_blank(*at_) && !is_line_end(*at_) &&
         !(rules_.has_continuations && *at_ == '\\' && is_continuation(at_))) {
    ++at_;
  }
  return {begin, static_cast<std::size_t>(at_ - begin)};
}

std::string_view TextCursor::next_word_anywhere() {
  while (true) {
    const std::string_view word = next_word();
    if (!word.empty() || !next_line()) {
      return word;
    }
  }
}

std::string_view TextCursor::rest_of_line() {
  while (at_ < end_ && is_blank(*at_)) {
    ++at_;
  }
  const char* const begin = at_;
  skip_line();
  const char* last = at_;
  while (last > begin && is_blank(last[-1])) {
    --last;
  }
  return {begin, static_cast<std::size_t>(last - begin)};
}

}  // namespace limn::detail
