#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace limn::detail {

[[nodiscard]] constexpr bool is_blank(char c) noexcept {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}
[[nodiscard]] constexpr bool is_line_end(char c) noexcept {
  return c == '\n' || c == '\r';
}

/// What a text format knows besides words and lines.
struct TextRules {
  char comment = '\0';             ///< A word that begins with it ends the line's words.
  bool has_continuations = false;  ///< A backslash at the end of a line joins it with the next.
};

/// Walks a text word by word and line by line, once. Lines end with LF, CR or both, words with
/// blanks; both may be of any length.
class TextCursor {
 public:
  /// Stands at the beginning of the first line; a byte order mark is skipped. The text must outlive
  /// this.
  explicit TextCursor(std::string_view text, TextRules rules = {});

  /// The next word of the line; empty at its end.
  [[nodiscard]] std::string_view next_word();
  /// What is left of the line, without blanks at either end; the line is at its end then.
  [[nodiscard]] std::string_view rest_of_line();
  /// Goes to the beginning of the next line; false where there is none.
  [[nodiscard]] bool next_line();
  /// The next word of the text, on whatever line it stands; empty at the text's end.
  [[nodiscard]] std::string_view next_word_anywhere();

  /// 1-based line of the word that was read last.
  [[nodiscard]] std::uint32_t line() const noexcept { return line_; }
  /// Bytes that were not read yet.
  [[nodiscard]] std::size_t bytes_left() const noexcept {
    return static_cast<std::size_t>(end_ - at_);
  }

 private:
  [[nodiscard]] bool is_continuation(const char* backslash) const noexcept;
  void take_line_end() noexcept;
  void skip_line() noexcept;

  const char* at_;
  const char* end_;
  std::uint32_t line_ = 1;
  TextRules rules_;
};

/// The text without its byte order mark.
[[nodiscard]] std::string_view without_byte_order_mark(std::string_view text) noexcept;

}  // namespace limn::detail
