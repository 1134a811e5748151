#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "limn/error.h"
#include "limn/mesh/import_report.h"
#include "mesh/formats/byte_cursor.h"
#include "mesh/formats/ply_header.h"
#include "mesh/formats/text_cursor.h"

namespace limn::detail {

/// The numbers after a PLY header, one by one, whatever the encoding.
class PlyValues {
 public:
  PlyValues(std::string_view bytes, const PlyHeader& header, const std::string& source);

  /// Begins the `number`th of an element's instances.
  void begin(const PlyElement& element, std::uint64_t number);
  /// The next number; false where there is none. One that a text has at the end of a line may stand
  /// on the next.
  [[nodiscard]] bool next(PlyType type, double& value);
  /// The next number as the length of a list of `type`; false also where so much cannot follow.
  [[nodiscard]] bool next_length(const PlyProperty& list, std::size_t& length);
  /// Ends an instance; false where more numbers stand on its line.
  [[nodiscard]] bool end();

  [[nodiscard]] bool refuse(std::string message);
  [[nodiscard]] const Error& error() const noexcept { return error_; }

  /// Where the instance stands.
  [[nodiscard]] std::uint32_t place() const noexcept { return place_; }
  [[nodiscard]] PlaceUnit place_unit() const noexcept {
    return is_text_ ? PlaceUnit::kLine : PlaceUnit::kByte;
  }
  /// Lines with something on them, or bytes, that were not read.
  [[nodiscard]] std::size_t count_rest();

 private:
  [[nodiscard]] bool next_in_text(double& value);
  [[nodiscard]] bool refuse_end();

  const std::string& source_;
  bool is_text_;
  std::uint32_t lines_before_;
  TextCursor text_;
  ByteCursor bytes_;
  const PlyElement* element_ = nullptr;
  std::uint64_t number_ = 0;
  bool has_place_ = false;
  std::uint32_t place_ = 0;
  Error error_;
};

}  // namespace limn::detail
