// The bodies of the kernels, for inclusion by one source file per kind of processor.
//
// Nothing here may call an inline function or a template of another header: the linker keeps one
// copy of these, and it could be the one that not every processor runs. And points are read and
// written as StoredPoint, by value.
//
// Rows are first combined across (into one point per column), then along, in one pass: the combined
// columns are kept in registers while the window slides.
#include "subdivision/bicubic_kernels.inl"
#include "subdivision/normal_kernels.inl"
#include "subdivision/tensor_kernels.h"

namespace limn {
namespace {

/// Between two points, and at a point between two others.
inline Point refined_between(Point a, Point b) {
  return (a + b) * 0.5;
}
inline Point refined_at(Point a, Point v, Point b) {
  return (a + b) * 0.125 + v * 0.75;
}
/// The limits there, times 48 and times 6: the values of the cubic B-spline.
inline Point limit_between(Point before, Point a, Point b, Point after) {
  return (a + b) * 23.0 + (before + after);
}
inline Point limit_at(Point a, Point v, Point b) {
  return v * 4.0 + (a + b);
}

/// Writes points one after the other; lanes that are not wanted are overwritten by the next.
template <std::size_t kWidth>
class Floats {
 public:
  explicit Floats(float* out) : out_(out) {}
  void put(Point point) {
    const auto rounded = __builtin_convertvector(point, Rounded);
    __builtin_memcpy(out_, &rounded, (kWidth == 3 ? 4 : kWidth) * sizeof(float));
    out_ += kWidth;
  }
  void put_last(Point point) {
    const auto rounded = __builtin_convertvector(point, Rounded);
    __builtin_memcpy(out_, &rounded, kWidth * sizeof(float));
    out_ += kWidth;
  }
  [[nodiscard]] float* end() const { return out_; }

 private:
  using Rounded [[gnu::vector_size(16)]] = float;
  float* out_;
};

/// Rows of the grid combined into the points of a row one level down, before that is refined along.
/// Rows of odd number go through vertices, rows of even number between them.
struct VertexRow {
  const StoredPoint* below;
  const StoredPoint* here;
  const StoredPoint* above;
  Point operator[](std::size_t column) const {
    return refined_at(below[column], here[column], above[column]);
  }
};

struct EdgeRow {
  const StoredPoint* below;
  const StoredPoint* above;
  Point operator[](std::size_t column) const {
    return refined_between(below[column], above[column]);
  }
};

/// The same with limits.
struct VertexLimitRow {
  const StoredPoint* below;
  const StoredPoint* here;
  const StoredPoint* above;
  double scale;
  Point operator[](std::size_t column) const {
    return limit_at(below[column], here[column], above[column]) * scale;
  }
};

struct EdgeLimitRow {
  const StoredPoint* first;
  std::size_t stride;
  double scale;
  Point operator[](std::size_t column) const {
    const StoredPoint* at = first + column;
    return limit_between(at[0], at[stride], at[2 * stride], at[3 * stride]) * scale;
  }
};

template <class Row>
void write_refined_row(const Row& columns, std::size_t n, StoredPoint* out) {
  Point before = columns[0];
  Point here = columns[1];
  for (std::size_t x = 0; x <= n; ++x) {
    const Point after = columns[x + 2];
    out[2 * x] = refined_between(before, here);
    out[2 * x + 1] = refined_at(before, here, after);
    before = here;
    here = after;
  }
  out[2 * n + 2] = refined_between(before, here);
}

void refine_grid_here(const GridView& grid, StoredPoint* out) {
  const std::size_t n = grid.n;
  const std::size_t width = 2 * n + 3;
  const StoredPoint* first = grid.points;
  for (std::size_t row = 0; row <= n; ++row, first += grid.stride) {
    const StoredPoint* above = first + grid.stride;
    write_refined_row(EdgeRow{first, above}, n, out);
    write_refined_row(VertexRow{first, above, above + grid.stride}, n, out + width);
    out += 2 * width;
  }
  write_refined_row(EdgeRow{first, first + grid.stride}, n, out);
}

void refine_line_here(const GridLine& line, StoredPoint* out) {
  const StoredPoint* here = line.points;
  const auto column = [&line](const StoredPoint* at) {
    return refined_at(*(at - line.across), *at, at[line.across]);
  };
  Point before = column(here);
  here += line.along;
  Point middle = column(here);
  for (std::size_t x = 0; x < line.n; ++x) {
    here += line.along;
    const Point after = column(here);
    out[2 * x] = refined_at(before, middle, after);
    out[2 * x + 1] = refined_between(middle, after);
    before = middle;
    middle = after;
  }
  out[2 * line.n] = refined_at(before, middle, column(here + line.along));
}

/// Columns 2..2 n of a row one level down. Returns where the next row goes.
template <std::size_t kWidth, class Row>
float* write_inner_row(const Row& columns, std::size_t n, float* out) {
  Floats<kWidth> floats(out);
  Point before = columns[1];
  Point here = columns[2];
  for (std::size_t x = 1; x < n; ++x) {
    const Point after = columns[x + 2];
    floats.put(refined_between(before, here));
    floats.put(refined_at(before, here, after));
    before = here;
    here = after;
  }
  floats.put_last(refined_between(before, here));
  return floats.end();
}

template <std::size_t kWidth>
void write_inner_rows(const GridView& grid, float* out) {
  const std::size_t n = grid.n;
  const StoredPoint* below = grid.points + grid.stride;
  for (std::size_t row = 1; row < n; ++row) {
    const StoredPoint* here = below + grid.stride;
    out = write_inner_row<kWidth>(EdgeRow{below, here}, n, out);
    out = write_inner_row<kWidth>(VertexRow{below, here, here + grid.stride}, n, out);
    below = here;
  }
  write_inner_row<kWidth>(EdgeRow{below, below + grid.stride}, n, out);
}

void refine_inner_rows_here(const GridView& grid, float* out, std::size_t width) {
  if (width == 3) {
    write_inner_rows<3>(grid, out);
  } else {
    write_inner_rows<2>(grid, out);
  }
}

/// `columns` hold a 48th of what they combine: what is undone along.
template <class Row>
float* write_limit_row(const Row& columns, std::size_t n, float* out) {
  Floats<3> floats(out);
  Point before = columns[0];
  Point here = columns[1];
  Point after = columns[2];
  for (std::size_t x = 1; x < n; ++x) {
    const Point last = columns[x + 2];
    floats.put(limit_between(before, here, after, last));
    floats.put(limit_at(here, after, last) * 8.0);
    before = here;
    here = after;
    after = last;
  }
  floats.put_last(limit_between(before, here, after, columns[n + 2]));
  return floats.end();
}

void limit_inner_rows_here(const GridView& grid, float* out) {
  constexpr double kAlong = 1.0 / 48.0;  // What limit_between leaves undone.
  const std::size_t n = grid.n;
  const std::size_t stride = grid.stride;
  const StoredPoint* first = grid.points;
  for (std::size_t row = 1; row < n; ++row, first += stride) {
    const StoredPoint* below = first + stride;
    out = write_limit_row(EdgeLimitRow{first, stride, kAlong / 48.0}, n, out);
    out = write_limit_row(VertexLimitRow{below, below + stride, below + 2 * stride, kAlong / 6.0},
                          n, out);
  }
  write_limit_row(EdgeLimitRow{first, stride, kAlong / 48.0}, n, out);
}

/// Vertices 1..2 n - 1 one level down.
void limit_line_here(const GridLine& line, StoredPoint* out) {
  constexpr double kAlong = 1.0 / 48.0;
  const auto column = [&line](std::size_t i) {
    const StoredPoint* at = line.points + i * line.along;
    return limit_at(*(at - line.across), *at, at[line.across]) * (kAlong / 6.0);
  };
  Point before = column(0);
  Point here = column(1);
  Point after = column(2);
  for (std::size_t x = 1; x < line.n; ++x) {
    const Point last = column(x + 2);
    *out++ = limit_between(before, here, after, last);
    *out++ = limit_at(here, after, last) * 8.0;
    before = here;
    here = after;
    after = last;
  }
  *out = limit_between(before, here, after, column(line.n + 2));
}

constexpr TensorKernels kKernelsHere{
    refine_grid_here,      refine_line_here,   refine_inner_rows_here,
    limit_inner_rows_here, limit_line_here,    load_rows_here,
    combine_rows_here,     write_normals_here, bicubic_errors_here};

}  // namespace
}  // namespace limn
