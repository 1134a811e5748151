// Walks around vertices go from a corner to the twin of the side that enters it.
#include "mesh/flat_topology.h"

#include <algorithm>
#include <span>

#include "limn/contract.h"

namespace limn::detail {
namespace {

std::uint32_t next(const FlatTopology& flat, std::uint32_t corner) {
  const std::uint32_t f = flat.corner_faces[corner];
  return corner + 1 == flat.face_offsets[f + 1] ? flat.face_offsets[f] : corner + 1;
}

std::uint32_t previous(const FlatTopology& flat, std::uint32_t corner) {
  const std::uint32_t f = flat.corner_faces[corner];
  return corner == flat.face_offsets[f] ? flat.face_offsets[f + 1] - 1 : corner - 1;
}

bool is_quad(const FlatTopology& flat, std::uint32_t corner) {
  const std::uint32_t f = flat.corner_faces[corner];
  return flat.face_offsets[f + 1] - flat.face_offsets[f] == 4;
}

void pair_corners(FlatTopology& flat) {
  flat.corner_twins.assign(flat.corner_edges.size(), kNone);
  for (const auto [one, other] : flat.edge_corners) {
    if (other != kNone) {
      flat.corner_twins[one] = other;
      flat.corner_twins[other] = one;
    }
  }
}

void order_corners(FlatTopology& flat, std::size_t vertices) {
  const auto corners = static_cast<std::uint32_t>(flat.corner_vertices.size());
  std::vector<std::uint32_t> starts(vertices, kNone);
  for (std::uint32_t corner = 0; corner < corners; ++corner) {
    std::uint32_t& start = starts[flat.corner_vertices[corner]];
    if (start == kNone || flat.corner_twins[corner] == kNone) {
      start = corner;
    }
  }
  flat.vertex_offsets.reserve(vertices + 1);
  flat.vertex_offsets.push_back(0);
  flat.vertex_corners.reserve(corners);
  flat.corner_ranks.resize(corners);
  for (const std::uint32_t start : starts) {
    LIMN_EXPECTS(start != kNone && "no isolated vertices");
    std::uint32_t corner = start;
    do {
      flat.corner_ranks[corner] =
          static_cast<std::uint32_t>(flat.vertex_corners.size()) - flat.vertex_offsets.back();
      flat.vertex_corners.push_back(corner);
      corner = flat.corner_twins[previous(flat, corner)];
    } while (corner != kNone && corner != start);
    flat.vertex_offsets.push_back(static_cast<std::uint32_t>(flat.vertex_corners.size()));
  }
  // A vertex with several fans of faces would have left corners out.
  LIMN_EXPECTS(flat.vertex_corners.size() == corners);
}

std::span<const std::uint32_t> corners_around(const FlatTopology& flat, std::size_t v) {
  return std::span(flat.vertex_corners)
      .subspan(flat.vertex_offsets[v], flat.vertex_offsets[v + 1] - flat.vertex_offsets[v]);
}

bool is_regular(const FlatTopology& flat, std::span<const std::uint32_t> corners) {
  const bool is_boundary = flat.corner_twins[corners[0]] == kNone;
  return corners.size() == (is_boundary ? 2 : 4) &&
         std::ranges::all_of(corners, [&flat](std::uint32_t c) { return is_quad(flat, c); });
}

void list_irregular_vertices(FlatTopology& flat) {
  for (std::uint32_t v = 0; v + 1 < flat.vertex_offsets.size(); ++v) {
    if (!is_regular(flat, corners_around(flat, v))) {
      flat.irregular_vertices.push_back(v);
    }
  }
}

/// The three vertices of a quad's ring at one of its corners.
std::array<std::uint32_t, 3> ring_at(const FlatTopology& flat, std::uint32_t corner) {
  std::array<std::uint32_t, 3> ring{kNone, kNone, kNone};
  const std::uint32_t entering = previous(flat, corner);
  const std::uint32_t below = flat.corner_twins[corner];
  const std::uint32_t beside = flat.corner_twins[entering];
  if (below != kNone) {
    ring[0] = flat.corner_vertices[next(flat, next(flat, below))];
  }
  if (beside != kNone) {
    ring[1] = flat.corner_vertices[previous(flat, beside)];
  }
  const auto around = corners_around(flat, flat.corner_vertices[corner]);
  if (around.size() == 4 && is_regular(flat, around)) {
    const std::uint32_t across = around[(flat.corner_ranks[corner] + 2) % 4];
    ring[2] = flat.corner_vertices[next(flat, next(flat, across))];
  }
  return ring;
}

void surround_quads(FlatTopology& flat) {
  const std::size_t faces = flat.face_offsets.size() - 1;
  flat.quad_rings.resize(faces);
  for (std::size_t f = 0; f < faces; ++f) {
    std::array<std::uint32_t, 12>& ring = flat.quad_rings[f];
    ring.fill(kNone);
    const std::uint32_t first = flat.face_offsets[f];
    for (std::uint32_t i = 0; i < 4 && is_quad(flat, first); ++i) {
      const std::array<std::uint32_t, 3> at = ring_at(flat, first + i);
      ring[3 * i] = at[0];
      ring[3 * i + 1] = at[1];
      ring[3 * i + 2] = at[2];
    }
  }
}

}  // namespace

void complete_topology(FlatTopology& flat, std::size_t vertices) {
  pair_corners(flat);
  order_corners(flat, vertices);
  list_irregular_vertices(flat);
  surround_quads(flat);
}

}  // namespace limn::detail
