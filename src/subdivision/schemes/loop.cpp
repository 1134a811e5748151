// Inside, a vertex with n neighbours keeps 1 - n beta of itself and takes beta of each; the point
// on an edge is 3/8 of its ends and 1/8 of the vertices opposite. Boundaries and creases follow the
// cubic B-spline.
#include <array>
#include <cmath>
#include <numbers>

#include "subdivision/parallel_ranges.h"
#include "subdivision/schemes/scheme_rules.h"
#include "subdivision/schemes/sharp_stencils.h"
#include "subdivision/schemes/triangle_split.h"

namespace limn {
namespace {

constexpr std::size_t kLoopGrain = 16384;

double loop_beta(std::size_t n, LoopWeights weights) {
  const auto count = static_cast<double>(n);
  if (weights == LoopWeights::kWarren) {
    return n == 3 ? 3.0 / 16.0 : 3.0 / (8.0 * count);
  }
  const double cosine = 3.0 / 8.0 + std::cos(2.0 * std::numbers::pi / count) / 4.0;
  return (5.0 / 8.0 - cosine * cosine) / count;
}

/// Those of the usual valences, computed once.
class LoopBetas {
 public:
  explicit LoopBetas(LoopWeights weights) : weights_(weights) {
    for (std::size_t n = 1; n < usual_.size(); ++n) {
      usual_[n] = loop_beta(n, weights);
    }
  }
  [[nodiscard]] double operator[](std::size_t n) const {
    return n < usual_.size() ? usual_[n] : loop_beta(n, weights_);
  }

 private:
  LoopWeights weights_;
  std::array<double, 32> usual_{};
};

/// Vertex v inside, by the smooth rule.
Point loop_vertex(const LevelMesh& from, const LoopBetas& betas, std::uint32_t v) {
  const std::uint32_t first = from.vertex_starts[v];
  std::uint32_t h = first;
  std::size_t n = 0;
  Point sum{};
  do {
    const std::uint32_t arriving = previous_in_triangle(h);
    sum += from.points[from.start(arriving)];
    ++n;
    h = from.twins[arriving];
  } while (h != first);
  const double beta = betas[n];
  return (1.0 - static_cast<double>(n) * beta) * from.points[v] + beta * sum;
}

void place_loop_vertices(const LevelMesh& from, const SchemeSettings& settings, const LevelMesh& to,
                         const PointSink& sink) {
  const LoopBetas betas(settings.weights);
  parallel_ranges(0, from.vertex_count(), kLoopGrain, [&](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<std::uint32_t>(begin); v < end; ++v) {
      if (from.has_creases() || from.is_boundary_vertex(v)) {
        const SharpVertex vertex(from, to, settings.corners, v);
        sink.put(v, vertex.moved([&] { return loop_vertex(from, betas, v); }));
      } else {
        sink.put(v, loop_vertex(from, betas, v));
      }
    }
  });
}

void place_loop_edges(const LevelMesh& from, const LevelMesh& to, const PointSink& sink) {
  const std::size_t old = from.vertex_count();
  parallel_ranges(0, from.half_edge_count(), kLoopGrain, [&](std::size_t begin, std::size_t end) {
    for (auto h = static_cast<std::uint32_t>(begin); h < end; ++h) {
      if (!from.is_first(h)) {
        continue;
      }
      const auto point = [&from](std::uint32_t at) { return from.points[from.start(at)]; };
      const Point ends = point(h) + point(next_in_triangle(h));
      const double share = sharp_share(from, to, h);
      Point moved = 0.5 * ends;
      if (share != 1.0) {
        const Point opposite =
            point(previous_in_triangle(h)) + point(previous_in_triangle(from.twins[h]));
        moved = share * moved + (1.0 - share) * (0.375 * ends + 0.125 * opposite);
      }
      sink.put(old + from.edges[h], moved);
    }
  });
}

void place_loop(const LevelMesh& from, const SchemeSettings& settings, const LevelMesh& to,
                const PointSink& sink) {
  place_loop_vertices(from, settings, to, sink);
  place_loop_edges(from, to, sink);
}

}  // namespace

const SchemeRules& loop_rules() noexcept {
  static constexpr SchemeRules kRules{split_triangles, connect_split_triangles, place_loop,
                                      split_triangle_vertices, true};
  return kRules;
}

}  // namespace limn
