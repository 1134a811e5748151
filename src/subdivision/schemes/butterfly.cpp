//        w --- c --- w        Old vertices stay. The point on an edge whose ends are regular (six
//         .   / .   /         edges, or on a boundary) is 1/2 of the ends, 1/8 of the vertices
//          . /   . /          opposite and -1/16 of the wings w. At an end with another number of
//           a --- b           edges it is 3/4 of that vertex and weights around it; at two such
//           ends
//          / .   / .          the mean of both.
//         /   . /   .
//        w --- d --- w
#include <array>
#include <cmath>
#include <numbers>

#include "subdivision/parallel_ranges.h"
#include "subdivision/schemes/cut_fans.h"
#include "subdivision/schemes/scheme_rules.h"
#include "subdivision/schemes/triangle_split.h"

namespace limn {
namespace {

constexpr std::size_t kButterflyGrain = 8192;

/// Weight of neighbour j of K around an irregular vertex; neighbour 0 is the edge's other end.
double butterfly_weight(std::uint32_t j, std::uint32_t valence) {
  if (valence == 3) {
    return j == 0 ? 5.0 / 12.0 : -1.0 / 12.0;
  }
  if (valence == 4) {
    constexpr std::array<double, 4> kWeights{3.0 / 8.0, 0.0, -1.0 / 8.0, 0.0};
    return kWeights[j];
  }
  const double turn = 2.0 * std::numbers::pi * j / valence;
  return (0.25 + std::cos(turn) + 0.5 * std::cos(2.0 * turn)) / valence;
}

class Butterfly {
 public:
  Butterfly(const LevelMesh& mesh, CornerRule corners) : mesh_(&mesh), corners_(corners) {}

  [[nodiscard]] Point edge_point(std::uint32_t h) const {
    if (is_held(*mesh_, h)) {
      return four_point_on_curve(*mesh_, corners_, h);
    }
    const std::uint32_t twin = mesh_->twins[h];
    const FreeFan at_start = free_fan(*mesh_, mesh_->start(h));
    const FreeFan at_end = free_fan(*mesh_, mesh_->start(twin));
    const bool is_start_regular = is_regular(at_start);
    const bool is_end_regular = is_regular(at_end);
    if (is_start_regular && is_end_regular) {
      return regular_point(h, twin);
    }
    if (is_start_regular) {
      return point_beside(twin, at_end.edges);
    }
    const Point beside_start = point_beside(h, at_start.edges);
    return is_end_regular ? beside_start : 0.5 * (beside_start + point_beside(twin, at_end.edges));
  }

 private:
  [[nodiscard]] static bool is_regular(const FreeFan& fan) noexcept {
    return !fan.is_whole || fan.edges == 6;
  }
  [[nodiscard]] const Point& at(std::uint32_t h) const noexcept {
    return mesh_->points[mesh_->start(h)];
  }
  /// Opposite h in the triangle on its other side, or the mirror image of what is on this side.
  [[nodiscard]] Point wing(std::uint32_t h) const {
    const std::uint32_t other = across(*mesh_, h);
    return other == kNone ? at(h) + at(next_in_triangle(h)) - at(previous_in_triangle(h))
                          : at(previous_in_triangle(other));
  }
  [[nodiscard]] Point regular_point(std::uint32_t h, std::uint32_t twin) const {
    const Point wings = wing(next_in_triangle(h)) + wing(previous_in_triangle(h)) +
                        wing(next_in_triangle(twin)) + wing(previous_in_triangle(twin));
    return 0.5 * (at(h) + at(twin)) +
           0.125 * (at(previous_in_triangle(h)) + at(previous_in_triangle(twin))) - wings / 16.0;
  }
  /// By the weights around the irregular vertex at the start of h.
  [[nodiscard]] Point point_beside(std::uint32_t h, std::uint32_t valence) const {
    Point point = 0.75 * at(h);
    std::uint32_t leaving = h;
    for (std::uint32_t j = 0; j < valence; ++j) {
      point += butterfly_weight(j, valence) * at(next_in_triangle(leaving));
      leaving = mesh_->twins[previous_in_triangle(leaving)];
    }
    return point;
  }

  const LevelMesh* mesh_;
  CornerRule corners_;
};

void place_butterfly(const LevelMesh& from, const SchemeSettings& settings, const LevelMesh&,
                     const PointSink& sink) {
  const std::size_t old = from.vertex_count();
  for (std::size_t v = 0; v < old; ++v) {
    sink.put(v, from.points[v]);
  }
  const Butterfly butterfly(from, settings.corners);
  parallel_ranges(0, from.half_edge_count(), kButterflyGrain,
                  [&](std::size_t begin, std::size_t end) {
                    for (auto h = static_cast<std::uint32_t>(begin); h < end; ++h) {
                      if (from.is_first(h)) {
                        sink.put(old + from.edges[h], butterfly.edge_point(h));
                      }
                    }
                  });
}

}  // namespace

const SchemeRules& butterfly_rules() noexcept {
  static constexpr SchemeRules kRules{split_triangles, connect_split_triangles, place_butterfly,
                                      split_triangle_vertices, true};
  return kRules;
}

}  // namespace limn
