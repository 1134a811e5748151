// Rows are first combined across (into one point per column), then along, in one pass: three
// combined columns are kept in registers while the window slides.
#include "subdivision/tensor_grid.h"

#include "subdivision/float_writer.h"

namespace limn {
namespace {

/// Combines rows of the grid into the points of a row one level down, before it is refined along.
/// Rows of odd number go through vertices, rows of even number between them.
struct VertexRow {
  const Point* below;
  const Point* here;
  const Point* above;
  [[nodiscard]] Point operator[](std::size_t column) const noexcept {
    return curve_vertex_point(below[column], here[column], above[column]);
  }
};

struct EdgeRow {
  const Point* below;
  const Point* above;
  [[nodiscard]] Point operator[](std::size_t column) const noexcept {
    return curve_edge_point(below[column], above[column]);
  }
};

/// Calls `body` with the combined row that gives row `row` of the level below.
template <class Body>
void with_row(const GridView& grid, std::size_t row, const Body& body) {
  const Point* first = grid.points + row / 2 * grid.stride;
  if (row % 2 == 0) {
    body(EdgeRow{first, first + grid.stride});
  } else {
    body(VertexRow{first, first + grid.stride, first + 2 * grid.stride});
  }
}

template <std::size_t kWidth>
void write_inner_row(const GridView& grid, std::size_t row, float* out) {
  with_row(grid, row, [&](const auto& columns) {
    FloatWriter<kWidth> writer(out);
    Point before = columns[1];
    Point here = columns[2];
    for (std::size_t x = 1; x < grid.n; ++x) {
      const Point after = columns[x + 2];
      writer.put(curve_edge_point(before, here));
      writer.put(curve_vertex_point(before, here, after));
      before = here;
      here = after;
    }
    writer.put_last(curve_edge_point(before, here));
  });
}

}  // namespace

void refine_grid(const GridView& grid, Point* out) {
  const std::size_t n = grid.n;
  for (std::size_t row = 0; row < 2 * n + 3; ++row) {
    with_row(grid, row, [&](const auto& columns) {
      Point before = columns[0];
      Point here = columns[1];
      for (std::size_t x = 0; x <= n; ++x) {
        const Point after = columns[x + 2];
        out[2 * x] = curve_edge_point(before, here);
        out[2 * x + 1] = curve_vertex_point(before, here, after);
        before = here;
        here = after;
      }
      out[2 * n + 2] = curve_edge_point(before, here);
    });
    out += 2 * n + 3;
  }
}

void refine_line(const GridLine& line, Point* out) {
  const auto column = [&line](std::size_t i) {
    const Point* here = line.points + i * line.along;
    return curve_vertex_point(here[-static_cast<std::ptrdiff_t>(line.across)], *here,
                              here[line.across]);
  };
  Point before = column(0);
  Point here = column(1);
  for (std::size_t x = 0; x <= line.n; ++x) {
    const Point after = column(x + 2);
    out[2 * x] = curve_vertex_point(before, here, after);
    if (x < line.n) {
      out[2 * x + 1] = curve_edge_point(here, after);
    }
    before = here;
    here = after;
  }
}

void refine_inner_row(const GridView& grid, std::size_t row, float* out, std::size_t width) {
  if (width == 3) {
    write_inner_row<3>(grid, row, out);
  } else {
    write_inner_row<2>(grid, row, out);
  }
}

void copy_inner_row(const GridView& grid, std::size_t row, float* out) {
  const Point* points = grid.points + (row + 1) * grid.stride + 1;
  FloatWriter<3> writer(out);
  for (std::size_t x = 1; x + 1 < grid.n; ++x) {
    writer.put(points[x]);
  }
  writer.put_last(points[grid.n - 1]);
}

void bilinear_inner_row(const GridView& grid, std::size_t row, float* out, std::size_t width) {
  const Point* below = grid.points + (row + 1) / 2 * grid.stride;
  const Point* above = grid.points + (row / 2 + 1) * grid.stride;
  for (std::size_t column = 2; column <= 2 * grid.n; ++column) {
    const std::size_t left = (column + 1) / 2;
    const std::size_t right = column / 2 + 1;
    const Point point = (below[left] + below[right] + above[left] + above[right]) * 0.25;
    for (std::size_t i = 0; i < width; ++i) {
      *out++ = static_cast<float>(point[i]);
    }
  }
}

void refine_curve(const GridLine& line, Point* out, std::size_t out_step) {
  Point before = line.points[0];
  Point here = line.points[line.along];
  for (std::size_t x = 0; x <= line.n; ++x) {
    const Point after = line.points[(x + 2) * line.along];
    out[2 * x * out_step] = curve_edge_point(before, here);
    out[(2 * x + 1) * out_step] = curve_vertex_point(before, here, after);
    before = here;
    here = after;
  }
  out[(2 * line.n + 2) * out_step] = curve_edge_point(before, here);
}

}  // namespace limn
