#pragma once

#include <cstdint>
#include <span>

#include "limn/mesh/control_mesh.h"

// Walks over what surrounds a vertex of the control mesh. Internal to this folder.
namespace limn {

/// Corners (one per face) around vertex v.
[[nodiscard]] inline std::span<const std::uint32_t> corners_around(const FlatTopology& topology,
                                                                   std::size_t v) noexcept {
  const std::uint32_t first = topology.vertex_offsets[v];
  return std::span(topology.vertex_corners).subspan(first, topology.vertex_offsets[v + 1] - first);
}

[[nodiscard]] inline std::span<const std::uint32_t> corners_of(const FlatTopology& topology,
                                                               std::size_t f) noexcept {
  const std::uint32_t first = topology.face_offsets[f];
  return std::span(topology.corner_vertices).subspan(first, topology.face_offsets[f + 1] - first);
}

[[nodiscard]] inline std::size_t sides_of(const FlatTopology& topology, std::size_t f) noexcept {
  return topology.face_offsets[f + 1] - topology.face_offsets[f];
}

[[nodiscard]] inline std::uint32_t next_corner(const FlatTopology& topology,
                                               std::uint32_t c) noexcept {
  const std::uint32_t f = topology.corner_faces[c];
  return c + 1 == topology.face_offsets[f + 1] ? topology.face_offsets[f] : c + 1;
}

[[nodiscard]] inline std::uint32_t previous_corner(const FlatTopology& topology,
                                                   std::uint32_t c) noexcept {
  const std::uint32_t f = topology.corner_faces[c];
  return c == topology.face_offsets[f] ? topology.face_offsets[f + 1] - 1 : c - 1;
}

/// Calls `visit(w)` once for every mesh edge vw.
template <class Visit>
void for_each_neighbour(const FlatTopology& topology, std::uint32_t v, const Visit& visit) {
  for (const std::uint32_t corner : corners_around(topology, v)) {
    visit(topology.corner_vertices[next_corner(topology, corner)]);
    const std::uint32_t before = previous_corner(topology, corner);
    if (topology.edge_corners[topology.corner_edges[before]][1] == kNone) {
      visit(topology.corner_vertices[before]);
    }
  }
}

}  // namespace limn
