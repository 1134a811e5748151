#pragma once

#include <algorithm>

#include "limn/mesh/creases.h"

// Internal to this folder: how sharpness wears off, in single precision like OpenSubdiv's
// Sdc::Crease, so that what falls to just 0 does so in both.
namespace limn {

[[nodiscard]] constexpr bool is_sharp(float sharpness) noexcept {
  return sharpness > 0.0f;
}

[[nodiscard]] constexpr bool is_infinite(float sharpness) noexcept {
  return sharpness >= kInfiniteSharpness;
}

[[nodiscard]] constexpr bool is_semi_sharp(float sharpness) noexcept {
  return is_sharp(sharpness) && !is_infinite(sharpness);
}

[[nodiscard]] constexpr float one_level_less(float sharpness) noexcept {
  return is_infinite(sharpness) ? kInfiniteSharpness : std::max(sharpness - 1.0f, 0.0f);
}

/// Chaikin's rule for the half of an edge at a vertex, from the mean sharpness of the other
/// semi-sharp edges there; 0 where there is none.
[[nodiscard]] constexpr float chaikin_child(float sharpness, float mean_of_others) noexcept {
  return one_level_less(is_semi_sharp(sharpness) && mean_of_others > 0.0f
                            ? 0.75f * sharpness + 0.25f * mean_of_others
                            : sharpness);
}

/// Of the semi-sharp edges that meet at a vertex.
struct SharpnessSum {
  float sum = 0.0f;
  int count = 0;

  constexpr void add(float sharpness) noexcept {
    if (is_semi_sharp(sharpness)) {
      sum += sharpness;
      ++count;
    }
  }
  /// Mean of the others' besides one semi-sharp edge that is among them; 0 where there is none.
  [[nodiscard]] constexpr float mean_besides(float sharpness) const noexcept {
    return count < 2 ? 0.0f : (sum - sharpness) / static_cast<float>(count - 1);
  }
};

}  // namespace limn
