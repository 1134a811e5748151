#include "hierarchy_rings.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "subdivision/sharpness.h"

namespace limn::test {
namespace {

glm::dvec3 centroid(const UniformHierarchy& hierarchy, const std::vector<glm::dvec3>& positions,
                    int level, std::uint32_t face) {
  const auto vertices = hierarchy.face_vertices(level, face);
  glm::dvec3 sum(0.0);
  for (const std::uint32_t v : vertices) {
    sum += positions[v];
  }
  return sum / static_cast<double>(vertices.size());
}

std::uint32_t other_end(const UniformHierarchy& hierarchy, int level, std::uint32_t edge,
                        std::uint32_t vertex) {
  const auto [a, b] = hierarchy.edge_vertices(level, edge);
  return a == vertex ? b : a;
}

/// Of the semi-sharp edges at a vertex besides one. In OpenSubdiv's order, since it adds floats.
float mean_sharpness_besides(const UniformHierarchy& hierarchy, int level, std::uint32_t vertex,
                             std::uint32_t edge) {
  SharpnessSum sum;
  for (const std::uint32_t other : hierarchy.vertex_edges(level, vertex)) {
    sum.add(hierarchy.edge_sharpness(level, other));
  }
  return sum.mean_besides(hierarchy.edge_sharpness(level, edge));
}

}  // namespace

VertexRing ring_at(const UniformHierarchy& hierarchy, const std::vector<glm::dvec3>& positions,
                   int level, std::uint32_t vertex) {
  const auto edges = hierarchy.vertex_edges(level, vertex);
  const auto faces = hierarchy.vertex_faces(level, vertex);
  VertexRing ring;
  ring.reset(faces.size(), edges.size() > faces.size());
  ring.centre() = to_point(positions[vertex]);
  ring.vertex_sharpness() = hierarchy.vertex_sharpness(level, vertex);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const std::uint32_t far = other_end(hierarchy, level, edges[i], vertex);
    ring.edges()[i] = to_point(positions[far]);
    ring.edge_sharpness()[i] = hierarchy.edge_sharpness(level, edges[i]);
    if (is_semi_sharp(ring.edge_sharpness()[i])) {
      ring.far_sharpness()[i] = mean_sharpness_besides(hierarchy, level, far, edges[i]);
    }
  }
  for (std::size_t i = 0; i < faces.size(); ++i) {
    ring.centroids()[i] = to_point(centroid(hierarchy, positions, level, faces[i]));
  }
  return ring;
}

Feature::Feature(const VertexRing& ring) : is_corner(ring.vertex_sharpness() > 0.0f) {
  for (std::size_t i = 0; i < ring.edge_sharpness().size(); ++i) {
    if (ring.edge_sharpness()[i] > 0.0f) {
      first = count == 0 ? i : first;
      last = i;
      ++count;
    }
  }
  is_corner = is_corner || count > 2;
}

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  const double cosine = glm::dot(a, b);
  return cosine == 0.0 ? 0.5 * std::numbers::pi : std::atan2(glm::length(glm::cross(a, b)), cosine);
}

}  // namespace limn::test
