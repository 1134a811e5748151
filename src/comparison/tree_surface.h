#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "comparison/cut_surface.h"
#include "comparison/triangle_tree.h"

// Internal to this folder.
namespace limn {

/// A surface of triangles that nearest points are looked for on: what all surfaces share that
/// comparison/directed_sampling.h measures.
template <class Scalar>
class TreeSurface {
 public:
  using Corners = std::array<std::uint32_t, 3>;

  TreeSurface(CutSurface<Scalar> cut, Sweep& sweep) : cut_(std::move(cut)) {
    tree_.build(cut_.points, cut_.triangles, sweep);
  }

  [[nodiscard]] std::size_t point_count() const noexcept { return cut_.points.size(); }
  [[nodiscard]] std::size_t triangle_count() const noexcept { return cut_.triangles.size(); }
  [[nodiscard]] glm::dvec3 vertex(std::size_t v) const noexcept {
    return glm::dvec3(cut_.points[v]);
  }
  [[nodiscard]] const Corners& corners(std::uint32_t t) const noexcept { return cut_.triangles[t]; }
  /// Of the polygon mesh.
  [[nodiscard]] std::uint32_t face(std::uint32_t t) const noexcept { return cut_.faces[t]; }
  [[nodiscard]] double area(std::uint32_t t) const noexcept {
    const Corners& at = cut_.triangles[t];
    const glm::dvec3 a = vertex(at[0]);
    return 0.5 * glm::length(glm::cross(vertex(at[1]) - a, vertex(at[2]) - a));
  }
  [[nodiscard]] glm::dvec3 linear_point(std::uint32_t t, const glm::dvec3& weights) const noexcept {
    const Corners& at = cut_.triangles[t];
    return weights.x * vertex(at[0]) + weights.y * vertex(at[1]) + weights.z * vertex(at[2]);
  }
  /// `hint`: a triangle that is likely near, or any number.
  [[nodiscard]] NearestPoint nearest_linear(const glm::dvec3& p, std::uint32_t hint) const {
    NearestPoint nearest;
    if (hint < cut_.triangles.size()) {
      const Corners& at = cut_.triangles[hint];
      nearest.triangle = hint;
      nearest.weights = nearest_weights(p, vertex(at[0]), vertex(at[1]), vertex(at[2]));
      const glm::dvec3 offset = linear_point(hint, nearest.weights) - p;
      nearest.square = glm::dot(offset, offset);
    }
    tree_.find_nearest(p, nearest);
    return nearest;
  }

 private:
  CutSurface<Scalar> cut_;
  TriangleTree<Scalar> tree_;
};

}  // namespace limn
