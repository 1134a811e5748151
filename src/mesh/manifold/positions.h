#pragma once

#include <algorithm>
#include <cmath>

#include <glm/vec3.hpp>

namespace limn::detail {

/// Refined positions are single precision and get squared on the graphics card, so a coordinate has
/// to stay well below the square root of what a float can hold.
inline constexpr double kLargestCoordinate = 1e18;

/// Whether a vertex of the surface may lie there.
[[nodiscard]] inline bool is_usable(const glm::dvec3& p) noexcept {
  // Written so that what is not a number fails it too.
  return std::abs(p.x) <= kLargestCoordinate && std::abs(p.y) <= kLargestCoordinate &&
         std::abs(p.z) <= kLargestCoordinate;
}

}  // namespace limn::detail
