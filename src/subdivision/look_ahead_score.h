#pragma once

#include <cstddef>
#include <cstdint>

#include "subdivision/legality_problem.h"

// What look-ahead weighs a relabel by. Internal to this folder.
namespace limn {

/// Scores are counted in fifths.
inline constexpr std::int32_t kOneMended = 5;
inline constexpr std::int32_t kOneMendedNext = 3;
inline constexpr std::int32_t kOneFaceAdded = -5;
inline constexpr float kScoreUnit = 5.0F;

/// Variables of more quads are not looked ahead to.
inline constexpr std::size_t kMostQuadsLookedAhead = 32;

/// Illegal quads fewer when the corners in `bits` rise.
[[nodiscard]] constexpr std::int32_t mended(unsigned mask, unsigned bits) noexcept {
  return static_cast<std::int32_t>(is_illegal_mask(mask)) -
         static_cast<std::int32_t>(is_illegal_mask(mask | bits));
}

[[nodiscard]] constexpr std::int32_t faces_of(unsigned mask) noexcept {
  return static_cast<std::int32_t>(added_faces_of(mask));
}

}  // namespace limn
