#include "subdivision/schemes/part_of_level.h"

namespace limn {
namespace {

void number_vertices(const LevelMesh& whole, PartOfLevel& part) {
  std::vector<std::uint32_t> numbers(whole.vertex_count(), kNone);
  LevelFaces& faces = part.mesh.faces;
  faces.sides = 3;
  for (std::uint32_t f = 0; f < whole.faces.count(); ++f) {
    if (part.faces[f] == kNone) {
      continue;
    }
    faces.control_faces.push_back(whole.faces.control_faces[f]);
    for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) {
      std::uint32_t& number = numbers[whole.start(h)];
      if (number == kNone) {
        number = static_cast<std::uint32_t>(part.vertices.size());
        part.vertices.push_back(whole.start(h));
      }
      faces.corners.push_back(number);
    }
  }
}

void connect_part(const LevelMesh& whole, PartOfLevel& part) {
  LevelMesh& mesh = part.mesh;
  const std::size_t half_edges = mesh.faces.corners.size();
  mesh.twins.resize(half_edges);
  mesh.edges.resize(half_edges);
  mesh.vertex_starts.assign(part.vertices.size(), kNone);
  const bool has_sharp_edges = !whole.edge_sharpness.empty();
  std::uint32_t h = 0;
  for (std::uint32_t f = 0; f < whole.faces.count(); ++f) {
    if (part.faces[f] == kNone) {
      continue;
    }
    for (std::uint32_t i = 0; i < 3; ++i, ++h) {
      const std::uint32_t twin = whole.twins[3 * f + i];
      const std::uint32_t beyond = twin == kNone ? kNone : part.faces[twin / 3];
      mesh.twins[h] = beyond == kNone ? kNone : 3 * beyond + twin % 3;
      if (mesh.is_first(h)) {
        mesh.edges[h] = static_cast<std::uint32_t>(mesh.edge_count++);
        if (has_sharp_edges) {
          mesh.edge_sharpness.push_back(whole.edge_sharpness[whole.edges[3 * f + i]]);
        }
      } else {
        mesh.edges[h] = mesh.edges[mesh.twins[h]];
      }
      std::uint32_t& start = mesh.vertex_starts[mesh.start(h)];
      if (start == kNone || mesh.twins[h] == kNone) {
        start = h;
      }
    }
  }
}

}  // namespace

PartOfLevel part_of(const LevelMesh& whole, const std::vector<bool>& is_kept) {
  PartOfLevel part;
  part.mesh.level = whole.level;
  part.mesh.creasing = whole.creasing;
  part.faces.assign(whole.faces.count(), kNone);
  std::uint32_t count = 0;
  for (std::size_t f = 0; f < whole.faces.count(); ++f) {
    if (is_kept[f]) {
      part.faces[f] = count++;
    }
  }
  number_vertices(whole, part);
  connect_part(whole, part);
  part.mesh.points.resize(part.vertices.size());
  for (std::size_t v = 0; v < part.vertices.size(); ++v) {
    part.mesh.points[v] = whole.points[part.vertices[v]];
  }
  if (!whole.vertex_sharpness.empty()) {
    part.mesh.vertex_sharpness.resize(part.vertices.size());
    for (std::size_t v = 0; v < part.vertices.size(); ++v) {
      part.mesh.vertex_sharpness[v] = whole.vertex_sharpness[part.vertices[v]];
    }
  }
  return part;
}

}  // namespace limn
