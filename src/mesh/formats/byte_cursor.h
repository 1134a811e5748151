#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace limn::detail {

/// Walks binary data number by number. Whoever reads has asked `bytes_left` first.
class ByteCursor {
 public:
  ByteCursor(std::string_view bytes, std::size_t at, std::endian order)
      : bytes_(bytes), at_(at), is_swapped_(order != std::endian::native) {}

  [[nodiscard]] std::size_t at() const noexcept { return at_; }
  [[nodiscard]] std::size_t bytes_left() const noexcept { return bytes_.size() - at_; }
  void skip(std::size_t bytes) noexcept { at_ += bytes; }

  template <class T>
  [[nodiscard]] T next() noexcept {
    char raw[sizeof(T)];
    std::memcpy(raw, bytes_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    if (is_swapped_) {
      for (std::size_t i = 0; i < sizeof(T) / 2; ++i) {
        const char c = raw[i];
        raw[i] = raw[sizeof(T) - 1 - i];
        raw[sizeof(T) - 1 - i] = c;
      }
    }
    T value;
    std::memcpy(&value, raw, sizeof(T));
    return value;
  }

 private:
  std::string_view bytes_;
  std::size_t at_;
  bool is_swapped_;
};

}  // namespace limn::detail
