#pragma once

#include <span>

#include <glm/vec3.hpp>

namespace limn::bench {

/// How far two programs' vertices may lie apart, in diagonals of the control mesh: what single
/// precision allows.
inline constexpr double kAgreement = 1e-5;

/// The largest distance from a point of either set to the nearest of the other, whatever their
/// orders. Infinite where it is more than a thousandth of the sets' extent.
[[nodiscard]] double largest_distance(std::span<const glm::vec3> a, std::span<const glm::vec3> b);

}  // namespace limn::bench
