#pragma once

#include <array>
#include <vector>

#include <glm/vec3.hpp>

#include "limn/mesh/control_mesh.h"

// Internal to this folder.
namespace limn {

/// What one step of Loop's scheme with his own weights makes of a triangle mesh, without its faces.
struct LoopStep {
  std::vector<glm::dvec3> positions;  ///< V + E: the old vertices, then one for each edge.
  /// E, of the halves of each edge, the one at its first vertex first.
  std::vector<std::array<float, 2>> half_sharpness;
  std::vector<float> vertex_sharpness;  ///< V + E, or empty: none is sharp.
};

[[nodiscard]] LoopStep loop_step(const ControlMesh& mesh, CornerRule corners);

}  // namespace limn
