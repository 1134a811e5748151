// A corner gives one spoke: the edge to the next corner of its face. Faces stand counter-clockwise
// around a vertex, so the other edge of a face at the vertex belongs to the next spoke. At a
// boundary the last face leaves one more.
#include "subdivision/legalisation_rings.h"

#include <algorithm>

#include "subdivision/surroundings.h"

namespace limn {

SpokeRings::SpokeRings(const FlatTopology& topology, const VertexLabels& labels) {
  const auto vertices = static_cast<std::uint32_t>(topology.vertex_offsets.size() - 1);
  first_.reserve(vertices + 1);
  spokes_.reserve(2 * topology.edge_vertices.size());
  first_.push_back(0);
  for (std::uint32_t v = 0; v < vertices; ++v) {
    if (labels[v] > 0) {
      first_.push_back(first_.back());
      continue;
    }
    const std::span<const std::uint32_t> corners = corners_around(topology, v);
    for (const std::uint32_t corner : corners) {
      const std::uint32_t next = next_corner(topology, corner);
      const bool is_quad = sides_of(topology, topology.corner_faces[corner]) == 4;
      spokes_.push_back({topology.corner_vertices[next],
                         is_quad ? topology.corner_vertices[next_corner(topology, next)] : kNone});
    }
    const std::uint32_t before = previous_corner(topology, corners.back());
    if (topology.corner_twins[before] == kNone) {
      spokes_.push_back({topology.corner_vertices[before], kNone});
    }
    most_spokes_ = std::max(most_spokes_, spokes_.size() - first_.back());
    first_.push_back(static_cast<std::uint32_t>(spokes_.size()));
  }
}

}  // namespace limn
