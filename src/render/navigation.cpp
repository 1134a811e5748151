// Works in the eye's axes, which come from the camera itself: there is no second place that knows
// what yaw and pitch mean.

#include "render/navigation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "limn/contract.h"
#include "render/camera.h"

namespace limn::render {
namespace {

constexpr double kDegreesPerHeight = 180.0;
constexpr double kClosest = 1e-4;  ///< Of the scene's diagonal.
constexpr double kFarthest = 100.0;
constexpr double kFrameMargin = 1.08;
constexpr double kOutsideSphere = 0.51;  ///< Of a diagonal: just outside the sphere around a box.
constexpr double kClosestDistance = 1e-12;

/// The angle as one in -180..180.
double wrapped(double degrees) {
  return std::remainder(degrees, 360.0);
}

double smooth_step(double t) {
  return t * t * (3.0 - 2.0 * t);
}

Bounds bounds_around(std::span<const glm::dvec3> points) {
  Bounds bounds{points.front(), points.front()};
  for (const glm::dvec3& point : points) {
    bounds.low = glm::min(bounds.low, point);
    bounds.high = glm::max(bounds.high, point);
  }
  return bounds;
}

/// Smallest distance at which a point at `offset` from the target is inside the image.
double distance_to_show(const Camera& camera, const glm::dvec3& offset, double tangent,
                        double aspect) {
  const double x = std::abs(glm::dot(camera.right, offset)) / (tangent * aspect);
  const double y = std::abs(glm::dot(camera.up, offset)) / tangent;
  const double sideways = std::max(x, y) * kFrameMargin;
  return camera.orthographic ? sideways : sideways + glm::dot(camera.back, offset);
}

}  // namespace

ViewState orbit(const ViewState& view, double dx, double dy) {
  ViewState turned = view;
  turned.yaw = wrapped(view.yaw - kDegreesPerHeight * dx);
  turned.pitch = std::clamp(view.pitch + kDegreesPerHeight * dy, -90.0, 90.0);
  return turned;
}

ViewState orbit_about(const ViewState& view, double dx, double dy, const glm::dvec3& pivot) {
  // As seen along the eye's own axes, the way from the pivot to the target stays the same.
  const auto camera_of = [](const ViewState& state) {
    return make_camera(state, Bounds{state.target, state.target}, {});
  };
  const Camera before = camera_of(view);
  ViewState turned = orbit(view, dx, dy);
  const Camera after = camera_of(turned);
  const glm::dvec3 way = view.target - pivot;
  turned.target = pivot + glm::dot(before.right, way) * after.right +
                  glm::dot(before.up, way) * after.up + glm::dot(before.back, way) * after.back;
  return turned;
}

ViewState turn_towards(const ViewState& view, const glm::dvec3& direction) {
  const double length = glm::length(direction);
  if (!(length > 0.0)) {
    return view;
  }
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  ViewState turned = view;
  turned.pitch = kDegrees * std::asin(std::clamp(direction.y / length, -1.0, 1.0));
  if (std::hypot(direction.x, direction.z) > 1e-9 * length) {
    turned.yaw = kDegrees * std::atan2(direction.x, direction.z);
  }
  return turned;
}

ViewState pan(const ViewState& view, FramebufferSize size, const PanDrag& drag) {
  const Camera camera = make_camera(view, Bounds{view.target, view.target}, size);
  const glm::dvec3 grabbed = world_at(camera, drag.from, drag.view_depth);
  const glm::dvec3 wanted = world_at(camera, drag.to, drag.view_depth);
  ViewState moved = view;
  moved.target += grabbed - wanted;
  return moved;
}

ViewState dolly(const ViewState& view, double factor, const glm::dvec3& anchor,
                const Bounds& scene) {
  LIMN_EXPECTS(factor > 0.0);
  const double size = glm::length(scene.high - scene.low);
  const double before = std::max(view.distance, kClosestDistance);
  double distance = before * factor;
  if (size > 0.0) {
    // A view that is already beyond the limits may come back but not go farther.
    const double low = std::min(kClosest * size, before);
    const double high = std::max(kFarthest * size, before);
    distance = std::clamp(distance, low, high);
  }
  ViewState moved = view;
  moved.target = anchor + (view.target - anchor) * (distance / before);
  moved.distance = distance;
  return moved;
}

ViewState dolly(const ViewState& view, double factor, const Bounds& scene) {
  return dolly(view, factor, view.target, scene);
}

ViewState frame_points(const ViewState& view, std::span<const glm::dvec3> points, double aspect) {
  LIMN_EXPECTS(aspect > 0.0);
  if (points.empty()) {
    return view;
  }
  const Bounds bounds = bounds_around(points);
  ViewState framed = view;
  framed.target = 0.5 * (bounds.low + bounds.high);

  ViewState unit = framed;
  unit.distance = 1.0;
  const Camera camera = make_camera(unit, bounds, {});
  double distance = 0.0;
  for (const glm::dvec3& point : points) {
    distance = std::max(
        distance, distance_to_show(camera, point - framed.target, camera.half_height, aspect));
  }
  // Points in one line of sight would let the eye come up to the first of them.
  distance = std::max(distance, kOutsideSphere * glm::length(bounds.high - bounds.low));
  if (distance > 0.0) {
    framed.distance = distance;
  }
  return framed;
}

ViewState frame_bounds(const ViewState& view, const Bounds& bounds, double aspect) {
  return frame_points(view, box_corners(bounds), aspect);
}

ViewState ease_view(const ViewState& from, const ViewState& to, double t) {
  if (t <= 0.0) {
    return from;
  }
  if (t >= 1.0) {
    return to;
  }
  const double s = smooth_step(t);
  ViewState view = to;
  view.target = glm::mix(from.target, to.target, s);
  view.distance = from.distance * std::pow(to.distance / from.distance, s);
  view.yaw = wrapped(from.yaw + s * wrapped(to.yaw - from.yaw));
  view.pitch = from.pitch + s * (to.pitch - from.pitch);
  view.fov_degrees = from.fov_degrees + s * (to.fov_degrees - from.fov_degrees);
  return view;
}

}  // namespace limn::render
