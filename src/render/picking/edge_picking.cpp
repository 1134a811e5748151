#include "render/picking/edge_picking.h"

#include <algorithm>
#include <span>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "limn/contract.h"

namespace limn::render {
namespace {

double distance_to_segment(glm::dvec2 point, glm::dvec2 a, glm::dvec2 b) {
  const glm::dvec2 along = b - a;
  const double length2 = glm::dot(along, along);
  const double part = length2 > 0.0 ? glm::dot(point - a, along) / length2 : 0.0;
  return glm::distance(point, a + std::clamp(part, 0.0, 1.0) * along);
}

}  // namespace

std::optional<std::uint32_t> nearest_edge(const ControlMesh& mesh, const Camera& camera,
                                          std::uint32_t face, const EdgeAim& aim) {
  LIMN_EXPECTS(face < mesh.face_count());
  const std::span<const std::uint32_t> corners = mesh.face(face);
  const std::uint32_t first_corner = mesh.topology().face_offsets[face];
  std::optional<std::uint32_t> nearest;
  double reach = aim.reach;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto from = project(camera, mesh.positions()[corners[i]]);
    const auto to = project(camera, mesh.positions()[corners[(i + 1) % corners.size()]]);
    if (!from || !to) {
      continue;
    }
    const double away = distance_to_segment(
        {aim.point.x, aim.point.y}, {from->point.x, from->point.y}, {to->point.x, to->point.y});
    if (away <= reach) {
      reach = away;
      nearest = mesh.topology().corner_edges[first_corner + i];
    }
  }
  return nearest;
}

}  // namespace limn::render
