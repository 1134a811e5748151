#pragma once

#include <glm/vec3.hpp>

namespace limn {

/// Where the viewer stands: an orbit around a target. Plain data, saved with a project.
///
/// Yaw turns around +Y, pitch lifts towards it, both in degrees; yaw = pitch = 0 looks along -Z
/// ("front"). Distances are in mesh units.
struct ViewState {
  glm::dvec3 target{0.0};
  double distance = 3.0;
  double yaw = 0.0;
  double pitch = 0.0;         ///< -90..90.
  double fov_degrees = 35.0;  ///< Vertical field of view; also sets the orthographic height.
  bool orthographic = false;

  [[nodiscard]] bool operator==(const ViewState&) const = default;
};

}  // namespace limn
