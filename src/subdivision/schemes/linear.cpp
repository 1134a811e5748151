// Points go to the middles of edges and faces. With averaging, every vertex of the split mesh then
// becomes the mean of the centroids of the quads around it; on a boundary or a crease the mean of
// the middles of the two edges along it. For valence 4 that is Catmull-Clark.
#include "subdivision/parallel_ranges.h"
#include "subdivision/schemes/averaging.h"
#include "subdivision/schemes/quad_split.h"
#include "subdivision/schemes/scheme_rules.h"
#include "subdivision/schemes/sharp_stencils.h"

namespace limn {
namespace {

constexpr std::size_t kLinearGrain = 16384;

void place_split_points(const LevelMesh& from, const PointSink& sink) {
  const std::size_t old = from.vertex_count();
  const std::size_t centres = old + from.edge_count;
  parallel_ranges(0, old, kLinearGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      sink.put(v, from.points[v]);
    }
  });
  parallel_ranges(0, from.faces.count(), kLinearGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const std::uint32_t first = from.faces.first(f);
      const std::uint32_t last = from.faces.first(f + 1);
      Point sum{};
      for (std::uint32_t h = first; h < last; ++h) {
        const Point& start = from.points[from.start(h)];
        sum += start;
        if (from.is_first(h)) {
          const Point& end_point = from.points[from.start(h + 1 == last ? first : h + 1)];
          sink.put(old + from.edges[h], 0.5 * (start + end_point));
        }
      }
      sink.put(centres + f, sum / static_cast<double>(last - first));
    }
  });
}

void place_linear(const LevelMesh& from, const SchemeSettings& settings, const LevelMesh& to,
                  const PointSink& sink) {
  if (settings.averages) {
    place_averaged_points(from, settings.corners, to, sink);
  } else {
    place_split_points(from, sink);
  }
}

}  // namespace

const SchemeRules& linear_rules() noexcept {
  static constexpr SchemeRules kRules{split_into_quads, connect_quads, place_linear,
                                      quad_split_vertices, true};
  return kRules;
}

}  // namespace limn
