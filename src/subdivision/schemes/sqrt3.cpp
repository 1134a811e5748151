// Every triangle gets a vertex in its middle, and every old edge is turned to join the middles on
// its two sides: one new triangle for each half-edge h from a, with the middles beyond and within.
//
//     first of two steps              second: a triangle at the boundary has no middle, its edge is
//                                     cut in three instead
//          . c .                                c
//       .   / .   .                            /|\.
//     .    /   .    .                         / | \ .
//    a ---/-----.--- b  boundary        a - p1 - p2 - b
//
// Old vertices move towards the mean of their neighbours. On the boundary they rest in the first
// step, and in the second follow the cubic B-spline with three new spans for each old one.
#include <cmath>
#include <numbers>

#include "subdivision/parallel_ranges.h"
#include "subdivision/schemes/boundary_edges.h"
#include "subdivision/schemes/marked_corners.h"
#include "subdivision/schemes/scheme_rules.h"
#include "subdivision/schemes/triangle_split.h"

namespace limn {
namespace {

constexpr std::size_t kSqrt3Grain = 16384;

bool cuts_boundary(const LevelMesh& from) {
  return from.level % 2 == 1;
}

/// Vertices: the old ones, then one per face: its middle, or the first of the two on its boundary
/// edge; then the second ones.
class Sqrt3Numbers {
 public:
  explicit Sqrt3Numbers(const LevelMesh& from)
      : from_(&from),
        old_(static_cast<std::uint32_t>(from.vertex_count())),
        cut_(old_ + static_cast<std::uint32_t>(from.faces.count())) {
    if (cuts_boundary(from)) {
      boundary_ = boundary_edges(from);
    }
  }

  [[nodiscard]] const BoundaryEdges& cut_edges() const noexcept { return boundary_; }
  [[nodiscard]] std::uint32_t first_cut(std::uint32_t h) const noexcept { return old_ + h / 3; }
  [[nodiscard]] std::uint32_t second_cut(std::uint32_t h) const noexcept {
    return cut_ + boundary_.ranks[from_->edges[h]];
  }
  [[nodiscard]] bool is_cut(std::uint32_t h) const noexcept {
    return !boundary_.ranks.empty() && from_->twins[h] == kNone;
  }
  /// The vertex that the triangle on h's side of its edge ends in.
  [[nodiscard]] std::uint32_t apex(std::uint32_t h) const noexcept {
    const std::uint32_t before = previous_in_triangle(h);
    return is_cut(before) ? second_cut(before) : first_cut(h);
  }
  [[nodiscard]] std::uint32_t count() const noexcept {
    return cut_ + static_cast<std::uint32_t>(boundary_.half_edges.size());
  }

 private:
  const LevelMesh* from_;
  std::uint32_t old_;
  std::uint32_t cut_;
  BoundaryEdges boundary_;
};

LevelFaces split_sqrt3(const LevelMesh& from) {
  const Sqrt3Numbers numbers(from);
  const std::size_t count = from.half_edge_count();
  LevelFaces to;
  to.sides = 3;
  to.corners.resize(3 * count);
  to.control_faces.resize(count);
  parallel_ranges(0, count, kSqrt3Grain, [&](std::size_t begin, std::size_t end) {
    for (auto h = static_cast<std::uint32_t>(begin); h < end; ++h) {
      std::uint32_t* const corners = to.corners.data() + std::size_t{3} * h;
      const std::uint32_t twin = from.twins[h];
      if (numbers.is_cut(h)) {
        corners[0] = numbers.first_cut(h);
        corners[1] = numbers.second_cut(h);
        corners[2] = from.start(previous_in_triangle(h));
      } else {
        corners[0] = from.start(h);
        corners[1] = twin == kNone ? from.start(next_in_triangle(h)) : numbers.apex(twin);
        corners[2] = numbers.apex(h);
      }
      to.control_faces[h] = from.faces.control_faces[h / 3];
    }
  });
  return to;
}

std::size_t sqrt3_vertices(const LevelMesh& from) {
  return Sqrt3Numbers(from).count();
}

void connect_sqrt3(const LevelMesh& from, LevelMesh& to) {
  const std::size_t vertices = sqrt3_vertices(from);
  connect(vertices, to);
  if (!from.vertex_sharpness.empty()) {
    to.vertex_sharpness = from.vertex_sharpness;
    to.vertex_sharpness.resize(vertices, 0.0f);
  }
}

/// Inside: with n neighbours, alpha = (4 - 2 cos(2 pi / n)) / 9 of their mean.
Point sqrt3_vertex(const LevelMesh& from, std::uint32_t v) {
  Point sum{};
  double n = 0.0;
  (void)from.around(v, [&](std::uint32_t h) {
    sum += from.points[from.end(h)];
    n += 1.0;
  });
  const double alpha = (4.0 - 2.0 * std::cos(2.0 * std::numbers::pi / n)) / 9.0;
  return (1.0 - alpha) * from.points[v] + (alpha / n) * sum;
}

void place_cut_edge(const LevelMesh& from, const Sqrt3Numbers& numbers, std::uint32_t h,
                    const PointSink& sink) {
  const std::uint32_t a = from.start(h);
  const std::uint32_t b = from.end(h);
  const Point& at_a = from.points[a];
  const Point& at_b = from.points[b];
  const Point before = from.points[from.start(boundary_before(from, h))];
  const Point after = from.points[from.end(from.vertex_starts[b])];
  const bool ends_at_a = is_marked(from, a);
  const bool ends_at_b = is_marked(from, b);
  sink.put(numbers.first_cut(h),
           ((ends_at_a ? 2.0 * at_a - at_b : before) + 16.0 * at_a + 10.0 * at_b) / 27.0);
  sink.put(numbers.second_cut(h),
           (10.0 * at_a + 16.0 * at_b + (ends_at_b ? 2.0 * at_b - at_a : after)) / 27.0);
  sink.put(a, ends_at_a ? at_a : (4.0 * (before + at_b) + 19.0 * at_a) / 27.0);
}

void place_sqrt3(const LevelMesh& from, const SchemeSettings&, const LevelMesh&,
                 const PointSink& sink) {
  const Sqrt3Numbers numbers(from);
  parallel_ranges(0, from.vertex_count(), kSqrt3Grain, [&](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<std::uint32_t>(begin); v < end; ++v) {
      sink.put(v, from.is_boundary_vertex(v) ? from.points[v] : sqrt3_vertex(from, v));
    }
  });
  parallel_ranges(0, from.faces.count(), kSqrt3Grain, [&](std::size_t begin, std::size_t end) {
    for (auto f = static_cast<std::uint32_t>(begin); f < end; ++f) {
      const Point* const points = from.points.data();
      const std::uint32_t h = 3 * f;
      sink.put(
          numbers.first_cut(h),
          (points[from.start(h)] + points[from.start(h + 1)] + points[from.start(h + 2)]) / 3.0);
    }
  });
  for (const std::uint32_t h : numbers.cut_edges().half_edges) {
    place_cut_edge(from, numbers, h, sink);
  }
}

}  // namespace

const SchemeRules& sqrt3_rules() noexcept {
  static constexpr SchemeRules kRules{split_sqrt3, connect_sqrt3, place_sqrt3, sqrt3_vertices,
                                      false};
  return kRules;
}

}  // namespace limn
