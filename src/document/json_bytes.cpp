// The private characters U+F780..U+F7FF stand for the bytes 0x80..0xFF. In UTF-8 they are
// 0xEF 0x9E 0x80..0xBF and 0xEF 0x9F 0x80..0xBF.
#include <optional>

#include <fmt/format.h>

#include "json_lists.h"

namespace limn {
namespace {

unsigned char byte_at(std::string_view text, std::size_t at) {
  return static_cast<unsigned char>(text[at]);
}

/// The byte that a private character stands for.
std::optional<char> meant_byte(std::string_view character) {
  if (character.size() < 3 || byte_at(character, 0) != 0xEFU ||
      (byte_at(character, 1) & 0xFEU) != 0x9EU || (byte_at(character, 2) & 0xC0U) != 0x80U) {
    return std::nullopt;
  }
  const unsigned low = byte_at(character, 2) & 0x3FU;
  return static_cast<char>(0x80U + ((byte_at(character, 1) & 1U) << 6U) + low);
}

std::string private_character(char byte) {
  const unsigned offset = static_cast<unsigned char>(byte) - 0x80U;
  return {'\xEF', static_cast<char>(0x9EU + (offset >> 6U)),
          static_cast<char>(0x80U + (offset & 0x3FU))};
}

/// Bytes of the UTF-8 character that the text begins with; 0 where it begins with none.
std::size_t character_length(std::string_view text) {
  const unsigned char first = byte_at(text, 0);
  const std::size_t length = first < 0x80U ? 1 : first < 0xE0U ? 2 : first < 0xF0U ? 3 : 4;
  return text.size() >= length && is_utf8(text.substr(0, length)) ? length : 0;
}

}  // namespace

std::string json_bytes(std::string_view bytes) {
  std::string text;
  while (!bytes.empty()) {
    const std::size_t length = character_length(bytes);
    if (length == 0 || meant_byte(bytes.substr(0, length))) {
      text += private_character(bytes.front());
      bytes.remove_prefix(1);
    } else {
      text += bytes.substr(0, length);
      bytes.remove_prefix(length);
    }
  }
  return json_quoted(text);
}

std::string bytes_of_json(std::string_view text) {
  std::string bytes;
  while (!text.empty()) {
    const std::optional<char> byte = meant_byte(text);
    bytes += byte.value_or(text.front());
    text.remove_prefix(byte ? 3 : 1);
  }
  return bytes;
}

}  // namespace limn
