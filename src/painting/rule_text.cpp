#include "painting/rule_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace limn::rule_text {

static constexpr std::string_view kBlanks = " \t\r\n\v\f";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// The text in quotes, fit for a message: short, and without control characters.
std::string quoted(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::size_t length = std::min(text.size(), kLongest);
  while (length < text.size() && length > 0 &&
         (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) {
    --length;  // Never cut a UTF-8 character in two.
  }
  std::string shown = "\"";
  for (const char c : text.substr(0, length)) {
    const auto byte = static_cast<unsigned char>(c);
    shown += byte < 0x20 || byte == 0x7F ? '?' : c;
  }
  return shown + (length < text.size() ? "...\"" : "\"");
}

tl::unexpected<Error> misread(std::string message) {
  return fail(ErrorKind::kUsage, std::move(message));
}

std::optional<double> read_degrees(std::string_view text, double most) {
  double degrees = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), degrees);
  const bool is_number = error == std::errc{} && end == text.data() + text.size();
  // from_chars also reads "nan" and "inf"; the comparison turns both away.
  if (!is_number || !(degrees >= 0.0 && degrees <= most)) {
    return std::nullopt;
  }
  return std::abs(degrees);  // "-0" is 0.
}

std::optional<std::uint32_t> read_whole_number(std::string_view text) {
  std::uint32_t value = 0;
  if (text.empty() || text.front() < '0' || text.front() > '9') {
    return std::nullopt;
  }
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) {
    return std::nullopt;
  }
  return value;
}

}  // namespace limn::rule_text
