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

/// What of the sharpness around a vertex wears off to 0 in a step.
struct WornOff {
  float sum = 0.0f;
  int count = 0;

  constexpr void add(float sharpness, float child_sharpness) noexcept {
    if (is_sharp(sharpness) && !is_sharp(child_sharpness)) {
      sum += sharpness;
      ++count;
    }
  }
  /// At most 1: the weight of the old rule where the vertex changes rules.
  [[nodiscard]] constexpr float mean() const noexcept {
    return count == 0 ? 0.0f : std::min(sum / static_cast<float>(count), 1.0f);
  }
};

/// How much of the rule of a crease the point on an edge takes; the rest is smooth. The arguments
/// are the edge's sharpness and its halves'.
[[nodiscard]] constexpr float sharp_share_of_edge(float sharpness, float first_half,
                                                  float second_half) noexcept {
  // Both halves sharp: a crease goes on here. Under Chaikin's rule one may stay sharp alone.
  if (is_infinite(sharpness) || (is_sharp(first_half) && is_sharp(second_half))) {
    return 1.0f;
  }
  // Not held to 1, like OpenSubdiv's: Chaikin's rule can wear off more than 1 at a time.
  return std::max(sharpness, 0.0f);
}

/// The same for a vertex on a crease, smooth by itself, between two edges whose halves at it have
/// the sharpness `child_before` and `child_after` in the next level.
[[nodiscard]] constexpr float sharp_share_of_vertex(float before, float after, float child_before,
                                                    float child_after) noexcept {
  if (!is_sharp(before) || !is_sharp(after)) {
    return 0.0f;  // The end of a crease is smooth.
  }
  if (is_sharp(child_before) && is_sharp(child_after)) {
    return 1.0f;
  }
  WornOff worn;
  worn.add(before, child_before);
  worn.add(after, child_after);
  return worn.mean();
}

}  // namespace limn
