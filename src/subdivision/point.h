#pragma once

#include <glm/vec3.hpp>

// Internal to this folder.
namespace limn {

/// A position (or a pair of texture coordinates) in double precision with a fourth, unused lane, so
/// that a compiler turns every operation on it into a few vector instructions. It has + - * and /
/// by a double, element by element (GCC's and Clang's vector extension).
using Point [[gnu::vector_size(32)]] = double;

/// A Point in memory. What alignment that of a Point itself is depends on the processor a file is
/// compiled for; where files for several meet (tensor_kernels.h) they agree on this.
using StoredPoint [[gnu::aligned(16)]] = Point;

[[nodiscard]] inline Point to_point(const glm::dvec3& p) noexcept {
  return Point{p.x, p.y, p.z, 0.0};
}

[[nodiscard]] inline glm::dvec3 to_vec3(const Point& p) noexcept {
  return {p[0], p[1], p[2]};
}

}  // namespace limn
