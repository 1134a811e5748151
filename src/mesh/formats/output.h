#pragma once

#include <bit>
#include <cstddef>
#include <cstring>
#include <iterator>
#include <ostream>
#include <string_view>

#include <fmt/compile.h>
#include <fmt/format.h>

namespace limn::detail {

/// Gathers output in a buffer that is handed to the stream a megabyte at a time: numbers are the
/// shortest that read back to the same bits, and iostreams never see one.
class Output {
 public:
  explicit Output(std::ostream& out) : out_(out) {}
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  ~Output() { flush(); }

  void text(std::string_view text) {
    buffer_.append(text.data(), text.data() + text.size());
    flush_if_full();
  }
  /// A number of any type in digits, after a blank.
  template <class T>
  void number(T value) {
    buffer_.push_back(' ');
    bare_number(value);
  }
  template <class T>
  void bare_number(T value) {
    fmt::format_to(std::back_inserter(buffer_), FMT_COMPILE("{}"), value);
  }
  void end_line() {
    buffer_.push_back('\n');
    flush_if_full();
  }
  /// A number of any type as little-endian binary data.
  template <class T>
  void binary(T value) {
    static_assert(std::endian::native == std::endian::little);
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    buffer_.append(bytes, bytes + sizeof value);
    flush_if_full();
  }

 private:
  static constexpr std::size_t FlushSize = std::size_t{1} << 20U;

  void flush_if_full() {
    if (buffer_.size() >= FlushSize) {
      flush();
    }
  }
  void flush() {
    out_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    buffer_.clear();
  }

  std::ostream& out_;
  fmt::memory_buffer buffer_;
};

}  // namespace limn::detail
