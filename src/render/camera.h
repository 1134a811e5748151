#pragma once

#include <array>
#include <optional>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "limn/document/view_state.h"
#include "limn/mesh/control_mesh.h"
#include "limn/painting/auto_depth/screen_view.h"
#include "render/coordinates.h"

namespace limn::render {

/// Everything that drawing, picking and the CPU need to know of how the scene is projected.
///
/// World coordinates are mesh units. Eye space looks along -z with y up. "View depth" is the
/// distance in front of the eye along the viewing direction, in mesh units, positive in front.
///
/// Clip space has w at the near plane and 0 at the far one (0 <= z <= w, contexts are set so by
/// load_gl), and the greater depth is the nearer. In a buffer of floats that gives every depth the
/// same relative resolution, so what is far away does not flicker where the eye is close to
/// something small.
struct Camera {
  FramebufferSize size;
  bool orthographic = false;
  glm::dvec3 eye{0.0};
  glm::dvec3 right{1.0, 0.0, 0.0};  ///< Unit, world space, as are the next two.
  glm::dvec3 up{0.0, 1.0, 0.0};
  glm::dvec3 back{0.0, 0.0, 1.0};  ///< From the target towards the eye.
  double target_depth = 1.0;       ///< View depth of the orbit's target.
  double near_plane = 0.1;         ///< View depths; the near one may be negative in orthographic.
  double far_plane = 10.0;
  /// Half the visible height at view depth 1 (perspective) or at any depth (orthographic).
  double half_height = 1.0;

  glm::dmat4 view{1.0};             ///< World to eye space.
  glm::dmat4 projection{1.0};       ///< Eye to clip space.
  glm::dmat4 view_projection{1.0};  ///< World to clip space.
};

/// A half-line in world space; `direction` has length 1.
struct Ray {
  glm::dvec3 origin{0.0};
  glm::dvec3 direction{0.0, 0.0, -1.0};
};

/// Where a world point shows.
struct ProjectedPoint {
  FramebufferPoint point;
  double view_depth = 0.0;
};

/// The one place that turns a view into matrices.
///
/// Near and far planes follow `scene`: they enclose it with a little room, and in perspective the
/// near plane stays in front of the eye by at least a thousandth of the orbit's distance, so that a
/// mesh of millimetres and one of kilometres are both seen from close by. Out-of-range
/// values of a view are taken as the nearest usable ones: pitch -90..90, field of view 1..150
/// degrees, distance not below 1e-12. An empty size is treated as square.
/// Expects finite numbers.
[[nodiscard]] Camera make_camera(const ViewState& view, const Bounds& scene, FramebufferSize size);

/// World to clip space in single precision for positions that are stored relative to `origin`
/// (position in the buffer = world position - origin). The translation is folded in double
/// precision, so a mesh far from the world's origin does not shake.
[[nodiscard]] glm::mat4 clip_from_local(const Camera& camera, const glm::dvec3& origin);

/// World to eye space in single precision, likewise.
[[nodiscard]] glm::mat4 view_from_local(const Camera& camera, const glm::dvec3& origin);

/// The eye in homogeneous coordinates relative to `origin`: a point (w = 1) in perspective, the
/// direction towards it (w = 0) in orthographic. A plane n through p faces it where
/// dot(n, eye.xyz - eye.w * p) > 0.
[[nodiscard]] glm::vec4 eye_from_local(const Camera& camera, const glm::dvec3& origin);

/// Rotation alone: world directions (normals) to eye space.
[[nodiscard]] glm::mat3 view_rotation(const Camera& camera);

/// What shows at a place of the image: the ray starts on the near plane, so that t >= 0 is exactly
/// what the camera can see.
[[nodiscard]] Ray ray_through(const Camera& camera, FramebufferPoint point);

/// The world point that shows at a place of the image, at a view depth.
[[nodiscard]] glm::dvec3 world_at(const Camera& camera, FramebufferPoint point, double view_depth);

/// Where a world point shows; nothing where it lies before the near plane. The place may be outside
/// the image.
[[nodiscard]] std::optional<ProjectedPoint> project(const Camera& camera, const glm::dvec3& world);

/// View depth of a world point.
[[nodiscard]] double view_depth_of(const Camera& camera, const glm::dvec3& world);

/// View depth for a value read from the depth buffer (0..1, far to near).
[[nodiscard]] double view_depth_from_buffer(const Camera& camera, double buffer_depth);

/// The camera as far as sizes on the screen are concerned.
[[nodiscard]] ScreenView screen_view(const Camera& camera);

/// World length that one pixel spans at a view depth, parallel to the image.
[[nodiscard]] double pixel_size_at(const Camera& camera, double view_depth);

/// The eight corners of a box; bit 0, 1, 2 of the index tells low or high in x, y, z.
[[nodiscard]] std::array<glm::dvec3, 8> box_corners(const Bounds& box);

}  // namespace limn::render
