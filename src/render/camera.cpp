// The orbit's angles give the eye's axes directly; nothing is made with a look-at and an up vector,
// so straight up and straight down need no special case.

#include "render/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "limn/contract.h"

namespace limn::render {
namespace {

constexpr double kSmallestDistance = 1e-12;
constexpr double kSmallestFov = 1.0;
constexpr double kLargestFov = 150.0;
/// Nearest near plane, as a part of the orbit's distance.
constexpr double kNearFraction = 1e-3;
/// Room around the scene, as a part of its diagonal.
constexpr double kSceneRoom = 0.01;

double radians(double degrees) {
  return degrees * (std::numbers::pi / 180.0);
}

double diagonal_of(const Bounds& scene) {
  return glm::length(scene.high - scene.low);
}

void set_axes(Camera& camera, const ViewState& view) {
  const double yaw = radians(view.yaw);
  const double pitch = radians(std::clamp(view.pitch, -90.0, 90.0));
  const double sy = std::sin(yaw);
  const double cy = std::cos(yaw);
  const double sp = std::sin(pitch);
  const double cp = std::cos(pitch);
  camera.right = {cy, 0.0, -sy};
  camera.up = {-sp * sy, cp, -sp * cy};
  camera.back = {sy * cp, sp, cy * cp};
}

void set_clip_planes(Camera& camera, const Bounds& scene, double distance) {
  double nearest = INFINITY;
  double farthest = -INFINITY;
  for (const glm::dvec3& corner : box_corners(scene)) {
    const double depth = view_depth_of(camera, corner);
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  const double room = std::max(kSceneRoom * diagonal_of(scene), kNearFraction * distance);
  camera.near_plane = nearest - room;
  camera.far_plane = farthest + room;
  if (!camera.orthographic) {
    camera.near_plane = std::max(camera.near_plane, kNearFraction * distance);
    camera.far_plane = std::max(camera.far_plane, 2.0 * camera.near_plane);
  }
}

/// Columns first, as GLM stores them.
glm::dmat4 projection_of(const Camera& camera) {
  const double aspect = camera.size.aspect();
  const double h = camera.half_height;
  const double n = camera.near_plane;
  const double f = camera.far_plane;
  glm::dmat4 m(0.0);
  m[0][0] = 1.0 / (h * aspect);
  m[1][1] = 1.0 / h;
  if (camera.orthographic) {
    m[2][2] = 1.0 / (f - n);
    m[3][2] = f / (f - n);
    m[3][3] = 1.0;
  } else {
    m[2][2] = n / (f - n);
    m[2][3] = -1.0;
    m[3][2] = f * n / (f - n);
  }
  return m;
}

/// World to eye space for positions relative to `origin`.
glm::dmat4 view_from(const Camera& camera, const glm::dvec3& origin) {
  const glm::dvec3 offset = origin - camera.eye;
  glm::dmat4 m(1.0);
  for (int axis = 0; axis < 3; ++axis) {
    m[axis][0] = camera.right[axis];
    m[axis][1] = camera.up[axis];
    m[axis][2] = camera.back[axis];
  }
  m[3] = glm::dvec4(glm::dot(camera.right, offset), glm::dot(camera.up, offset),
                    glm::dot(camera.back, offset), 1.0);
  return m;
}

/// The point at view depth 0 (orthographic) or the direction per unit of view depth (perspective)
/// is what varies over the image: its sideways part, in world space.
glm::dvec3 sideways(const Camera& camera, FramebufferPoint point) {
  const double u = 2.0 * point.x / std::max(camera.size.width, 1) - 1.0;
  const double v = 1.0 - 2.0 * point.y / std::max(camera.size.height, 1);
  return camera.half_height * (u * camera.size.aspect() * camera.right + v * camera.up);
}

}  // namespace

std::array<glm::dvec3, 8> box_corners(const Bounds& scene) {
  std::array<glm::dvec3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i] = {(i & 1U) != 0 ? scene.high.x : scene.low.x,
                  (i & 2U) != 0 ? scene.high.y : scene.low.y,
                  (i & 4U) != 0 ? scene.high.z : scene.low.z};
  }
  return corners;
}

Camera make_camera(const ViewState& view, const Bounds& scene, FramebufferSize size) {
  LIMN_EXPECTS(std::isfinite(view.distance + view.yaw + view.pitch + view.fov_degrees));
  LIMN_EXPECTS(std::isfinite(glm::dot(view.target, glm::dvec3(1.0))));
  Camera camera;
  camera.size = size;
  camera.orthographic = view.orthographic;
  set_axes(camera, view);

  const double distance = std::max(view.distance, kSmallestDistance);
  camera.target_depth = distance;
  camera.eye = view.target + distance * camera.back;
  const double fov = std::clamp(view.fov_degrees, kSmallestFov, kLargestFov);
  const double tangent = std::tan(0.5 * radians(fov));
  camera.half_height = camera.orthographic ? distance * tangent : tangent;

  set_clip_planes(camera, scene, distance);
  camera.view = view_from(camera, glm::dvec3(0.0));
  camera.projection = projection_of(camera);
  camera.view_projection = camera.projection * camera.view;
  return camera;
}

glm::mat4 clip_from_local(const Camera& camera, const glm::dvec3& origin) {
  return {camera.projection * view_from(camera, origin)};
}

glm::mat4 view_from_local(const Camera& camera, const glm::dvec3& origin) {
  return {view_from(camera, origin)};
}

glm::vec4 eye_from_local(const Camera& camera, const glm::dvec3& origin) {
  return camera.orthographic ? glm::vec4(glm::vec3(camera.back), 0.0F)
                             : glm::vec4(glm::vec3(camera.eye - origin), 1.0F);
}

glm::mat3 view_rotation(const Camera& camera) {
  return glm::mat3(glm::dmat3(camera.view));
}

Ray ray_through(const Camera& camera, FramebufferPoint point) {
  if (camera.orthographic) {
    return {world_at(camera, point, camera.near_plane), -camera.back};
  }
  const glm::dvec3 direction = sideways(camera, point) - camera.back;
  return {camera.eye + camera.near_plane * direction, glm::normalize(direction)};
}

glm::dvec3 world_at(const Camera& camera, FramebufferPoint point, double view_depth) {
  const glm::dvec3 side = sideways(camera, point);
  return camera.eye + (camera.orthographic ? side : view_depth * side) - view_depth * camera.back;
}

std::optional<ProjectedPoint> project(const Camera& camera, const glm::dvec3& world) {
  const double depth = view_depth_of(camera, world);
  if (depth < camera.near_plane) {
    return std::nullopt;
  }
  const glm::dvec3 offset = world - camera.eye;
  const double scale = camera.half_height * (camera.orthographic ? 1.0 : depth);
  const double u = glm::dot(camera.right, offset) / (scale * camera.size.aspect());
  const double v = glm::dot(camera.up, offset) / scale;
  return ProjectedPoint{{0.5 * (u + 1.0) * camera.size.width, 0.5 * (1.0 - v) * camera.size.height},
                        depth};
}

double view_depth_of(const Camera& camera, const glm::dvec3& world) {
  return glm::dot(camera.back, camera.eye - world);
}

double view_depth_from_buffer(const Camera& camera, double buffer_depth) {
  const double n = camera.near_plane;
  const double f = camera.far_plane;
  return camera.orthographic ? f - buffer_depth * (f - n) : f * n / (n + buffer_depth * (f - n));
}

ScreenView screen_view(const Camera& camera) {
  ScreenView view;
  view.eye = camera.eye;
  view.right = camera.right;
  view.up = camera.up;
  view.back = camera.back;
  view.is_orthographic = camera.orthographic;
  view.near_plane = camera.near_plane;
  view.half_height = camera.half_height;
  view.width = camera.size.width;
  view.height = camera.size.height;
  return view;
}

double pixel_size_at(const Camera& camera, double view_depth) {
  const double height = 2.0 * camera.half_height * (camera.orthographic ? 1.0 : view_depth);
  return height / std::max(camera.size.height, 1);
}

}  // namespace limn::render
