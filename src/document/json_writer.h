#pragma once

#include <cstdint>
#include <ostream>
#include <string_view>

#include <fmt/format.h>

#include "checksum.h"

namespace limn {

/// Text on its way to a stream, handed over in large pieces.
class JsonWriter {
 public:
  explicit JsonWriter(std::ostream& out) : out_(out) {}
  ~JsonWriter() { flush(); }
  JsonWriter(const JsonWriter&) = delete;
  JsonWriter& operator=(const JsonWriter&) = delete;

  void add(std::string_view text) {
    buffer_.append(text);
    if (buffer_.size() > kPiece) {
      flush();
    }
  }
  /// Of all that was added.
  [[nodiscard]] std::uint64_t checksum() {
    flush();
    return checksum_.value();
  }
  /// A list of what `text_of` makes of every item.
  template <class Range>
  void add_list(const Range& items, std::string_view separator, auto&& text_of) {
    add("[");
    std::string_view before;
    for (const auto& item : items) {
      add(before);
      add(text_of(item));
      before = separator;
    }
    add("]");
  }

 private:
  static constexpr std::size_t kPiece = std::size_t{1} << 16U;

  void flush() {
    checksum_.add({buffer_.data(), buffer_.size()});
    out_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    buffer_.clear();
  }

  std::ostream& out_;
  JsonChecksum checksum_;
  fmt::basic_memory_buffer<char, 2 * kPiece> buffer_;
};

}  // namespace limn
