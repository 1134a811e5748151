#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/vec3.hpp>

namespace limn {

/// How far the points of one surface are from another surface, in the units of the meshes.
struct DirectedDistance {
  double greatest = 0.0;          ///< The one-sided Hausdorff distance.
  double root_mean_square = 0.0;  ///< Over the area of the surface that is left.
  double area = 0.0;              ///< Of the surface that is left.
  glm::dvec3 from{0.0};           ///< The point that is farthest,
  glm::dvec3 to{0.0};             ///< and what is nearest to it on the other surface.
  std::size_t samples = 0;        ///< Points that were looked at.
};

/// The Hausdorff distance: the greater of both directions.
[[nodiscard]] inline double greatest_of(const DirectedDistance& one,
                                        const DirectedDistance& other) noexcept {
  return std::max(one.greatest, other.greatest);
}

/// The root mean square over the areas of both surfaces.
[[nodiscard]] inline double root_mean_square_of(const DirectedDistance& one,
                                                const DirectedDistance& other) noexcept {
  const double squares = one.root_mean_square * one.root_mean_square * one.area +
                         other.root_mean_square * other.root_mean_square * other.area;
  const double area = one.area + other.area;
  return area > 0.0 ? std::sqrt(squares / area) : 0.0;
}

}  // namespace limn
