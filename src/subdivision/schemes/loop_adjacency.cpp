#include "limn/subdivision/schemes/loop_adjacency.h"

#include "limn/contract.h"
#include "subdivision/schemes/triangle_split.h"

namespace limn {

LoopAdjacency loop_adjacency(const ControlMesh& mesh) {
  const FlatTopology& flat = mesh.topology();
  LIMN_EXPECTS(flat.corner_vertices.size() == 3 * mesh.face_count());
  LoopAdjacency adjacency;
  adjacency.row_offsets.reserve(mesh.vertex_count() + 1);
  adjacency.row_offsets.push_back(0);
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    std::uint32_t last = kNone;
    const auto row = adjacency.rows.size();
    adjacency.rows.push_back(0);  // The number of neighbours, once it is known.
    for (std::uint32_t i = flat.vertex_offsets[v]; i < flat.vertex_offsets[v + 1]; ++i) {
      last = flat.vertex_corners[i];
      adjacency.rows.push_back(flat.corner_vertices[next_in_triangle(last)]);
    }
    const std::uint32_t arriving = previous_in_triangle(last);
    if (flat.corner_twins[arriving] == kNone) {
      adjacency.rows.push_back(flat.corner_vertices[arriving]);
    }
    adjacency.rows[row] = static_cast<std::uint32_t>(adjacency.rows.size() - row - 1);
    adjacency.row_offsets.push_back(static_cast<std::uint32_t>(adjacency.rows.size()));
  }
  adjacency.midpoints.reserve(mesh.edge_count());
  for (std::size_t e = 0; e < mesh.edge_count(); ++e) {
    const auto [one, other] = flat.edge_corners[e];
    const auto opposite = [&flat](std::uint32_t corner) {
      return corner == kNone ? kNone : flat.corner_vertices[previous_in_triangle(corner)];
    };
    adjacency.midpoints.push_back(
        {flat.edge_vertices[e][0], flat.edge_vertices[e][1], opposite(one), opposite(other)});
  }
  return adjacency;
}

}  // namespace limn
