// A copy of the control mesh's flat arrays: its corners already are what a level calls corners.
#include <algorithm>

#include "limn/contract.h"
#include "subdivision/level.h"

namespace limn {

Level seed_level(const ControlMesh& mesh, const VertexLabels& labels, const glm::dvec3& origin) {
  const FlatTopology& topology = mesh.topology();
  const std::size_t corners = topology.corner_vertices.size();
  const std::size_t faces = mesh.face_count();
  const std::size_t vertices = mesh.vertex_count();

  Level level;
  level.corner_vertices = FlatArray<std::uint32_t>(corners);
  level.twins = FlatArray<std::uint32_t>(corners);
  for (std::uint32_t c = 0; c < corners; ++c) {
    level.corner_vertices[c] = topology.corner_vertices[c];
    const auto [one, other] = topology.edge_corners[topology.corner_edges[c]];
    level.twins[c] = one == c ? other : one;
  }
  static_assert(kBoundary == kNone);

  level.face_control_faces = FlatArray<std::uint32_t>(faces);
  level.face_is_virtual = FlatArray<std::uint8_t>(faces);
  for (std::uint32_t f = 0; f < faces; ++f) {
    level.face_control_faces[f] = f;
    level.face_is_virtual[f] = 0;
  }

  level.positions = FlatArray<glm::dvec3>(vertices);
  level.labels = FlatArray<std::uint8_t>(vertices);
  level.vertex_outputs = FlatArray<std::uint32_t>(vertices);
  level.vertex_corners = FlatArray<std::uint32_t>(vertices);
  for (std::uint32_t v = 0; v < vertices; ++v) {
    level.positions[v] = mesh.positions()[v] - origin;
    level.labels[v] = labels[v];
    level.vertex_outputs[v] = v;
    level.vertex_corners[v] = topology.vertex_corners[topology.vertex_offsets[v]];
  }
  // A walk around a boundary vertex has to begin on the boundary edge that leaves it.
  for (std::uint32_t c = 0; c < corners; ++c) {
    if (level.twins[c] == kBoundary) {
      level.vertex_corners[level.corner_vertices[c]] = c;
    }
  }
  return level;
}

}  // namespace limn
