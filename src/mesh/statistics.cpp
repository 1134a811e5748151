// Counts over the flat topology; only boundary loops follow OpenMesh's half-edges, which link them.
#include "limn/mesh/statistics.h"

#include <algorithm>
#include <vector>

namespace limn {
namespace {

std::map<std::size_t, std::size_t> count_by_sides(const FlatTopology& topology) {
  std::vector<std::size_t> counts;
  for (std::size_t f = 0; f + 1 < topology.face_offsets.size(); ++f) {
    const std::size_t sides = topology.face_offsets[f + 1] - topology.face_offsets[f];
    counts.resize(std::max(counts.size(), sides + 1), 0);
    ++counts[sides];
  }
  std::map<std::size_t, std::size_t> by_sides;
  for (std::size_t sides = 0; sides < counts.size(); ++sides) {
    if (counts[sides] > 0) {
      by_sides[sides] = counts[sides];
    }
  }
  return by_sides;
}

/// Floods over edges.
std::size_t count_components(const FlatTopology& topology) {
  const std::size_t faces = topology.face_offsets.size() - 1;
  std::vector<std::uint8_t> is_seen(faces, 0);
  std::vector<std::uint32_t> waiting;
  std::size_t components = 0;
  for (std::uint32_t seed = 0; seed < faces; ++seed) {
    if (is_seen[seed] != 0) {
      continue;
    }
    ++components;
    is_seen[seed] = 1;
    waiting.push_back(seed);
    while (!waiting.empty()) {
      const std::uint32_t f = waiting.back();
      waiting.pop_back();
      for (std::uint32_t c = topology.face_offsets[f]; c < topology.face_offsets[f + 1]; ++c) {
        for (const std::uint32_t corner : topology.edge_corners[topology.corner_edges[c]]) {
          if (corner != kNone && is_seen[topology.corner_faces[corner]] == 0) {
            is_seen[topology.corner_faces[corner]] = 1;
            waiting.push_back(topology.corner_faces[corner]);
          }
        }
      }
    }
  }
  return components;
}

/// Follows the half-edges that have no face.
std::size_t count_boundary_loops(const HalfedgeMesh& mesh) {
  std::vector<std::uint8_t> is_seen(mesh.n_halfedges(), 0);
  std::size_t loops = 0;
  for (const auto start : mesh.halfedges()) {
    if (!mesh.is_boundary(start) || is_seen[static_cast<std::size_t>(start.idx())] != 0) {
      continue;
    }
    ++loops;
    for (const auto halfedge : mesh.hl_range(start)) {
      is_seen[static_cast<std::size_t>(halfedge.idx())] = 1;
    }
  }
  return loops;
}

std::size_t count_sharp(const std::vector<float>& sharpness) {
  return static_cast<std::size_t>(
      std::ranges::count_if(sharpness, [](float s) { return s > 0.0f; }));
}

std::size_t count_seams(const ControlMesh& mesh) {
  if (mesh.texture().empty()) {
    return 0;
  }
  const FlatTopology& topology = mesh.topology();
  const std::vector<std::uint32_t>& points = mesh.texture().corner_values;
  const auto next = [&](std::uint32_t corner) {
    const std::uint32_t f = topology.corner_faces[corner];
    return corner + 1 < topology.face_offsets[f + 1] ? corner + 1 : topology.face_offsets[f];
  };
  std::size_t seams = 0;
  for (const auto [corner, twin] : topology.edge_corners) {
    const bool is_seam = twin != kNone && (points[corner] != points[next(twin)] ||
                                           points[next(corner)] != points[twin]);
    seams += is_seam ? 1 : 0;
  }
  return seams;
}

}  // namespace

MeshStatistics mesh_statistics(const ControlMesh& mesh) {
  const FlatTopology& topology = mesh.topology();
  MeshStatistics result;
  result.vertices = mesh.vertex_count();
  result.edges = mesh.edge_count();
  result.faces = mesh.face_count();
  result.faces_by_sides = count_by_sides(topology);
  result.components = count_components(topology);
  result.boundary_loops = count_boundary_loops(mesh.halfedges());
  result.euler_characteristic = static_cast<long>(result.vertices) -
                                static_cast<long>(result.edges) + static_cast<long>(result.faces);
  for (const auto& corners : topology.edge_corners) {
    result.boundary_edges += corners[1] == kNone ? 1 : 0;
  }
  result.crease_edges = count_sharp(mesh.creases().edge_sharpness);
  result.sharp_vertices = count_sharp(mesh.creases().vertex_sharpness);
  result.uv_points = mesh.texture().empty() ? 0 : mesh.texture().values.size();
  result.uv_seams = count_seams(mesh);
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    // Edges at a vertex: one more than faces where the fan is open. Its first corner's edge is
    // then a boundary.
    const std::uint32_t begin = topology.vertex_offsets[v];
    const std::size_t faces = topology.vertex_offsets[v + 1] - begin;
    const std::uint32_t first_edge = topology.corner_edges[topology.vertex_corners[begin]];
    const bool is_open = topology.edge_corners[first_edge][1] == kNone;
    result.highest_valence = std::max(result.highest_valence, faces + (is_open ? 1 : 0));
  }
  return result;
}

}  // namespace limn
