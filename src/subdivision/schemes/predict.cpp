// Counts follow from counts: of half-edges, edges on the boundary, and what is special to a scheme.
#include <algorithm>
#include <span>

#include "limn/contract.h"
#include "limn/subdivision/schemes/uniform.h"

namespace limn {
namespace {

struct Tally {
  std::uint64_t vertices = 0;
  std::uint64_t edges = 0;
  std::uint64_t faces = 0;
  std::uint64_t half_edges = 0;
  std::uint64_t boundary = 0;  ///< Edges, and so vertices.
  std::uint64_t corners = 0;   ///< Boundary vertices of one face that stay.

  [[nodiscard]] Tally with_edges() const noexcept {
    Tally tally = *this;
    tally.edges = (half_edges + boundary) / 2;
    return tally;
  }
};

/// Vertices inside between two edges only, in rows that are joined by edges: a row that ends, and
/// one that closes on itself.
struct TwoEdgedRows {
  std::vector<std::uint64_t> open;
  std::uint64_t closed = 0;

  /// Midedge takes an edge's middle for a vertex, so that a row loses one each level.
  [[nodiscard]] std::uint64_t vertices(std::uint64_t level) const noexcept {
    std::uint64_t count = closed;
    for (const std::uint64_t length : open) {
      count += length > level ? length - level : 0;
    }
    return count;
  }
};

bool is_two_edged(const FlatTopology& flat, std::uint32_t v) {
  return flat.vertex_offsets[v + 1] - flat.vertex_offsets[v] == 2 &&
         flat.corner_twins[flat.vertex_corners[flat.vertex_offsets[v]]] != kNone;
}

std::uint32_t end_of(const FlatTopology& flat, std::uint32_t corner) {
  const auto& ends = flat.edge_vertices[flat.corner_edges[corner]];
  return ends[0] == flat.corner_vertices[corner] ? ends[1] : ends[0];
}

TwoEdgedRows two_edged_rows(const ControlMesh& mesh) {
  const FlatTopology& flat = mesh.topology();
  TwoEdgedRows rows;
  std::vector<bool> is_seen(mesh.vertex_count(), false);
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (is_seen[v] || !is_two_edged(flat, v)) {
      continue;
    }
    is_seen[v] = true;
    std::uint64_t length = 1;
    bool is_closed = false;
    for (std::uint32_t side = 0; side < 2 && !is_closed; ++side) {
      std::uint32_t before = v;
      std::uint32_t at = end_of(flat, flat.vertex_corners[flat.vertex_offsets[v] + side]);
      while (is_two_edged(flat, at) && !is_seen[at]) {
        is_seen[at] = true;
        ++length;
        const std::uint32_t first = flat.vertex_corners[flat.vertex_offsets[at]];
        const std::uint32_t second = flat.vertex_corners[flat.vertex_offsets[at] + 1];
        const std::uint32_t on = end_of(flat, first) == before ? second : first;
        before = at;
        at = end_of(flat, on);
      }
      is_closed = at == v && length > 2;
    }
    if (is_closed) {
      rows.closed += length;
    } else {
      rows.open.push_back(length);
    }
  }
  return rows;
}

Tally tally_of(const ControlMesh& mesh, const SchemeSettings& settings) {
  const FlatTopology& flat = mesh.topology();
  Tally tally;
  tally.vertices = mesh.vertex_count();
  tally.edges = mesh.edge_count();
  tally.faces = mesh.face_count();
  tally.half_edges = flat.corner_vertices.size();
  tally.boundary = 2 * tally.edges - tally.half_edges;
  if (settings.corners == CornerRule::kSharp) {
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
      const bool has_one_face = flat.vertex_offsets[v + 1] - flat.vertex_offsets[v] == 1;
      tally.corners += has_one_face ? 1 : 0;
    }
  }
  return tally;
}

Tally after_triangle_split(const Tally& from) {
  return Tally{from.vertices + from.edges, 0,           4 * from.faces, 4 * from.half_edges,
               2 * from.boundary,          from.corners}
      .with_edges();
}

Tally after_quad_split(const Tally& from) {
  return Tally{from.vertices + from.edges + from.faces,
               0,
               from.half_edges,
               4 * from.half_edges,
               2 * from.boundary,
               from.corners}
      .with_edges();
}

Tally after_sqrt3(const Tally& from, bool cuts_boundary) {
  Tally to{
      from.vertices + from.faces, 0, 3 * from.faces, 9 * from.faces, from.boundary, from.corners};
  if (cuts_boundary) {
    to.vertices += from.boundary;
    to.boundary *= 3;
  }
  return to.with_edges();
}

/// `two_edged`: vertices inside that get no face, having two edges.
Tally after_vertex_split(const Tally& from, std::uint64_t two_edged) {
  return Tally{
      from.half_edges + 2 * from.boundary + from.corners,
      0,
      from.faces + from.edges + from.vertices - two_edged,
      2 * from.half_edges + 4 * from.edges + 2 * from.boundary + from.corners - 2 * two_edged,
      2 * from.boundary + from.corners,
      from.corners}
      .with_edges();
}

Tally after_midedge(const Tally& from, bool cuts_boundary, std::uint64_t two_edged) {
  const std::uint64_t staying = cuts_boundary ? from.corners : from.boundary;
  // In a second step every other boundary vertex has one face, and two edges that join its middles
  // to nothing new.
  const std::uint64_t cut_off = cuts_boundary ? from.boundary / 2 - from.corners : 0;
  Tally to{from.edges + staying,
           0,
           from.faces + from.vertices - two_edged - cut_off,
           2 * from.half_edges + from.boundary + staying - 2 * two_edged - 2 * cut_off,
           from.boundary + staying,
           from.corners};
  return to.with_edges();
}

}  // namespace

std::vector<SchemeCounts> predict_scheme(const ControlMesh& mesh, const SchemeSettings& settings,
                                         int levels) {
  LIMN_EXPECTS(levels >= 0 && levels <= kMostSchemeLevels);
  Tally tally = tally_of(mesh, settings);
  const TwoEdgedRows rows = two_edged_rows(mesh);
  std::vector<SchemeCounts> counts{{tally.vertices, tally.edges, tally.faces}};
  for (int level = 0; level < levels; ++level) {
    const bool is_second = level % 2 == 1;
    switch (settings.scheme) {
      case Scheme::kLoop:
      case Scheme::kButterfly:
        tally = after_triangle_split(tally);
        break;
      case Scheme::kLinear:
      case Scheme::kCatmullClark:
      case Scheme::kKobbelt:
        tally = after_quad_split(tally);
        break;
      case Scheme::kSqrt3:
        tally = after_sqrt3(tally, is_second);
        break;
      case Scheme::kDooSabin:
      case Scheme::kBiquartic:
        tally = after_vertex_split(tally, level == 0 ? rows.vertices(0) : 0);
        break;
      case Scheme::kMidedge:
        tally = after_midedge(tally, is_second, rows.vertices(static_cast<std::uint64_t>(level)));
        break;
    }
    counts.push_back({tally.vertices, tally.edges, tally.faces});
  }
  return counts;
}

}  // namespace limn
