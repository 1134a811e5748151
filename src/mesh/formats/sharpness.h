#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "limn/mesh/creases.h"

namespace limn::detail {

/// A number of a file as a finite sharpness: what a float cannot hold never wears off anyway.
/// Nothing where it is not a number.
[[nodiscard]] inline std::optional<float> to_sharpness(double value) noexcept {
  if (std::isnan(value)) {
    return std::nullopt;
  }
  const double largest = std::numeric_limits<float>::max();
  if (std::abs(value) > largest) {
    return value > 0.0 ? kInfiniteSharpness : -1.0f;
  }
  return static_cast<float>(value);
}

}  // namespace limn::detail
