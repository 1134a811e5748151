// std::from_chars rounds correctly and knows no locale, but takes no plus sign and gives no value
// for numbers beyond the range.
#include "mesh/formats/parse_number.h"

#include <charconv>
#include <clocale>
#include <cstdlib>
#include <string>
#include <system_error>

#include <locale.h>

namespace limn::detail {
namespace {

std::string_view without_plus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+') {
    word.remove_prefix(1);
  }
  return word;
}

/// Infinite, denormal or 0, as C has it.
double parse_out_of_range(std::string_view word) {
  static const locale_t plain = ::newlocale(LC_ALL_MASK, "C", nullptr);
  return ::strtod_l(std::string(word).c_str(), nullptr, plain);
}

}  // namespace

bool parse_number(std::string_view word, double& value) {
  word = without_plus(word);
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error == std::errc::result_out_of_range && stop == end) {
    value = parse_out_of_range(word);
    return true;
  }
  return error == std::errc() && stop == end;
}

std::optional<std::int64_t> parse_index(std::string_view word) {
  word = without_plus(word);
  std::int64_t value = 0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || stop != end) {
    return std::nullopt;
  }
  return value;
}

}  // namespace limn::detail
