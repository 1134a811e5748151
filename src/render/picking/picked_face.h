#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

namespace limn::render {

/// The face under a pixel.
struct PickedFace {
  std::uint32_t drawn_face = 0;    ///< In the order of the Surface that is drawn.
  std::uint32_t control_face = 0;  ///< The control face it lies in: what painting changes.
  double view_depth = 0.0;         ///< See Camera.
  glm::dvec3 position{0.0};        ///< World, at the place asked for, as deep as its pixel.
};

}  // namespace limn::render
