// A tensor-product step first, as if everything were regular; then sides of their own rule; then
// corners of their own ring, which come last since a side's ends are theirs.
#include "subdivision/patch_levels.h"

#include <algorithm>

#include "subdivision/sharpness.h"

namespace limn {
namespace {

/// The longest line: the grids of a uniform node before its last step (patch.cpp), ring included.
constexpr std::size_t kLongestLine = 131;

/// How much of the rule of a crease the vertex at the start of an edge of the side takes.
float share_at_vertex(const SideSharpness& sharpness, int level, std::ptrdiff_t edge) {
  return sharp_share_of_vertex(sharpness.at(level, edge - 1), sharpness.at(level, edge),
                               sharpness.at(level + 1, 2 * edge - 1),
                               sharpness.at(level + 1, 2 * edge));
}

/// Mixes the points on a crease with those of a curve of its own. `first` is the edge of the side
/// that the line's first edge inside the ring is.
void sharpen_line(const SideSharpness& sharpness, int level, std::size_t first,
                  const GridLine& line, Point* out, std::size_t step) {
  std::array<Point, kLongestLine> curve;
  refine_curve(line, curve.data(), 1);
  const auto mix = [&](std::size_t at, float share) {
    out[at * step] = out[at * step] * (1.0 - static_cast<double>(share)) +
                     curve[at] * static_cast<double>(share);
  };
  // The line's edge 0 leads in from the ring.
  for (std::size_t x = 0; x <= line.n + 1; ++x) {
    const auto edge = static_cast<std::ptrdiff_t>(first + x) - 1;
    mix(2 * x, sharp_share_of_edge(sharpness.at(level, edge), sharpness.at(level + 1, 2 * edge),
                                   sharpness.at(level + 1, 2 * edge + 1)));
    if (x <= line.n) {
      mix(2 * x + 1, share_at_vertex(sharpness, level, edge + 1));
    }
  }
}

/// Replaces the points of a side by its own rule. `out` holds the smooth ones, ring included.
void override_side(const PatchSide& side, int level, std::size_t first, const GridLine& line,
                   Point* out, std::size_t step) {
  const std::size_t n = line.n;
  if (side.kind == SideKind::kCurve) {
    refine_curve(line, out, step);
  } else if (side.kind == SideKind::kPinned) {
    for (std::size_t x = 0; x <= n; ++x) {
      const Point& here = line.points[(x + 1) * line.along];
      out[(2 * x + 1) * step] = here;
      out[(2 * x + 2) * step] = curve_edge_point(here, line.points[(x + 2) * line.along]);
    }
    out[0] = curve_edge_point(line.points[0], line.points[line.along]);
  } else if (side.kind == SideKind::kSharp) {
    sharpen_line(side.sharpness, level, first, line, out, step);
  }
}

/// The midpoints and centroids of a grid, without a ring.
void step_down_bilinear(const GridView& grid, Point* out) {
  const std::size_t width = 2 * grid.n + 3;
  std::fill_n(out, width * width, Point{});
  const auto vertex = [&grid](std::size_t x, std::size_t y) -> const Point& {
    return grid.points[(y + 1) * grid.stride + x + 1];
  };
  for (std::size_t y = 0; y <= 2 * grid.n; ++y) {
    for (std::size_t x = 0; x <= 2 * grid.n; ++x) {
      const std::size_t right = (x + 1) / 2;
      const std::size_t above = (y + 1) / 2;
      out[(y + 1) * width + x + 1] = (vertex(x / 2, y / 2) + vertex(right, y / 2) +
                                      vertex(x / 2, above) + vertex(right, above)) *
                                     0.25;
    }
  }
}

}  // namespace

GridLine side_line(const GridView& grid, std::size_t i) noexcept {
  const std::size_t last = grid.n + 1;
  switch (i) {
    case 0:
      return {grid.points + grid.stride, 1, grid.stride, grid.n};
    case 1:
      return {grid.points + last, grid.stride, 1, grid.n};
    case 2:
      return {grid.points + last * grid.stride, 1, grid.stride, grid.n};
    default:
      return {grid.points + 1, grid.stride, 1, grid.n};
  }
}

PatchGrid face_at_corner(const PatchGrid& grid, std::size_t i) noexcept {
  const std::size_t x = i == 1 || i == 2 ? grid.grid.n - 1 : 0;
  const std::size_t y = i >= 2 ? grid.grid.n - 1 : 0;
  const auto sides = static_cast<std::uint8_t>(bit(i) | bit((i + 3) % 4));
  return {{grid.grid.points + y * grid.grid.stride + x, grid.grid.stride, 1},
          grid.level,
          grid.column + static_cast<std::uint32_t>(x),
          grid.row + static_cast<std::uint32_t>(y),
          static_cast<std::uint8_t>(grid.patch_corners & bit(i)),
          static_cast<std::uint8_t>(grid.patch_sides & sides)};
}

void step_down(const Patch& patch, const PatchGrid& from, Point* out) {
  if (patch.is_bilinear) {
    step_down_bilinear(from.grid, out);
    return;
  }
  refine_grid(from.grid, out);
  if ((from.patch_sides | from.patch_corners) == 0) {
    return;
  }
  const std::size_t width = 2 * from.grid.n + 3;
  const std::size_t last = width - 2;
  for (std::size_t i = 0; i < 4; ++i) {
    if (has(from.patch_sides, i) && patch.sides[i].kind != SideKind::kOpen) {
      const std::array<std::size_t, 4> starts{width, last, last * width, 1};
      override_side(patch.sides[i], from.level, i % 2 == 0 ? from.column : from.row,
                    side_line(from.grid, i), out + starts[i], i % 2 == 0 ? 1 : width);
    }
  }
  const std::array<std::size_t, 4> corners{width + 1, width + last, last * width + last,
                                           last * width + 1};
  // Steps out of the grid across side i.
  const std::array<std::ptrdiff_t, 4> outwards{-static_cast<std::ptrdiff_t>(width), 1,
                                               static_cast<std::ptrdiff_t>(width), -1};
  for (std::size_t i = 0; i < 4; ++i) {
    const PatchCorner& corner = patch.corners[i];
    if (has(from.patch_corners, i) && corner.ring.exists()) {
      Point* at = out + corners[i];
      *at = corner.ring.centre(from.level + 1);
      if (corner.before != kNone) {
        at[outwards[i]] = corner.ring.edge(from.level + 1, corner.before);
      }
      if (corner.after != kNone) {
        at[outwards[(i + 3) % 4]] = corner.ring.edge(from.level + 1, corner.after);
      }
    }
  }
}

void step_down_side(const Patch& patch, const PatchGrid& from, std::size_t side, Point* out) {
  const GridLine line = side_line(from.grid, side);
  const std::size_t n = from.grid.n;
  if (patch.is_bilinear) {
    for (std::size_t x = 0; x <= n; ++x) {
      const Point& here = line.points[(x + 1) * line.along];
      out[2 * x] = here;
      out[2 * x + 1] = curve_edge_point(here, line.points[(x + 2) * line.along]);
    }
    return;
  }
  refine_line(line, out);
  if (has(from.patch_sides, side)) {
    out[-1] = out[0];  // Beyond the ends: overridden and forgotten.
    out[2 * n + 1] = out[0];
    override_side(patch.sides[side], from.level, side % 2 == 0 ? from.column : from.row, line,
                  out - 1, 1);
  }
}

Point step_down_middle(const Patch& patch, const PatchGrid& from, std::size_t i) {
  if (patch.is_bilinear || (has(from.patch_sides, i) && patch.sides[i].kind != SideKind::kOpen)) {
    std::array<Point, 5> line;
    step_down_side(patch, from, i, line.data() + 1);
    return line[2];
  }
  const GridLine line = side_line(from.grid, i);
  const Point* here = line.points + line.along;
  const auto column = [across = static_cast<std::ptrdiff_t>(line.across)](const Point* p) {
    return curve_vertex_point(p[-across], *p, p[across]);
  };
  return curve_edge_point(column(here), column(here + line.along));
}

Point centroid(const GridView& grid) {
  const Point* row = grid.points + grid.stride;
  return curve_edge_point(curve_edge_point(row[1], row[grid.stride + 1]),
                          curve_edge_point(row[2], row[grid.stride + 2]));
}

Point step_down_corner(const Patch& patch, const PatchGrid& from, std::size_t i) {
  const PatchCorner& corner = patch.corners[i];
  if (!patch.is_bilinear && has(from.patch_corners, i) && corner.ring.exists()) {
    return corner.ring.centre(from.level + 1);
  }
  const GridView& grid = from.grid;
  const std::size_t x = i == 1 || i == 2 ? grid.n + 1 : 1;
  const std::size_t y = i >= 2 ? grid.n + 1 : 1;
  const Point* at = grid.points + y * grid.stride + x;
  if (patch.is_bilinear) {
    return *at;
  }
  const auto beside = [](const Point* p, std::size_t step) {
    return curve_vertex_point(p[-static_cast<std::ptrdiff_t>(step)], *p, p[step]);
  };
  Point point =
      curve_vertex_point(beside(at - grid.stride, 1), beside(at, 1), beside(at + grid.stride, 1));
  for (const std::size_t side : {i, (i + 3) % 4}) {
    if (has(from.patch_sides, side)) {
      const Point curve = beside(at, side % 2 == 0 ? 1 : grid.stride);
      const PatchSide& rule = patch.sides[side];
      if (rule.kind == SideKind::kCurve) {
        point = curve;
      } else if (rule.kind == SideKind::kPinned) {
        point = *at;
      } else if (rule.kind == SideKind::kSharp) {
        const auto along =
            static_cast<std::ptrdiff_t>(side % 2 == 0 ? from.column + x - 1 : from.row + y - 1);
        const double share = share_at_vertex(rule.sharpness, from.level, along);
        point = point * (1.0 - share) + curve * share;
      }
    }
  }
  return point;
}

}  // namespace limn
