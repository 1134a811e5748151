// The new vertex in corner i of an n-gon is 1/4 of the old one plus, of corner j,
// (3 + 2 cos(2 pi (i - j) / n)) / (4 n) (Doo & Sabin 1978): that is 1/4 of the vertex, 3/4 of the
// centroid, and the first harmonic of the face. On the boundary (3 1) / 4.
#include <cmath>
#include <numbers>

#include "subdivision/parallel_ranges.h"
#include "subdivision/schemes/marked_corners.h"
#include "subdivision/schemes/scheme_rules.h"
#include "subdivision/schemes/vertex_split.h"

namespace limn {
namespace {

constexpr std::size_t kDooSabinGrain = 8192;

void place_face(const LevelMesh& from, std::size_t f, const PointSink& sink) {
  const std::uint32_t first = from.faces.first(f);
  const std::uint32_t last = from.faces.first(f + 1);
  const auto n = static_cast<double>(last - first);
  const auto turn = [&](std::uint32_t h) { return 2.0 * std::numbers::pi * (h - first) / n; };
  const auto point = [&](std::uint32_t h) -> const Point& { return from.points[from.start(h)]; };
  Point sum{};
  Point cosines{};
  Point sines{};
  if (last - first == 4) {
    const Point middle =
        (point(first) + point(first + 1) + point(first + 2) + point(first + 3)) / 4.0;
    for (std::uint32_t i = 0; i < 4; ++i) {
      // The harmonic of a quad is half the difference of opposite corners.
      const Point across = point(first + i) - point(first + (i + 2) % 4);
      sink.put(first + i, 0.25 * point(first + i) + 0.75 * middle + 0.125 * across);
    }
    return;
  }
  for (std::uint32_t h = first; h < last; ++h) {
    sum += point(h);
    cosines += std::cos(turn(h)) * point(h);
    sines += std::sin(turn(h)) * point(h);
  }
  for (std::uint32_t h = first; h < last; ++h) {
    const Point harmonic = std::cos(turn(h)) * cosines + std::sin(turn(h)) * sines;
    sink.put(h, 0.25 * point(h) + (0.75 / n) * sum + (0.5 / n) * harmonic);
  }
}

void place_doo_sabin(const LevelMesh& from, const SchemeSettings&, const LevelMesh&,
                     const PointSink& sink) {
  parallel_ranges(0, from.faces.count(), kDooSabinGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      place_face(from, f, sink);
    }
  });
  const VertexSplit split(from);
  for (const std::uint32_t h : split.boundary().half_edges) {
    const Point& a = from.points[from.start(h)];
    const Point& b = from.points[from.end(h)];
    sink.put(split.near_start(h), 0.75 * a + 0.25 * b);
    sink.put(split.near_end(h), 0.25 * a + 0.75 * b);
  }
  std::uint32_t corner = split.first_corner();
  for (const std::uint32_t v : split.corners()) {
    sink.put(corner++, from.points[v]);
  }
}

}  // namespace

const SchemeRules& doo_sabin_rules() noexcept {
  static constexpr SchemeRules kRules{split_vertices, connect_vertex_split, place_doo_sabin,
                                      vertex_split_vertices, false};
  return kRules;
}

}  // namespace limn
