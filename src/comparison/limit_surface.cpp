#include "comparison/limit_surface.h"

#include <glm/geometric.hpp>

namespace limn {

LimitSurface::LimitSurface(RefinedMesh points, std::vector<bool> is_looked_at, Sweep& sweep)
    : TreeSurface(cut_surface(points, sweep), sweep),
      normals_(std::move(points.normals)),
      control_faces_(std::move(points.face_control_faces)),
      is_looked_at_(std::move(is_looked_at)) {
  if (point_count() == 0) {
    return;  // Cancelled.
  }
  // A crease has two normals, a corner many, the centre of a polygon an unknown one.
  normals_.resize(point_count(), glm::vec3(0.0f));
  for (const RefinedCrease& crease : points.creases) {
    normals_[crease.vertices[0]] = glm::vec3(0.0f);
    normals_[crease.vertices[1]] = glm::vec3(0.0f);
  }
  for (const RefinedCorner& corner : points.corners) {
    normals_[corner.vertex] = glm::vec3(0.0f);
  }
}

glm::dvec3 LimitSurface::point(std::uint32_t t, const glm::dvec3& weights) const noexcept {
  const Corners& at = corners(t);
  const glm::dvec3 linear = linear_point(t, weights);
  glm::dvec3 moved = linear;
  for (int i = 0; i < 3; ++i) {
    const std::uint32_t v = at[static_cast<std::size_t>(i)];
    const glm::dvec3 normal(normals_[v]);
    moved += 0.5 * weights[i] * glm::dot(vertex(v) - linear, normal) * normal;
  }
  return moved;
}

NearestSurface LimitSurface::nearest(const glm::dvec3& p, std::uint32_t hint) const {
  const NearestPoint nearest = nearest_linear(p, hint);
  const glm::dvec3 there = point(nearest.triangle, nearest.weights);
  return {glm::distance(p, there), there, nearest.triangle};
}

}  // namespace limn
