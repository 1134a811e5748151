// The limit is the same from whichever level it is taken, so a vertex may be seen at any level that
// has it. Where a surface ends or is creased it is still a B-spline surface, the one whose points
// beyond the curve mirror those before it:
//
//     c    c    c           a row inside
//     b ---b--- b           the curve
//   2b-c 2b-c 2b-c          beyond
//
// since both the rule of the curve and the rules inside then follow from the tensor product's.
#include "subdivision/patch_limits.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "subdivision/sharpness.h"
#include "subdivision/tensor_kernels.h"
#include "subdivision/tensor_limit.h"
#include "subdivision/vertex_ring.h"

namespace limn {
namespace {

/// Indices into PointsAround, seen with a side below.
struct AroundSide {
  std::array<std::size_t, 3> beyond;
  std::array<std::size_t, 3> line;  ///< In the direction of growing columns or rows.
  std::array<std::size_t, 3> within;
};
constexpr std::array<AroundSide, 4> kAroundSides{{{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}},
                                                  {{2, 5, 8}, {1, 4, 7}, {0, 3, 6}},
                                                  {{6, 7, 8}, {3, 4, 5}, {0, 1, 2}},
                                                  {{0, 3, 6}, {1, 4, 7}, {2, 5, 8}}}};

void mirror(const AroundSide& at, PointsAround& points) {
  for (std::size_t i = 0; i < 3; ++i) {
    points[at.beyond[i]] = points[at.line[i]] * 2.0 - points[at.within[i]];
  }
}

/// The same vertex one level down, by the smooth rules.
PointsAround smooth_step(const PointsAround& points) {
  PointsAround rows;
  for (std::size_t x = 0; x < 3; ++x) {
    rows[x] = curve_edge_point(points[x], points[3 + x]);
    rows[3 + x] = curve_vertex_point(points[x], points[3 + x], points[6 + x]);
    rows[6 + x] = curve_edge_point(points[3 + x], points[6 + x]);
  }
  PointsAround next;
  for (std::size_t y = 0; y < 9; y += 3) {
    next[y] = curve_edge_point(rows[y], rows[y + 1]);
    next[y + 1] = curve_vertex_point(rows[y], rows[y + 1], rows[y + 2]);
    next[y + 2] = curve_edge_point(rows[y + 1], rows[y + 2]);
  }
  return next;
}

/// Steps down until the crease on a side has worn off or never will; the vertex stands at the start
/// of edge `edge` of the side. Whether it stays sharp.
bool wear_off(const SideSharpness& sharpness, int level, std::ptrdiff_t edge, const AroundSide& at,
              PointsAround& points) {
  while (true) {
    const float before = sharpness.at(level, edge - 1);
    const float after = sharpness.at(level, edge);
    if (!is_semi_sharp(before) && !is_semi_sharp(after)) {
      return is_sharp(before) && is_sharp(after);
    }
    const auto child = [&](std::ptrdiff_t i) { return sharpness.at(level + 1, i); };
    const std::array<double, 3> shares{
        sharp_share_of_edge(before, child(2 * edge - 2), child(2 * edge - 1)),
        sharp_share_of_vertex(before, after, child(2 * edge - 1), child(2 * edge)),
        sharp_share_of_edge(after, child(2 * edge), child(2 * edge + 1))};
    const std::array<Point, 3> line{points[at.line[0]], points[at.line[1]], points[at.line[2]]};
    const std::array<Point, 3> curve{curve_edge_point(line[0], line[1]),
                                     curve_vertex_point(line[0], line[1], line[2]),
                                     curve_edge_point(line[1], line[2])};
    points = smooth_step(points);
    for (std::size_t i = 0; i < 3; ++i) {
      Point& point = points[at.line[i]];
      point = point * (1.0 - shares[i]) + curve[i] * shares[i];
    }
    ++level;
    edge *= 2;
  }
}

/// Corner i of a patch or kNone, sides it lies on as bits.
struct OnEdges {
  std::size_t corner = kNone;
  std::uint8_t sides = 0;
};

OnEdges on_edges(const GridPlace& place, std::size_t n) {
  const bool is_left = place.x == 0;
  const bool is_right = place.x == n;
  const bool is_low = place.y == 0;
  const bool is_high = place.y == n;
  OnEdges on;
  on.sides = static_cast<std::uint8_t>(bit(0, is_low) | bit(1, is_right) | bit(2, is_high) |
                                       bit(3, is_left));
  if ((is_left || is_right) && (is_low || is_high)) {
    on.corner = is_low ? (is_left ? 0 : 1) : (is_left ? 3 : 2);
  }
  return on;
}

}  // namespace

LimitPoint limit_in_patch(const Patch& patch, const PatchGrid& at, const GridPlace& place) {
  const OnEdges on = on_edges(place, at.grid.n);
  if (on.corner != kNone && has(at.patch_corners, on.corner) &&
      patch.corners[on.corner].ring.exists()) {
    return patch.corners[on.corner].ring.limit();
  }
  PointsAround points;
  const Point* row = at.grid.points + place.y * at.grid.stride + place.x;
  for (std::size_t y = 0; y < 3; ++y, row += at.grid.stride) {
    std::copy_n(row, 3, points.begin() + static_cast<std::ptrdiff_t>(3 * y));
  }
  const auto sides = static_cast<std::uint8_t>(on.sides & at.patch_sides);
  for (std::size_t i = 0; i < 4 && sides != 0; ++i) {
    if (!has(sides, i)) {
      continue;
    }
    const PatchSide& side = patch.sides[i];
    const auto edge =
        static_cast<std::ptrdiff_t>(i % 2 == 0 ? at.column + place.x : at.row + place.y);
    if (side.kind == SideKind::kCurve ||
        (side.kind == SideKind::kSharp &&
         wear_off(side.sharpness, at.level, edge, kAroundSides[i], points))) {
      mirror(kAroundSides[i], points);
    }
  }
  return tensor_limit(points);
}

namespace {

/// The longest level whose limits are taken vertex by vertex, with the ring.
constexpr std::size_t kLongestLevel = 2 * (kLongestLimitRow - 3) + 3;

}  // namespace

SideLimits side_limits(const Patch& patch, const PatchGrid& grid, std::size_t i) {
  const PatchSide& side = patch.sides[i];
  if (!has(grid.patch_sides, i) || side.kind == SideKind::kOpen) {
    return SideLimits::kSmooth;
  }
  if (side.kind != SideKind::kSharp) {
    return SideLimits::kMirrored;
  }
  // A crease that ends beside the grid counts as well: Chaikin's rule lets parts of a side wear off
  // first.
  const std::ptrdiff_t first = i % 2 == 0 ? grid.column : grid.row;
  const auto n = static_cast<std::ptrdiff_t>(grid.grid.n);
  bool is_infinite_somewhere = false;
  for (std::ptrdiff_t edge = first - 1; edge <= first + n; ++edge) {
    const float sharpness = side.sharpness.at(grid.level, edge);
    if (is_semi_sharp(sharpness)) {
      return SideLimits::kWearing;
    }
    is_infinite_somewhere = is_infinite_somewhere || is_sharp(sharpness);
  }
  return is_infinite_somewhere ? SideLimits::kMirrored : SideLimits::kSmooth;
}

void mirror_ring(const GridView& grid, std::size_t i, Point* points) {
  const GridLine line = side_line(grid, i);
  const auto inwards = i == 0 || i == 3 ? static_cast<std::ptrdiff_t>(line.across)
                                        : -static_cast<std::ptrdiff_t>(line.across);
  Point* on = points + (line.points - grid.points);
  for (std::size_t x = 0; x < grid.n + 3; ++x, on += line.along) {
    *(on - inwards) = *on * 2.0 - on[inwards];
  }
}

namespace {

void put_corner_limits(const Patch& patch, const Node& node, const PatchGrid& grid,
                       const RefinedArrays& arrays) {
  const std::size_t n = grid.grid.n;
  const std::array<GridPlace, 4> corners{{{0, 0}, {n, 0}, {n, n}, {0, n}}};
  for (std::size_t i = 0; i < 4; ++i) {
    if (has(node.owned_corners, i)) {
      arrays.put_limit(node.corners[i], limit_in_patch(patch, grid, corners[i]));
    }
  }
}

/// Calls `put(number, at)` for the vertices 1..n - 1 of an owned side, `at` counting them from 0 in
/// the direction of growing columns or rows.
template <class Put>
void for_each_along(const Node& node, std::size_t side, std::size_t n, const Put& put) {
  for (std::size_t at = 0; at < n - 1; ++at) {
    const std::size_t along = side < 2 ? at : n - 2 - at;
    put(node.sides[side].at(static_cast<std::uint32_t>(along)), at);
  }
}

void put_side_limits(const Node& node, const GridView& grid, float* positions) {
  std::array<Point, kLongestLevel> line;
  for (std::size_t i = 0; i < 4; ++i) {
    if (has(node.owned_sides, i)) {
      limit_line(side_line(grid, i), line.data());
      for_each_along(node, i, 2 * grid.n, [&](std::uint32_t vertex, std::size_t at) {
        const glm::vec3 point = to_vec3(line[at]);
        std::memcpy(positions + std::size_t{3} * vertex, &point, sizeof point);
      });
    }
  }
}

void put_normals(const Node& node, const GridView& grid, float* normals) {
  std::array<std::array<float, 3 * kLongestLevel>, 4> sides;
  NormalArrays out{normals + std::size_t{3} * node.inside, {}};
  for (std::size_t i = 0; i < 4; ++i) {
    out.sides[i] = has(node.owned_sides, i) ? sides[i].data() : nullptr;
  }
  limit_normals(grid, out);
  for (std::size_t i = 0; i < 4; ++i) {
    if (has(node.owned_sides, i)) {
      for_each_along(node, i, 2 * grid.n, [&](std::uint32_t vertex, std::size_t at) {
        std::memcpy(normals + std::size_t{3} * vertex, sides[i].data() + 3 * at, 3 * sizeof(float));
      });
    }
  }
}

/// Out of the last level with its ring, all but the corners.
void put_limits_one_by_one(const Patch& patch, const Node& node, const PatchGrid& last,
                           const RefinedArrays& arrays) {
  const std::size_t n = last.grid.n;
  std::uint32_t number = node.inside;
  for (std::size_t y = 1; y < n; ++y) {
    for (std::size_t x = 1; x < n; ++x) {
      arrays.put_limit(number++, limit_in_patch(patch, last, {x, y}));
    }
  }
  for (std::size_t i = 0; i < 4; ++i) {
    if (has(node.owned_sides, i)) {
      for_each_along(node, i, n, [&](std::uint32_t vertex, std::size_t at) {
        const std::array<GridPlace, 4> places{{{at + 1, 0}, {n, at + 1}, {at + 1, n}, {0, at + 1}}};
        arrays.put_limit(vertex, limit_in_patch(patch, last, places[i]));
      });
    }
  }
}

/// Beside an irregular corner i the surface is no B-spline until the next level, where three
/// vertices lie on the face there.
void put_limits_beside_corner(const Patch& patch, const Node& node, const PatchGrid& before_last,
                              std::size_t i, const RefinedArrays& arrays) {
  const PatchGrid face = face_at_corner(before_last, i);
  std::array<Point, 25> points;
  step_down(patch, face, points.data());
  const PatchGrid next = one_level_down(face, points.data());
  const std::size_t before = (i + 3) % 4;
  const auto last = static_cast<std::uint32_t>(2 * before_last.grid.n - 2);
  const std::uint32_t column = i == 1 || i == 2 ? last : 0;
  const std::uint32_t row = i >= 2 ? last : 0;
  arrays.put_limit(node.inside + row * (last + 1) + column, limit_in_patch(patch, next, {1, 1}));
  if (has(node.owned_sides, i)) {
    arrays.put_limit(node.sides[i].at(0), limit_in_patch(patch, next, kMiddlesOfFour[i]));
  }
  if (has(node.owned_sides, before)) {
    arrays.put_limit(node.sides[before].at(last),
                     limit_in_patch(patch, next, kMiddlesOfFour[before]));
  }
}

}  // namespace

void put_uniform_limits(const Patch& patch, const Node& node, const PatchGrid& before_last,
                        Point* points, const RefinedArrays& arrays) {
  const GridView& grid = before_last.grid;
  put_corner_limits(patch, node, before_last, arrays);
  std::array<SideLimits, 4> sides;
  for (std::size_t i = 0; i < 4; ++i) {
    sides[i] = side_limits(patch, before_last, i);
  }
  if (std::ranges::find(sides, SideLimits::kWearing) != sides.end()) {
    std::array<Point, kLongestLevel * kLongestLevel> last;
    step_down(patch, before_last, last.data());
    put_limits_one_by_one(patch, node, one_level_down(before_last, last.data()), arrays);
    return;
  }
  for (std::size_t i = 0; i < 4; ++i) {
    if (sides[i] == SideLimits::kMirrored) {
      mirror_ring(grid, i, points);
    }
  }
  const std::size_t first = std::size_t{3} * node.inside;
  if (arrays.has_limit_points) {
    limit_inner_rows(grid, arrays.points + first);
  }
  if (arrays.has_limit_points) {
    put_side_limits(node, grid, arrays.points);
  }
  if (arrays.normals != nullptr) {
    put_normals(node, grid, arrays.normals);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    if (has(before_last.patch_corners, i) && patch.corners[i].ring.exists()) {
      put_limits_beside_corner(patch, node, before_last, i, arrays);
    }
  }
}

void put_last_limits(const Patch& patch, const Node& node, const PatchGrid& grid,
                     const RefinedArrays& arrays) {
  std::array<Point, 25> points;
  step_down(patch, grid, points.data());
  put_limits_one_by_one(patch, node, one_level_down(grid, points.data()), arrays);
  put_corner_limits(patch, node, grid, arrays);
}

LimitPoint limit_in_cage(const Cage& cage, const RingTables& rings, std::uint32_t v) {
  if (const RingView ring = rings.of_vertex(cage, v); ring.exists()) {
    return ring.limit();
  }
  const Fan fan = fan_of(cage, v);
  if (is_irregular(cage, v, fan)) {
    thread_local VertexRing ring;
    rings.seed(cage, v, ring);
    ring.step_until_worn(cage.creases->method, cage.corners);
    return ring.limit(cage.creases->method, cage.corners);
  }
  // Edge i leads to the first of these, and between edges i and i + 1 lies the second.
  constexpr std::array<std::array<std::size_t, 2>, 4> kPlaces{{{5, 8}, {7, 6}, {3, 0}, {1, 2}}};
  const std::vector<std::uint32_t>& vertices = cage.topology->corner_vertices;
  PointsAround points;
  points[4] = cage.point(v);
  for (std::size_t i = 0; i < fan.corners.size(); ++i) {
    const std::uint32_t beside = cage.next(fan.corners[i]);
    points[kPlaces[i][0]] = cage.point(vertices[beside]);
    points[kPlaces[i][1]] = cage.point(vertices[cage.next(beside)]);
  }
  if (fan.is_boundary) {
    points[3] = cage.point(vertices[cage.previous(fan.corners.back())]);
    mirror(kAroundSides[0], points);
  }
  return tensor_limit(points);
}

}  // namespace limn
