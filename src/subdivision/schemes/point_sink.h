#pragma once

#include <cstddef>

#include <glm/vec3.hpp>

#include "subdivision/point.h"

// Internal to this folder.
namespace limn {

/// Where a step puts its points: in double precision for the next one, or rounded in the result.
struct PointSink {
  Point* points = nullptr;
  glm::vec3* rounded = nullptr;

  void put(std::size_t v, const Point& point) const noexcept {
    if (points != nullptr) {
      points[v] = point;
    } else {
      rounded[v] = glm::vec3(to_vec3(point));
    }
  }
};

}  // namespace limn
