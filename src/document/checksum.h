#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace limn {

/// The checksum of JSON text as it comes along: CRC-64/XZ of its bytes, white space between them
/// left out, so that a change of indentation or line ends is none. It tells every change of up to
/// 64 bits in a row, and of any others all but one in 2^64.
class JsonChecksum {
 public:
  void add(std::string_view text) noexcept;
  [[nodiscard]] std::uint64_t value() const noexcept { return ~remainder_; }

 private:
  std::uint64_t remainder_ = ~std::uint64_t{0};
  bool is_in_string_ = false;
  bool is_escaped_ = false;
};

/// The last member of an object, with the end of it, for text whose checksum is `value`.
[[nodiscard]] std::string checksum_member(std::uint64_t value);

/// Whether JSON text whose last member is the checksum `written` is as it was when that was added.
[[nodiscard]] bool fits_checksum(std::string_view text, std::string_view written);

}  // namespace limn
