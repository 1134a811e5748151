// Boundary vertices are sorted along the longest axis of the mesh, so that an edge is compared only
// with those beside it.
#include "limn/mesh/open_edges.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

namespace limn {
namespace {

/// Boundary edges as their corners: the edge runs from a corner's vertex to the next one's.
std::vector<std::uint32_t> boundary_corners(const FlatTopology& topology) {
  std::vector<std::uint32_t> corners;
  for (const auto& [corner, twin] : topology.edge_corners) {
    if (twin == kNone) {
      corners.push_back(corner);
    }
  }
  return corners;
}

std::uint32_t end_of(const FlatTopology& topology, std::uint32_t corner) {
  const std::uint32_t face = topology.corner_faces[corner];
  const std::uint32_t next =
      corner + 1 < topology.face_offsets[face + 1] ? corner + 1 : topology.face_offsets[face];
  return topology.corner_vertices[next];
}

struct PlacedVertex {
  double along = 0.0;
  std::uint32_t vertex = 0;
};

}  // namespace

std::vector<BoundaryLoop> boundary_loops(const ControlMesh& mesh) {
  const FlatTopology& topology = mesh.topology();
  // A boundary vertex of a manifold has one boundary edge that leaves it.
  std::vector<std::uint32_t> next(mesh.vertex_count(), kNone);
  for (const std::uint32_t corner : boundary_corners(topology)) {
    next[topology.corner_vertices[corner]] = end_of(topology, corner);
  }
  std::vector<BoundaryLoop> loops;
  for (std::uint32_t v = 0; v < next.size(); ++v) {
    if (next[v] == kNone) {
      continue;
    }
    BoundaryLoop loop;
    for (std::uint32_t at = v; next[at] != kNone;) {
      loop.push_back(at);
      at = std::exchange(next[at], kNone);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

std::vector<TJunction> find_t_junctions(const ControlMesh& mesh, double tolerance) {
  const FlatTopology& topology = mesh.topology();
  const std::span<const glm::dvec3> positions = mesh.positions();
  const glm::dvec3 extent = mesh.bounds().high - mesh.bounds().low;
  const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;

  const std::vector<std::uint32_t> corners = boundary_corners(topology);
  std::vector<PlacedVertex> sorted;
  sorted.reserve(corners.size());
  for (const std::uint32_t corner : corners) {
    const std::uint32_t v = topology.corner_vertices[corner];
    sorted.push_back({positions[v][axis], v});
  }
  std::ranges::sort(sorted, {}, &PlacedVertex::along);

  std::vector<TJunction> found;
  for (const std::uint32_t corner : corners) {
    const std::uint32_t from = topology.corner_vertices[corner];
    const std::uint32_t to = end_of(topology, corner);
    const glm::dvec3 a = positions[from];
    const glm::dvec3 way = positions[to] - a;
    const double length = glm::length(way);
    if (length == 0.0) {
      continue;
    }
    const double reach = tolerance * length;
    const double low = std::min(a[axis], positions[to][axis]) - reach;
    const double high = std::max(a[axis], positions[to][axis]) + reach;
    for (auto at = std::ranges::lower_bound(sorted, low, {}, &PlacedVertex::along);
         at != sorted.end() && at->along <= high; ++at) {
      const std::uint32_t v = at->vertex;
      if (v == from || v == to) {
        continue;
      }
      const glm::dvec3 offset = positions[v] - a;
      const double t = glm::dot(offset, way) / (length * length);
      const bool is_inside = t * length > reach && (1.0 - t) * length > reach;
      if (is_inside && glm::length(offset - t * way) <= reach) {
        found.push_back({v, topology.corner_edges[corner]});
      }
    }
  }
  std::ranges::sort(found, [](const TJunction& a, const TJunction& b) {
    return a.vertex != b.vertex ? a.vertex < b.vertex : a.edge < b.edge;
  });
  return found;
}

}  // namespace limn
