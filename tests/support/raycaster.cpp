// A tree of boxes, split at the median of the triangles' centres along the longest axis, and the
// intersection of Moeller and Trumbore. Boxes are tested by slabs; a ray parallel to a slab gives
// infinities, which compare as they should, and the one 0 * infinity is kept out by a tiny margin.

#include "support/raycaster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace limn::test {
namespace {

constexpr std::uint32_t kLeafSize = 4;
/// Barycentric slack: closes the cracks that rounding would leave along common edges.
constexpr double kSlack = 1e-12;

template <class Mesh>
Polygons gather(const Mesh& mesh) {
  Polygons polygons;
  polygons.offsets.reserve(mesh.face_count() + 1);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto corners = mesh.face(f);
    polygons.vertices.insert(polygons.vertices.end(), corners.begin(), corners.end());
    polygons.offsets.push_back(static_cast<std::uint32_t>(polygons.vertices.size()));
  }
  return polygons;
}

}  // namespace

Polygons polygons_of(const ControlMesh& mesh) {
  Polygons polygons = gather(mesh);
  polygons.positions.assign(mesh.positions().begin(), mesh.positions().end());
  return polygons;
}

Polygons polygons_of(const RefinedMesh& mesh) {
  Polygons polygons = gather(mesh);
  polygons.positions.reserve(mesh.vertex_count());
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    polygons.positions.push_back(mesh.position(v));
  }
  return polygons;
}

Raycaster::Raycaster(Polygons polygons) : polygons_(std::move(polygons)) {
  for (std::uint32_t f = 0; f < polygons_.face_count(); ++f) {
    const std::uint32_t first = polygons_.offsets[f];
    const glm::dvec3 a = polygons_.positions[polygons_.vertices[first]];
    for (std::uint32_t i = first + 1; i + 1 < polygons_.offsets[f + 1]; ++i) {
      triangles_.push_back({a, polygons_.positions[polygons_.vertices[i]] - a,
                            polygons_.positions[polygons_.vertices[i + 1]] - a, f});
    }
  }
  if (!triangles_.empty()) {
    build(0, static_cast<std::uint32_t>(triangles_.size()));
  }
}

void Raycaster::build(std::uint32_t first, std::uint32_t count) {
  const auto begin = triangles_.begin() + first;
  const auto end = begin + count;
  glm::dvec3 low(INFINITY);
  glm::dvec3 high(-INFINITY);
  for (auto it = begin; it != end; ++it) {
    for (const glm::dvec3& corner : {it->a, it->a + it->ab, it->a + it->ac}) {
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
  }
  const std::size_t node = nodes_.size();
  nodes_.push_back({low, high, first, count});
  if (count <= kLeafSize) {
    return;
  }
  const glm::dvec3 extent = high - low;
  const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  const auto centre = [axis](const Triangle& t) {
    return 3.0 * t.a[axis] + t.ab[axis] + t.ac[axis];
  };
  const std::uint32_t half = count / 2;
  std::nth_element(begin, begin + half, end,
                   [&](const Triangle& s, const Triangle& t) { return centre(s) < centre(t); });
  build(first, half);
  nodes_[node].first = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node].count = 0;
  build(first + half, count - half);
}

std::optional<Raycaster::Hit> Raycaster::nearest(const glm::dvec3& origin,
                                                 const glm::dvec3& direction) const {
  const glm::dvec3 inverse = 1.0 / direction;
  Hit best{std::numeric_limits<std::uint32_t>::max(), INFINITY};
  const auto enters = [&](const Node& node) {
    const double margin =
        1e-12 * glm::length(node.high - node.low) + std::numeric_limits<double>::min();
    const glm::dvec3 t0 = (node.low - margin - origin) * inverse;
    const glm::dvec3 t1 = (node.high + margin - origin) * inverse;
    const glm::dvec3 near = glm::min(t0, t1);
    const glm::dvec3 far = glm::max(t0, t1);
    const double in = std::max({near.x, near.y, near.z, 0.0});
    return in <= std::min({far.x, far.y, far.z, best.distance});
  };

  std::array<std::uint32_t, 64> stack;  // Depth is log2 of the triangles.
  std::size_t top = 0;
  if (!nodes_.empty()) {
    stack[top++] = 0;
  }
  while (top > 0) {
    const std::uint32_t index = stack[--top];
    const Node& node = nodes_[index];
    if (!enters(node)) {
      continue;
    }
    if (node.count == 0) {
      stack[top++] = node.first;
      stack[top++] = index + 1;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const Triangle& triangle = triangles_[i];
      const glm::dvec3 p = glm::cross(direction, triangle.ac);
      const double determinant = glm::dot(p, triangle.ab);
      if (determinant == 0.0) {
        continue;
      }
      const glm::dvec3 s = origin - triangle.a;
      const double u = glm::dot(s, p) / determinant;
      const glm::dvec3 q = glm::cross(s, triangle.ab);
      const double v = glm::dot(direction, q) / determinant;
      if (u < -kSlack || v < -kSlack || u + v > 1.0 + kSlack) {
        continue;
      }
      const double t = glm::dot(triangle.ac, q) / determinant;
      if (t >= 0.0 && (t < best.distance || (t == best.distance && triangle.face < best.face))) {
        best = {triangle.face, t};
      }
    }
  }
  return best.distance < INFINITY ? std::optional(best) : std::nullopt;
}

}  // namespace limn::test
