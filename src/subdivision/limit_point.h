#pragma once

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "subdivision/point.h"

// Internal to this folder.
namespace limn {

/// Where a vertex of the surface ends up, and the direction out of the surface there.
struct LimitPoint {
  glm::dvec3 position{0.0};
  glm::dvec3 normal{0.0};  ///< Of length 1; 0 where the surface has no tangent plane.
};

/// The direction at right angles to both, `other` being counter-clockwise of `tangent`; 0 where
/// they are parallel.
[[nodiscard]] inline glm::dvec3 unit_normal(const Point& tangent, const Point& other) noexcept {
  const glm::dvec3 a = to_vec3(tangent);
  const glm::dvec3 b = to_vec3(other);
  const glm::dvec3 normal = glm::cross(a, b);
  const double square = glm::dot(normal, normal);
  constexpr double kLeastSine = 1e-12;
  // Written so that a length that is no number fails too.
  return square > kLeastSine * kLeastSine * glm::dot(a, a) * glm::dot(b, b)
             ? normal * (1.0 / std::sqrt(square))
             : glm::dvec3(0.0);
}

}  // namespace limn
