#pragma once

#include <algorithm>
#include <cstdint>

// Labels one level down, by the rules of the paper. Internal to this folder.
namespace limn {

/// The new label of an old vertex.
[[nodiscard]] constexpr std::uint8_t lowered(std::uint8_t label) noexcept {
  return static_cast<std::uint8_t>(label > 0 ? label - 1 : 0);
}

/// The label of the point on the edge between vertices of these (old) labels.
[[nodiscard]] constexpr std::uint8_t edge_point_label(std::uint8_t a, std::uint8_t b) noexcept {
  return std::min(lowered(a), lowered(b));
}

/// Folded over the edge labels of a split face from 0 on, this gives its face point's label.
[[nodiscard]] constexpr std::uint8_t least_positive(std::uint8_t a, std::uint8_t b) noexcept {
  if (a == 0 || b == 0) {
    return std::max(a, b);
  }
  return std::min(a, b);
}

}  // namespace limn
