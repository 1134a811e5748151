#include "subdivision/schemes/boundary_edges.h"

namespace limn {

BoundaryEdges boundary_edges(const LevelMesh& mesh) {
  BoundaryEdges boundary;
  for (std::uint32_t h = 0; h < mesh.half_edge_count(); ++h) {
    if (mesh.twins[h] == kNone) {
      if (boundary.ranks.empty()) {
        boundary.ranks.assign(mesh.edge_count, kNone);
      }
      boundary.ranks[mesh.edges[h]] = static_cast<std::uint32_t>(boundary.half_edges.size());
      boundary.half_edges.push_back(h);
    }
  }
  return boundary;
}

std::uint32_t boundary_before(const LevelMesh& mesh, std::uint32_t h) {
  return mesh.around(mesh.start(h), [](std::uint32_t) {});
}

}  // namespace limn
