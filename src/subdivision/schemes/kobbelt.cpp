// Old vertices stay. The point on an edge is the four-point rule along the row of edges it lies in;
// where the row ends at a vertex with other than four edges, a point takes the place of the missing
// one such that the middle of a face comes out the same from both pairs of its sides. The middle is
// the four-point rule again, across a row of edge points.
#include "subdivision/parallel_ranges.h"
#include "subdivision/schemes/cut_fans.h"
#include "subdivision/schemes/quad_split.h"
#include "subdivision/schemes/scheme_rules.h"

namespace limn {
namespace {

constexpr std::size_t kKobbeltGrain = 8192;

constexpr std::uint32_t next_in_quad(std::uint32_t h) {
  return (h & ~3U) | ((h + 1) & 3U);
}
constexpr std::uint32_t previous_in_quad(std::uint32_t h) {
  return (h & ~3U) | ((h + 3) & 3U);
}
constexpr std::uint32_t opposite_in_quad(std::uint32_t h) {
  return h ^ 2U;
}

class Kobbelt {
 public:
  Kobbelt(const LevelMesh& mesh, CornerRule corners) : mesh_(&mesh), corners_(corners) {}

  [[nodiscard]] Point edge_point(std::uint32_t h) const {
    if (is_held(*mesh_, h)) {
      return four_point_on_curve(*mesh_, corners_, h);
    }
    const std::uint32_t twin = mesh_->twins[h];
    return four_point(before(h), at(h), at(twin), before(twin));
  }

  /// `edge_points`: by edge. Both pairs of sides are asked, since with several irregular corners
  /// they disagree.
  [[nodiscard]] Point face_point(const Point* edge_points, std::uint32_t f) const {
    return 0.5 * (across_face(edge_points, 4 * f) + across_face(edge_points, 4 * f + 1));
  }

 private:
  [[nodiscard]] const Point& at(std::uint32_t h) const noexcept {
    return mesh_->points[mesh_->start(h)];
  }

  /// What comes before the start of h in the row of its edge, h being free.
  [[nodiscard]] Point before(std::uint32_t h) const {
    const FreeFan fan = free_fan(*mesh_, mesh_->start(h));
    if (!fan.is_whole) {
      return 2.0 * at(h) - at(next_in_quad(h));
    }
    const auto turned = [this](std::uint32_t leaving) {
      return mesh_->twins[previous_in_quad(leaving)];
    };
    if (fan.edges == 4) {
      return at(next_in_quad(turned(turned(h))));
    }
    // Edges lead to l_j, and h_j lies between l_j and l_(j+1), l_0 being h's end. That the middle
    // of a face is the same from both pairs of its sides says how these points differ from one edge
    // to the next; their mean is that of the l_j (Kobbelt 1996).
    const std::uint32_t n = fan.edges;
    Point ends{};
    Point corners{};
    Point near_ends{};
    Point near_corners{};
    std::uint32_t leaving = h;
    for (std::uint32_t j = 0; j < n; ++j, leaving = turned(leaving)) {
      const Point& end = at(next_in_quad(leaving));
      const Point& corner = at(opposite_in_quad(leaving));
      ends += end;
      corners += corner;
      // With three edges some are counted twice.
      near_ends += static_cast<double>((j == 0) + (j == 1) + (j == n - 1)) * end;
      near_corners +=
          static_cast<double>((j == 0) + (j == 1 % n) + (j == n - 1) + (j == (2 * n - 2) % n)) *
          corner;
    }
    const double count = n;
    constexpr double kShare = 1.0 / 9.0;  // The outer weight of the four-point rule to the inner.
    return (4.0 / count) * ends - near_ends + kShare * (near_corners - (4.0 / count) * corners);
  }

  /// The four-point rule over the edges of h, the one opposite it, and the next ones on both sides.
  [[nodiscard]] Point across_face(const Point* edge_points, std::uint32_t h) const {
    const std::uint32_t other = opposite_in_quad(h);
    const Point& a = edge_points[mesh_->edges[h]];
    const Point& b = edge_points[mesh_->edges[other]];
    const auto beyond = [&](std::uint32_t side, const Point& on, const Point& within) {
      const std::uint32_t twin = across(*mesh_, side);
      return twin == kNone ? 2.0 * on - within : edge_points[mesh_->edges[opposite_in_quad(twin)]];
    };
    return four_point(beyond(h, a, b), a, b, beyond(other, b, a));
  }

  const LevelMesh* mesh_;
  CornerRule corners_;
};

void place_kobbelt(const LevelMesh& from, const SchemeSettings& settings, const LevelMesh&,
                   const PointSink& sink) {
  const std::size_t old = from.vertex_count();
  for (std::size_t v = 0; v < old; ++v) {
    sink.put(v, from.points[v]);
  }
  const Kobbelt kobbelt(from, settings.corners);
  LargeArray<Point> edge_points(from.edge_count);
  parallel_ranges(0, from.half_edge_count(), kKobbeltGrain,
                  [&](std::size_t begin, std::size_t end) {
                    for (auto h = static_cast<std::uint32_t>(begin); h < end; ++h) {
                      if (from.is_first(h)) {
                        const std::uint32_t e = from.edges[h];
                        edge_points[e] = kobbelt.edge_point(h);
                        sink.put(old + e, edge_points[e]);
                      }
                    }
                  });
  const std::size_t centres = old + from.edge_count;
  parallel_ranges(0, from.faces.count(), kKobbeltGrain, [&](std::size_t begin, std::size_t end) {
    for (auto f = static_cast<std::uint32_t>(begin); f < end; ++f) {
      sink.put(centres + f, kobbelt.face_point(edge_points.data(), f));
    }
  });
}

}  // namespace

const SchemeRules& kobbelt_rules() noexcept {
  static constexpr SchemeRules kRules{split_into_quads, connect_quads, place_kobbelt,
                                      quad_split_vertices, true};
  return kRules;
}

}  // namespace limn
