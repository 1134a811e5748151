// Around a regular quad the twelve vertices of its ring complete the grid. At an irregular corner
// the ring tables take over from level 1 on, and only the points that neighbouring faces share
// matter.
#include "subdivision/patch_gather.h"

#include "subdivision/sharpness.h"

namespace limn {
namespace {

constexpr std::size_t kSide = 4;  ///< Points along a side of the grid.

/// Where corner i and its ring points stand in the grid.
struct CornerPlaces {
  std::size_t corner;
  std::size_t before;    ///< Beyond side i.
  std::size_t after;     ///< Beyond side i - 1.
  std::size_t diagonal;  ///< Beyond both.
};
constexpr std::array<CornerPlaces, 4> kPlaces{
    {{5, 1, 4, 0}, {6, 7, 2, 3}, {10, 14, 11, 15}, {9, 8, 13, 12}}};

/// The side that the edge leaving a corner makes. Columns and rows grow along sides 0 and 1 and
/// against the others.
PatchSide side_of(const Cage& cage, const RingTables& rings, std::uint32_t corner,
                  std::size_t side) {
  if (cage.topology->corner_twins[corner] == kNone) {
    return {cage.averaging == Averaging::kPinned ? SideKind::kPinned : SideKind::kCurve, {}};
  }
  if (!is_sharp(cage.edge_sharpness(cage.topology->corner_edges[corner]))) {
    return {};
  }
  const SideSharpness sharpness = rings.sharpness(cage, corner);
  return {SideKind::kSharp, side < 2 ? sharpness : sharpness.reversed()};
}

/// The ring of a cage vertex as seen from one of its corners.
PatchCorner corner_of(const Cage& cage, const RingTables& rings, std::uint32_t corner) {
  PatchCorner result;
  result.ring = rings.of_vertex(cage, cage.topology->corner_vertices[corner]);
  if (result.ring.exists()) {
    const std::uint32_t rank = cage.topology->corner_ranks[corner];
    const auto edges = static_cast<std::uint32_t>(result.ring.edge_count());
    const bool is_boundary = fan_of(cage, cage.topology->corner_vertices[corner]).is_boundary;
    result.is_on_boundary = is_boundary;
    if (rank > 0 || !is_boundary) {
      result.before = rank > 0 ? rank - 1 : edges - 1;
    }
    if (rank + 2 < edges || !is_boundary) {
      result.after = (rank + 2) % edges;
    }
  }
  return result;
}

/// With these two beyond the side, the neighbour's centroid is what it is, although it is no quad.
Point beyond_polygon(const Cage& cage, const RingTables& rings, std::uint32_t corner,
                     std::uint32_t twin) {
  const FlatTopology& topology = *cage.topology;
  const Point ends = cage.point(topology.corner_vertices[corner]) +
                     cage.point(topology.corner_vertices[cage.next(corner)]);
  return (rings.centroid(cage, cage.face_of(twin)) * 4.0 - ends) * 0.5;
}

}  // namespace

void gather_quad(const Cage& cage, const RingTables& rings, std::uint32_t f, Patch& patch) {
  const FlatTopology& topology = *cage.topology;
  const std::uint32_t first = cage.first_corner(f);
  patch.is_bilinear = cage.averaging == Averaging::kBilinear;
  patch.make_plain();
  for (std::uint32_t i = 0; i < 4; ++i) {
    cage.load_point(topology.corner_vertices[first + i], patch.grid[kPlaces[i].corner]);
  }
  if (patch.is_bilinear) {
    return;
  }
  const std::array<std::uint32_t, 12>& ring = topology.quad_rings[f];
  bool is_regular = cage.creases->edge_sharpness.empty();
  for (std::size_t i = 0; i < 4; ++i) {
    const CornerPlaces& places = kPlaces[i];
    const auto put = [&](std::size_t at, std::uint32_t v) {
      if (v == kNone) {
        patch.grid[at] = patch.grid[places.corner];
      } else {
        cage.load_point(v, patch.grid[at]);
      }
    };
    put(places.before, ring[3 * i]);
    put(places.after, ring[3 * i + 1]);
    put(places.diagonal, ring[3 * i + 2]);
    is_regular = is_regular && ring[3 * i + 2] != kNone;
  }
  if (is_regular && cage.creases->vertex_sharpness.empty()) {
    return;  // Four corners of valence 4 amid quads: no boundary, nothing sharp.
  }
  patch.is_plain = false;
  for (std::uint32_t i = 0; i < 4; ++i) {
    patch.sides[i] = side_of(cage, rings, first + i, i);
    patch.corners[i] = corner_of(cage, rings, first + i);
  }
  for (std::uint32_t i = 0; i < 4 && !cage.is_all_quads; ++i) {
    const std::uint32_t twin = topology.corner_twins[first + i];
    if (twin != kNone && cage.side_count(cage.face_of(twin)) != 4) {
      patch.grid[kPlaces[i].before] = beyond_polygon(cage, rings, first + i, twin);
      patch.grid[kPlaces[(i + 1) % 4].after] = patch.grid[kPlaces[i].before];
    }
  }
}

void gather_polygon_corner(const Cage& cage, const RingTables& rings, std::uint32_t f,
                           std::uint32_t corner, Patch& patch) {
  const FlatTopology& topology = *cage.topology;
  const std::uint32_t after = cage.next(corner);
  const std::uint32_t before = cage.previous(corner);
  const auto vertex = [&](std::uint32_t c) { return topology.corner_vertices[c]; };
  patch.is_bilinear = cage.averaging == Averaging::kBilinear;
  patch.make_plain();
  std::array<Point, 4 * kSide>& grid = patch.grid;
  if (patch.is_bilinear) {
    const Point here = cage.point(vertex(corner));
    grid[5] = here;
    grid[6] = curve_edge_point(here, cage.point(vertex(after)));
    grid[10] = rings.centroid(cage, f);
    grid[9] = curve_edge_point(here, cage.point(vertex(before)));
    return;
  }
  // The point at level 1 on the side that leaves a corner, and the vertex there.
  const auto on_side = [&](std::uint32_t c) {
    return rings.of_vertex(cage, vertex(c)).edge(1, topology.corner_ranks[c]);
  };
  const auto moved = [&](std::uint32_t c) { return rings.of_vertex(cage, vertex(c)).centre(1); };
  const std::uint32_t side = corner - cage.first_corner(f);
  const std::uint32_t n = cage.side_count(f);
  const RingView centre = rings.of_face(cage, f);

  grid.fill(moved(corner));
  grid[6] = on_side(corner);
  grid[10] = centre.centre(1);
  grid[9] = on_side(before);
  grid[7] = moved(after);
  grid[11] = on_side(after);
  grid[13] = moved(before);
  grid[14] = on_side(cage.previous(before));
  patch.is_plain = false;
  patch.corners[0] = corner_of(cage, rings, corner);
  // From level 1 on the ring points beside the vertex are its own.
  if (patch.corners[0].before != kNone) {
    grid[1] = patch.corners[0].ring.edge(1, patch.corners[0].before);
  }
  if (patch.corners[0].after != kNone) {
    grid[4] = patch.corners[0].ring.edge(1, patch.corners[0].after);
  }
  if (const std::uint32_t twin = topology.corner_twins[corner]; twin != kNone) {
    grid[2] = rings.centroid(cage, cage.face_of(twin));
    const RingView ring = rings.of_vertex(cage, vertex(twin));
    grid[3] = ring.edge(1, (topology.corner_ranks[twin] + 1) % ring.edge_count());
  }
  if (const std::uint32_t twin = topology.corner_twins[before]; twin != kNone) {
    grid[8] = rings.centroid(cage, cage.face_of(twin));
    grid[12] = on_side(cage.next(twin));
  }
  // Around the centre this quad lies between the points on sides `side` - 1 and `side`.
  patch.corners[2] = {centre, (side + n - 2) % n, (side + 1) % n};
  // Half an edge each: the first half of the side that leaves, the second of the one that enters.
  patch.sides = {side_of(cage, rings, corner, 0), {}, {}, side_of(cage, rings, before, 3)};
  patch.sides[0].sharpness = patch.sides[0].sharpness.half(false);
  patch.sides[3].sharpness = patch.sides[3].sharpness.half(false);
}

}  // namespace limn
