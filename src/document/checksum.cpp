#include "checksum.h"

#include <array>

#include <fmt/format.h>

namespace limn {
namespace {

constexpr std::string_view kKey = "\"checksum\"";

consteval std::array<std::uint64_t, 256> remainders() {
  constexpr std::uint64_t polynomial = 0xC96C5795D7870F42U;  // ECMA-182, lowest bit first.
  std::array<std::uint64_t, 256> table{};
  for (std::uint64_t byte = 0; byte < table.size(); ++byte) {
    std::uint64_t remainder = byte;
    for (int bit = 0; bit < 8; ++bit) {
      remainder = (remainder >> 1U) ^ ((remainder & 1U) != 0 ? polynomial : 0);
    }
    table[byte] = remainder;
  }
  return table;
}
constexpr std::array<std::uint64_t, 256> kRemainders = remainders();

bool is_white_space(char c) noexcept {
  return c == ' ' || c == '\n' || c == '\r' || c == '\t';
}

std::string without_white_space(std::string_view text) {
  std::string rest;
  for (const char c : text) {
    if (!is_white_space(c)) {
      rest += c;
    }
  }
  return rest;
}

std::string member(std::string_view value) {
  return fmt::format("{}: \"{}\"\n}}\n", kKey, value);
}

}  // namespace

void JsonChecksum::add(std::string_view text) noexcept {
  for (const char c : text) {
    if (is_in_string_) {
      is_in_string_ = is_escaped_ || c != '"';
      is_escaped_ = !is_escaped_ && c == '\\';
    } else if (c == '"') {
      is_in_string_ = true;
    } else if (is_white_space(c)) {
      continue;
    }
    const auto byte = static_cast<unsigned char>(c);
    remainder_ = (remainder_ >> 8U) ^ kRemainders[(remainder_ ^ byte) & 0xFFU];
  }
}

std::string checksum_member(std::uint64_t value) {
  return member(fmt::format("{:016x}", value));
}

bool fits_checksum(std::string_view text, std::string_view written) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) {
    text.remove_prefix(byte_order_mark.size());
  }
  const std::size_t at = text.rfind(kKey);
  if (at == std::string_view::npos) {
    return false;
  }
  JsonChecksum checksum;
  checksum.add(text.substr(0, at));
  return written == fmt::format("{:016x}", checksum.value()) &&
         without_white_space(text.substr(at)) == without_white_space(member(written));
}

}  // namespace limn
