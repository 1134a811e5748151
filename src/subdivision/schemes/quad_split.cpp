//        e(h-1)
//     3 .     .  2       Half-edges of quad h are 4 h + i: 0 runs from the corner along h, 1 from
//     m ------- c        the middle of h into the face, 2 from there to the middle of the half-edge
//     |    2    |        before, and 3 back to the corner.
//     | 3     1 |
//     |    0    |
//     v ------- m(h) ----
#include "subdivision/schemes/quad_split.h"

#include <algorithm>

#include "subdivision/parallel_ranges.h"
#include "subdivision/schemes/sharp_stencils.h"

namespace limn {
namespace {

constexpr std::size_t kQuadGrain = 16384;

}  // namespace

LevelFaces split_into_quads(const LevelMesh& from) {
  const std::size_t half_edges = from.half_edge_count();
  const auto old = static_cast<std::uint32_t>(from.vertex_count());
  const auto centres = static_cast<std::uint32_t>(old + from.edge_count);
  LevelFaces to;
  to.sides = 4;
  to.corners.resize(4 * half_edges);
  to.control_faces.resize(half_edges);
  parallel_ranges(0, from.faces.count(), kQuadGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const std::uint32_t last = from.faces.first(f + 1);
      std::uint32_t before = last - 1;
      for (std::uint32_t h = from.faces.first(f); h < last; before = h++) {
        std::uint32_t* const quad = to.corners.data() + std::size_t{4} * h;
        quad[0] = from.start(h);
        quad[1] = old + from.edges[h];
        quad[2] = centres + static_cast<std::uint32_t>(f);
        quad[3] = old + from.edges[before];
        to.control_faces[h] = from.faces.control_faces[f];
      }
    }
  });
  return to;
}

std::size_t quad_split_vertices(const LevelMesh& from) {
  return from.vertex_count() + from.edge_count + from.faces.count();
}

void connect_quads(const LevelMesh& from, LevelMesh& to) {
  const std::size_t half_edges = from.half_edge_count();
  const std::size_t old = from.vertex_count();
  const auto inner = static_cast<std::uint32_t>(2 * from.edge_count);
  to.edge_count = 2 * from.edge_count + half_edges;
  to.twins.resize(4 * half_edges);
  to.edges.resize(4 * half_edges);
  to.vertex_starts.resize(quad_split_vertices(from));
  parallel_ranges(0, from.faces.count(), kQuadGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const std::uint32_t first = from.faces.first(f);
      const std::uint32_t last = from.faces.first(f + 1);
      std::uint32_t before = last - 1;
      for (std::uint32_t h = first; h < last; before = h++) {
        const std::uint32_t after = h + 1 == last ? first : h + 1;
        const std::uint32_t at = 4 * h;
        const std::uint32_t twin = from.twins[h];
        // The half at the end of h belongs to the quad after, coming back to its corner.
        to.twins[at] = twin == kNone ? kNone : 4 * from.next(twin) + 3;
        to.edges[at] = half_at_start(from, h);
        to.twins[at + 1] = 4 * after + 2;
        to.edges[at + 1] = inner + h;
        to.twins[at + 2] = 4 * before + 1;
        to.edges[at + 2] = inner + before;
        const std::uint32_t twin_before = from.twins[before];
        to.twins[at + 3] = twin_before == kNone ? kNone : 4 * twin_before;
        to.edges[at + 3] = half_at_end(from, before);
        if (from.is_first(h)) {
          to.vertex_starts[old + from.edges[h]] = 4 * after + 3;
        }
      }
      to.vertex_starts[old + from.edge_count + f] = 4 * first + 2;
    }
  });
  parallel_ranges(0, old, kQuadGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      to.vertex_starts[v] = 4 * from.vertex_starts[v];
    }
  });
}

}  // namespace limn
