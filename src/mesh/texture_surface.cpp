// A point is a stretch of corners around a control vertex with no seam between them; it is found
// from any of its corners by joining neighbours across edges that are no seams.
#include <algorithm>
#include <span>

#include "limn/contract.h"
#include "limn/mesh/texture_coordinates.h"
#include "mesh/flat_topology.h"

namespace limn {
namespace {

/// Whether both faces of an inner edge give both of its ends the same points of the texture.
bool is_seam(const FlatTopology& control, const std::vector<std::uint32_t>& values,
             std::uint32_t corner, std::uint32_t twin) {
  const auto next = [&control](std::uint32_t c) {
    const std::uint32_t f = control.corner_faces[c];
    return c + 1 == control.face_offsets[f + 1] ? control.face_offsets[f] : c + 1;
  };
  return values[corner] != values[next(twin)] || values[next(corner)] != values[twin];
}

/// Edges and the corners that meet there.
void cut_edges(const FlatTopology& control, const std::vector<std::uint32_t>& values,
               TextureSurface& surface) {
  FlatTopology& flat = surface.topology;
  flat.corner_edges.resize(control.corner_edges.size());
  const auto add_edge = [&](std::uint32_t edge, std::uint32_t one, std::uint32_t other) {
    const auto number = static_cast<std::uint32_t>(flat.edge_corners.size());
    flat.edge_corners.push_back({one, other});
    flat.corner_edges[one] = number;
    if (other != kNone) {
      flat.corner_edges[other] = number;
    }
    surface.edges.push_back(edge);
  };
  for (std::uint32_t e = 0; e < control.edge_corners.size(); ++e) {
    const auto [one, other] = control.edge_corners[e];
    if (other != kNone && is_seam(control, values, one, other)) {
      add_edge(e, one, kNone);
      add_edge(e, other, kNone);
    } else {
      add_edge(e, one, other);
    }
  }
}

/// Numbers the points and gives every corner its own.
void join_corners(const FlatTopology& control, const TextureCoordinates& texture,
                  TextureSurface& surface) {
  FlatTopology& flat = surface.topology;
  flat.corner_vertices.resize(control.corner_vertices.size());
  const auto is_joined = [&](std::uint32_t before, std::uint32_t after) {
    // Around a vertex the edge between two faces leaves from the later one's corner.
    const std::uint32_t edge = flat.corner_edges[after];
    return flat.edge_corners[edge][1] != kNone && control.corner_twins[after] != kNone &&
           texture.corner_values[before] == texture.corner_values[after];
  };
  for (std::uint32_t v = 0; v + 1 < control.vertex_offsets.size(); ++v) {
    const auto corners = std::span(control.vertex_corners)
                             .subspan(control.vertex_offsets[v],
                                      control.vertex_offsets[v + 1] - control.vertex_offsets[v]);
    const std::size_t n = corners.size();
    // Start where a stretch starts, if there is a seam at all.
    std::size_t start = 0;
    while (start < n && is_joined(corners[(start + n - 1) % n], corners[start])) {
      ++start;
    }
    start %= n;
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint32_t corner = corners[(start + i) % n];
      if (i == 0 || !is_joined(corners[(start + i - 1) % n], corner)) {
        const glm::dvec2& value = texture.values[texture.corner_values[corner]];
        surface.points.emplace_back(value.x, value.y, 0.0);
        surface.vertices.push_back(v);
      }
      flat.corner_vertices[corner] = static_cast<std::uint32_t>(surface.points.size() - 1);
    }
  }
}

}  // namespace

TextureSurface make_texture_surface(const FlatTopology& control,
                                    const TextureCoordinates& texture) {
  LIMN_EXPECTS(texture.corner_values.size() == control.corner_vertices.size());
  TextureSurface surface;
  FlatTopology& flat = surface.topology;
  flat.face_offsets = control.face_offsets;
  flat.corner_faces = control.corner_faces;
  cut_edges(control, texture.corner_values, surface);
  join_corners(control, texture, surface);
  flat.edge_vertices.reserve(flat.edge_corners.size());
  for (const auto& corners : flat.edge_corners) {
    const std::uint32_t f = flat.corner_faces[corners[0]];
    const std::uint32_t after =
        corners[0] + 1 == flat.face_offsets[f + 1] ? flat.face_offsets[f] : corners[0] + 1;
    flat.edge_vertices.push_back({flat.corner_vertices[corners[0]], flat.corner_vertices[after]});
  }
  detail::complete_topology(flat, surface.points.size());
  return surface;
}

}  // namespace limn
