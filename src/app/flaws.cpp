// Found anew for each place: a press of a button may take as long as one look at the mesh.
#include "app/flaws.h"

#include <algorithm>

#include "limn/mesh/open_edges.h"

namespace limn::app {
namespace {

/// So much of the mesh's diagonal is seen to either side of a place, at the least.
constexpr double kSurroundings = 0.02;

FlawPlace place_of(std::vector<glm::dvec3> points, double diagonal) {
  FlawPlace place;
  for (const glm::dvec3& point : points) {
    place.position += point / static_cast<double>(points.size());
  }
  place.around = std::move(points);
  for (const double sign : {-1.0, 1.0}) {
    place.around.push_back(place.position + glm::dvec3(sign * kSurroundings * diagonal));
  }
  return place;
}

std::vector<glm::dvec3> corners_of(const RefinedMesh& mesh, std::uint32_t face) {
  std::vector<glm::dvec3> corners;
  if (face < mesh.quads.size()) {
    for (const std::uint32_t v : mesh.quads[face]) {
      corners.push_back(mesh.position(v));
    }
    return corners;
  }
  const std::size_t polygon = face - mesh.quads.size();
  for (std::uint32_t i = mesh.polygon_offsets[polygon]; i < mesh.polygon_offsets[polygon + 1];
       ++i) {
    corners.push_back(mesh.position(mesh.polygon_vertices[i]));
  }
  return corners;
}

/// The place among `count` that `place(index)` tells.
template <class Place>
std::optional<FlawPlace> pick(std::size_t element, std::size_t count, const Place& place) {
  if (count == 0) {
    return std::nullopt;
  }
  FlawPlace picked = place(element % count);
  picked.element = element % count;
  picked.count = count;
  return picked;
}

}  // namespace

std::optional<FlawPlace> flaw_place(ui::FlawKind kind, std::size_t element,
                                    const FlawSource& source) {
  const std::span<const glm::dvec3> positions = source.control.positions();
  const double diagonal = source.control.bounds().diagonal();
  switch (kind) {
    case ui::FlawKind::kBoundary: {
      const std::vector<BoundaryLoop> loops = boundary_loops(source.control);
      return pick(element, loops.size(), [&](std::size_t i) {
        std::vector<glm::dvec3> points;
        for (const std::uint32_t v : loops[i]) {
          points.push_back(positions[v]);
        }
        return place_of(std::move(points), diagonal);
      });
    }
    case ui::FlawKind::kTJunction: {
      const std::vector<TJunction> junctions = find_t_junctions(source.control);
      return pick(element, junctions.size(), [&](std::size_t i) {
        FlawPlace place = place_of({positions[junctions[i].vertex]}, diagonal);
        for (const std::uint32_t v : source.control.topology().edge_vertices[junctions[i].edge]) {
          place.around.push_back(positions[v]);
        }
        return place;
      });
    }
    case ui::FlawKind::kCrack:
      if (source.refined == nullptr || source.cracks == nullptr) {
        return std::nullopt;
      }
      return pick(element, source.cracks->crack_faces.size(), [&](std::size_t i) {
        return place_of(corners_of(*source.refined, source.cracks->crack_faces[i]), diagonal);
      });
  }
  return std::nullopt;
}

}  // namespace limn::app
