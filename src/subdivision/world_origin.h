#pragma once

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "limn/mesh/control_mesh.h"

// Internal to this folder.
namespace limn {

/// What RefinedMesh::positions are relative to: the world's origin, unless floats relative to it
/// would be too coarse. The points of a scheme lie within the bounds of its control mesh, or little
/// beyond, so it is enough to look at these.
[[nodiscard]] inline glm::dvec3 origin_of(const Bounds& bounds) {
  constexpr double kCoarsest = 3e-7;  // Of the diagonal; a third of what a vertex may be off.
  const glm::dvec3 farthest = glm::max(glm::abs(bounds.low), glm::abs(bounds.high));
  const double rounding = std::ldexp(glm::length(farthest), -24);
  return rounding > kCoarsest * bounds.diagonal() ? bounds.centre() : glm::dvec3(0.0);
}

}  // namespace limn
