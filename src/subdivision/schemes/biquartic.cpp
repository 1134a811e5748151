// Faces are split into quads at the middles of their edges, the points averaged (averaging.h), and
// averaged once more: the new vertices are the middles of the quads, one in each corner of a face.
// On a regular grid that is the tensor product of quartic B-splines (Zorin & Schroeder 2001).
#include "subdivision/parallel_ranges.h"
#include "subdivision/schemes/averaging.h"
#include "subdivision/schemes/marked_corners.h"
#include "subdivision/schemes/scheme_rules.h"
#include "subdivision/schemes/vertex_split.h"

namespace limn {
namespace {

constexpr std::size_t kBiquarticGrain = 8192;

void place_biquartic(const LevelMesh& from, const SchemeSettings& settings, const LevelMesh& to,
                     const PointSink& sink) {
  const std::size_t old = from.vertex_count();
  const std::size_t centres = old + from.edge_count;
  LargeArray<Point> averaged(centres + from.faces.count());
  // Marked corners are sharp to it, whatever it finds there.
  place_averaged_points(from, settings.corners, to, {averaged.data(), nullptr});
  parallel_ranges(0, from.faces.count(), kBiquarticGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const std::uint32_t last = from.faces.first(f + 1);
      std::uint32_t before = last - 1;
      for (std::uint32_t h = from.faces.first(f); h < last; before = h++) {
        sink.put(h, 0.25 * (averaged[from.start(h)] + averaged[old + from.edges[h]] +
                            averaged[centres + f] + averaged[old + from.edges[before]]));
      }
    }
  });
  const VertexSplit split(from);
  for (const std::uint32_t h : split.boundary().half_edges) {
    const Point& middle = averaged[old + from.edges[h]];
    sink.put(split.near_start(h), 0.5 * (averaged[from.start(h)] + middle));
    sink.put(split.near_end(h), 0.5 * (averaged[from.end(h)] + middle));
  }
  std::uint32_t corner = split.first_corner();
  for (const std::uint32_t v : split.corners()) {
    sink.put(corner++, from.points[v]);
  }
}

}  // namespace

const SchemeRules& biquartic_rules() noexcept {
  static constexpr SchemeRules kRules{split_vertices, connect_vertex_split, place_biquartic,
                                      vertex_split_vertices, false};
  return kRules;
}

}  // namespace limn
