#include "subdivision/schemes/level_mesh.h"

#include <algorithm>

#include "limn/contract.h"
#include "mesh/edge_matching.h"

namespace limn {
namespace {

LargeArray<float> sharpness_of(const std::vector<float>& sharpness) {
  const bool is_any = std::ranges::any_of(sharpness, [](float s) { return s > 0.0f; });
  return is_any ? LargeArray<float>(sharpness.begin(), sharpness.end()) : LargeArray<float>();
}

/// How many sides all faces have, or 0.
std::uint32_t common_sides(const ControlMesh& mesh) {
  const std::size_t sides = mesh.face(0).size();
  for (std::size_t f = 1; f < mesh.face_count(); ++f) {
    if (mesh.face(f).size() != sides) {
      return 0;
    }
  }
  return static_cast<std::uint32_t>(sides);
}

}  // namespace

LevelMesh level_of(const ControlMesh& mesh, const glm::dvec3& origin) {
  const FlatTopology& flat = mesh.topology();
  LevelMesh level;
  level.faces.sides = common_sides(mesh);
  level.faces.corners.assign(flat.corner_vertices.begin(), flat.corner_vertices.end());
  if (level.faces.sides == 0) {
    level.faces.starts.assign(flat.face_offsets.begin(), flat.face_offsets.end());
    level.half_edge_faces.assign(flat.corner_faces.begin(), flat.corner_faces.end());
  }
  level.faces.control_faces.resize(mesh.face_count());
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    level.faces.control_faces[f] = f;
  }
  level.twins.assign(flat.corner_twins.begin(), flat.corner_twins.end());
  level.edges.assign(flat.corner_edges.begin(), flat.corner_edges.end());
  level.edge_count = flat.edge_vertices.size();
  level.vertex_starts.resize(mesh.vertex_count());
  level.points.resize(mesh.vertex_count());
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    level.vertex_starts[v] = flat.vertex_corners[flat.vertex_offsets[v]];
    level.points[v] = to_point(mesh.positions()[v] - origin);
  }
  level.edge_sharpness = sharpness_of(mesh.creases().edge_sharpness);
  level.vertex_sharpness = sharpness_of(mesh.creases().vertex_sharpness);
  level.creasing = mesh.creases().method;
  return level;
}

void number_half_edge_faces(LevelMesh& mesh) {
  if (mesh.faces.sides != 0) {
    return;
  }
  mesh.half_edge_faces.resize(mesh.faces.corners.size());
  for (std::uint32_t f = 0; f < mesh.faces.count(); ++f) {
    std::fill(mesh.half_edge_faces.begin() + mesh.faces.starts[f],
              mesh.half_edge_faces.begin() + mesh.faces.starts[f + 1], f);
  }
}

void connect(std::size_t vertices, LevelMesh& mesh) {
  number_half_edge_faces(mesh);
  std::vector<std::uint32_t> starts(mesh.faces.count() + 1);
  for (std::size_t f = 0; f < starts.size(); ++f) {
    starts[f] = mesh.faces.first(f);
  }
  const detail::EdgeMatching matching = detail::match_edges({starts, mesh.faces.corners, vertices});
  mesh.edge_count = matching.edge_corners.size();
  mesh.edges.assign(matching.corner_edges.begin(), matching.corner_edges.end());
  mesh.twins.resize(mesh.edges.size());
  for (const auto& [one, other] : matching.edge_corners) {
    mesh.twins[one] = other;
    if (other != kNone) {
      mesh.twins[other] = one;
    }
  }
  mesh.vertex_starts.assign(vertices, kNone);
  for (std::uint32_t h = 0; h < mesh.half_edge_count(); ++h) {
    std::uint32_t& start = mesh.vertex_starts[mesh.start(h)];
    if (start == kNone || mesh.twins[h] == kNone) {
      start = h;
    }
  }
}

}  // namespace limn
