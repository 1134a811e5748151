#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace limn::detail {

/// What the letters before OFF say of each vertex.
struct OffVertex {
  bool has_uv = false;         ///< ST
  bool has_colour = false;     ///< C
  bool has_normal = false;     ///< N
  bool has_weight = false;     ///< 4: the coordinates are to be divided by a fourth.
  bool has_dimension = false;  ///< n: the number of coordinates follows.

  /// Coordinates, with the weight.
  [[nodiscard]] std::size_t coordinates() const noexcept { return has_weight ? 4 : 3; }
};

/// Reads a word like `OFF` or `STCN4nOFF`; nothing where it is none.
[[nodiscard]] std::optional<OffVertex> read_off_keyword(std::string_view word) noexcept;

}  // namespace limn::detail
