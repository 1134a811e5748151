#pragma once

#include <cstdint>

#include "limn/subdivision/fine_demands.h"

// Where faces of a level lie in each other. Children are numbered as everywhere in the engine:
// child i lies at corner i. Internal to the library.
namespace limn {

/// Bits of column and row, alternating: the place in a Z-shaped walk.
[[nodiscard]] constexpr std::uint32_t interleaved(std::uint16_t column,
                                                  std::uint16_t row) noexcept {
  const auto spread = [](std::uint32_t bits) {
    bits = (bits | bits << 8) & 0x00FF00FF;
    bits = (bits | bits << 4) & 0x0F0F0F0F;
    bits = (bits | bits << 2) & 0x33333333;
    return (bits | bits << 1) & 0x55555555;
  };
  return spread(column) | spread(row) << 1;
}

/// The first place of the deepest level that lies in a face.
[[nodiscard]] constexpr std::uint32_t first_place(const FineFace& face) noexcept {
  return interleaved(face.column, face.row) << 2 * (kMaxDepth - face.level);
}

/// The face of one level less that a face lies in; of a level-1 face a face of level 0, whose
/// column and row are 0.
[[nodiscard]] constexpr FineFace parent_of(const FineFace& face) noexcept {
  return {face.control_face, face.corner, static_cast<std::uint8_t>(face.level - 1),
          static_cast<std::uint16_t>(face.column / 2), static_cast<std::uint16_t>(face.row / 2)};
}

[[nodiscard]] constexpr FineFace child_of(const FineFace& face, std::uint32_t i) noexcept {
  return {face.control_face, face.corner, static_cast<std::uint8_t>(face.level + 1),
          static_cast<std::uint16_t>(2 * face.column + (i == 1 || i == 2 ? 1 : 0)),
          static_cast<std::uint16_t>(2 * face.row + (i >= 2 ? 1 : 0))};
}

/// At which corner of its parent a face lies.
[[nodiscard]] constexpr std::uint32_t corner_in_parent(const FineFace& face) noexcept {
  constexpr std::uint32_t kCorners[2][2] = {{0, 1}, {3, 2}};
  return kCorners[face.row % 2][face.column % 2];
}

/// Whether the first lies in the second or is it.
[[nodiscard]] constexpr bool lies_in(const FineFace& face, const FineFace& other) noexcept {
  if (face.control_face != other.control_face || face.corner != other.corner ||
      face.level < other.level) {
    return false;
  }
  const int levels = face.level - other.level;
  return face.column >> levels == other.column && face.row >> levels == other.row;
}

}  // namespace limn
