//            2
//           /  .
//          / 2  .                 Half-edges of triangle f are 3 f + i, from corner i to the next.
//        m2------m1               In corner triangle i: 0 leaves the corner, 1 runs inside along
//        the / . 3   / .              middle triangle, 2 comes back to the corner.
//       / 0  .  / 1 .             In the middle triangle k runs from m_k to m_(k+1).
//      0------m0------1
#include "subdivision/schemes/triangle_split.h"

#include <algorithm>

#include "subdivision/parallel_ranges.h"
#include "subdivision/schemes/sharp_stencils.h"

namespace limn {
namespace {

constexpr std::size_t kGrain = 16384;

/// The half-edges one level down on either half of h.
std::uint32_t leaving(std::uint32_t h) {
  return 3 * (4 * (h / 3) + h % 3);
}
std::uint32_t arriving(std::uint32_t h) {
  return 3 * (4 * (h / 3) + next_in_triangle(h) % 3) + 2;
}

}  // namespace

LevelFaces split_triangles(const LevelMesh& from) {
  const std::size_t count = from.faces.count();
  const auto old = static_cast<std::uint32_t>(from.vertex_count());
  LevelFaces to;
  to.sides = 3;
  to.corners.resize(12 * count);
  to.control_faces.resize(4 * count);
  parallel_ranges(0, count, kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const std::uint32_t* v = from.faces.corners.data() + 3 * f;
      const std::uint32_t* e = from.edges.data() + 3 * f;
      const std::uint32_t m[3] = {old + e[0], old + e[1], old + e[2]};
      const std::uint32_t children[12] = {v[0], m[0], m[2], v[1], m[1], m[0],
                                          v[2], m[2], m[1], m[0], m[1], m[2]};
      std::copy(children, children + 12, to.corners.data() + 12 * f);
      std::fill_n(to.control_faces.data() + 4 * f, 4, from.faces.control_faces[f]);
    }
  });
  return to;
}

std::size_t split_triangle_vertices(const LevelMesh& from) {
  return from.vertex_count() + from.edge_count;
}

void connect_split_triangles(const LevelMesh& from, LevelMesh& to) {
  const std::size_t half_edges = from.half_edge_count();
  const std::size_t old = from.vertex_count();
  to.edge_count = 2 * from.edge_count + half_edges;
  to.twins.resize(4 * half_edges);
  to.edges.resize(4 * half_edges);
  to.vertex_starts.resize(old + from.edge_count);
  parallel_ranges(0, half_edges / 3, kGrain, [&](std::size_t begin, std::size_t end) {
    for (auto h = static_cast<std::uint32_t>(3 * begin); h < 3 * end; ++h) {
      const std::uint32_t at = leaving(h);
      const std::uint32_t twin = from.twins[h];
      to.twins[at] = twin == kNone ? kNone : arriving(twin);
      to.edges[at] = half_at_start(from, h);
      const std::uint32_t back = arriving(h);
      to.twins[back] = twin == kNone ? kNone : leaving(twin);
      to.edges[back] = half_at_end(from, h);
      const std::uint32_t middle = 12 * (h / 3) + 9 + previous_in_triangle(h) % 3;
      to.twins[at + 1] = middle;
      to.twins[middle] = at + 1;
      to.edges[at + 1] = to.edges[middle] = static_cast<std::uint32_t>(2 * from.edge_count) + h;
      if (from.is_first(h)) {
        to.vertex_starts[old + from.edges[h]] = back;
      }
    }
  });
  parallel_ranges(0, old, kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      to.vertex_starts[v] = leaving(from.vertex_starts[v]);
    }
  });
}

}  // namespace limn
