// The bodies of the kernels, for inclusion by one source file per kind of processor.
//
// Nothing here may call an inline function or a template of another header: the linker keeps one
// copy of these, and it could be the one that not every processor runs. And points are read and
// written as StoredPoint, by value.
//
// Rows are first combined across (into one point per column), then along, in one pass: the combined
// columns are kept in registers while the window slides.
#ifdef __SSE__
#include <immintrin.h>
#endif

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

/// The same coordinate of some vertices.
template <std::size_t kCount>
struct LanesOf;
template <>
struct LanesOf<4> {
  using Floats [[gnu::vector_size(16)]] = float;
  using Ints [[gnu::vector_size(16)]] = int;
};
template <>
struct LanesOf<8> {
  using Floats [[gnu::vector_size(32)]] = float;
  using Ints [[gnu::vector_size(32)]] = int;
};
using Four = LanesOf<4>::Floats;
using Eight = LanesOf<8>::Floats;

template <class Lanes>
inline Lanes load(const float* from) {
  Lanes lanes;
  __builtin_memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

template <class Lanes>
inline void store(const Lanes& lanes, float* to) {
  __builtin_memcpy(to, &lanes, sizeof lanes);
}

/// Picks from two vectors four by four, as the instructions do: 0..3 are the first's.
template <int k0, int k1, int k2, int k3>
inline Four shuffled(const Four& a, const Four& b) {
  return __builtin_shufflevector(a, b, k0, k1, k2, k3);
}
template <int k0, int k1, int k2, int k3>
inline Eight shuffled(const Eight& a, const Eight& b) {
  constexpr auto at = [](int k, int half) { return k % 4 + (k < 4 ? 0 : 8) + 4 * half; };
  return __builtin_shufflevector(a, b, at(k0, 0), at(k1, 0), at(k2, 0), at(k3, 0), at(k0, 1),
                                 at(k1, 1), at(k2, 1), at(k3, 1));
}

inline void store_fours(const Four& four, float* to) {
  store(four, to);
}
/// The second half goes behind what six fours take.
inline void store_fours(const Eight& eight, float* to) {
  store(__builtin_shufflevector(eight, eight, 0, 1, 2, 3), to);
  store(__builtin_shufflevector(eight, eight, 4, 5, 6, 7), to + 24);
}

/// x, y and z of the first, then of the second, and so on.
template <class Lanes>
inline void store_interleaved(const Lanes& x, const Lanes& y, const Lanes& z, float* to) {
  const Lanes first = shuffled<0, 4, 1, 5>(x, y);
  const Lanes second = shuffled<2, 6, 3, 7>(x, y);
  const Lanes rest = shuffled<2, 3, 6, 7>(z, second);
  store_fours(shuffled<0, 1, 4, 6>(first, shuffled<0, 0, 5, 5>(z, x)), to);
  store_fours(shuffled<0, 2, 4, 5>(shuffled<3, 3, 5, 5>(first, z), second), to + 4);
  store_fours(shuffled<0, 2, 3, 1>(rest, rest), to + 8);
}

/// Three coordinates of vectors.
template <class Lanes>
struct Vectors {
  Lanes x;
  Lanes y;
  Lanes z;
};

template <class Lanes>
inline Lanes square_of(const Vectors<Lanes>& v) {
  return v.x * v.x + v.y * v.y + v.z * v.z;
}

/// The first of each, then the second of each, and so on. Returns where the next go.
template <class Lanes>
inline float* store_alternating(const Vectors<Lanes>& a, const Vectors<Lanes>& b, float* to) {
  store_interleaved(shuffled<0, 4, 1, 5>(a.x, b.x), shuffled<0, 4, 1, 5>(a.y, b.y),
                    shuffled<0, 4, 1, 5>(a.z, b.z), to);
  store_interleaved(shuffled<2, 6, 3, 7>(a.x, b.x), shuffled<2, 6, 3, 7>(a.y, b.y),
                    shuffled<2, 6, 3, 7>(a.z, b.z), to + 12);
  return to + 6 * sizeof(Lanes) / sizeof(float);
}

void load_rows_here(const GridView& grid, const StoredPoint& middle, const StoredPoint& scale,
                    CoordinateRow* rows) {
  const std::size_t last = grid.n + 2;
  const std::size_t end = last + (grid.n < 4 ? 8 : 11);
  const StoredPoint* from = grid.points;
  for (std::size_t row = 0; row <= last; ++row, from += grid.stride) {
    auto& [xs, ys, zs] = rows[row];
    const auto local = [&](std::size_t i) {
      // Past the row's end stands its last point.
      return __builtin_convertvector((from[i < last ? i : last] - middle) * scale, Four);
    };
    for (std::size_t i = 0; i < end; i += 4) {
      const Four a = local(i);
      const Four b = local(i + 1);
      const Four c = local(i + 2);
      const Four d = local(i + 3);
      const Four first = shuffled<0, 4, 1, 5>(a, b);
      const Four second = shuffled<0, 4, 1, 5>(c, d);
      store(shuffled<0, 1, 4, 5>(first, second), xs + i);
      store(shuffled<2, 3, 6, 7>(first, second), ys + i);
      store(shuffled<0, 1, 4, 5>(shuffled<2, 6, 3, 7>(a, b), shuffled<2, 6, 3, 7>(c, d)), zs + i);
    }
  }
}

template <class Lanes>
void combine(const CoordinateRow* rows, std::size_t n, bool is_between, CombinedRow& out) {
  constexpr std::size_t kCount = sizeof(Lanes) / sizeof(float);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float* before = rows[-1][axis];
    const float* here = rows[0][axis];
    const float* above = rows[1][axis];
    float* means = out.means[axis];
    float* differences = out.differences[axis];
    if (is_between) {
      const float* after = rows[2][axis];
      for (std::size_t i = 0; i < n + 6; i += kCount) {
        const Lanes a = load<Lanes>(before + i);
        const Lanes b = load<Lanes>(here + i);
        const Lanes c = load<Lanes>(above + i);
        const Lanes d = load<Lanes>(after + i);
        store(0.125f * (a + d) + 2.875f * (b + c), means + i);
        store(0.25f * (d - a) + 1.25f * (c - b), differences + i);
      }
    } else {
      for (std::size_t i = 0; i < n + 6; i += kCount) {
        const Lanes a = load<Lanes>(before + i);
        const Lanes c = load<Lanes>(above + i);
        store(a + 4.0f * load<Lanes>(here + i) + c, means + i);
        store(c - a, differences + i);
      }
    }
  }
}

void combine_rows_here(const CoordinateRow* rows, std::size_t n, bool is_between,
                       CombinedRow& out) {
  if (n < 4) {
    combine<Four>(rows, n, is_between, out);
  } else {
    combine<Eight>(rows, n, is_between, out);
  }
}

/// 1 / sqrt(x).
inline Four reciprocal_root(const Four& x) {
#ifdef __SSE__
  return 1.0f / __builtin_bit_cast(Four, _mm_sqrt_ps(__builtin_bit_cast(__m128, x)));
#else
  return Four{1.0f / __builtin_sqrtf(x[0]), 1.0f / __builtin_sqrtf(x[1]),
              1.0f / __builtin_sqrtf(x[2]), 1.0f / __builtin_sqrtf(x[3])};
#endif
}

inline Eight reciprocal_root(const Eight& x) {
#ifdef __AVX__
  return 1.0f / __builtin_bit_cast(Eight, _mm256_sqrt_ps(__builtin_bit_cast(__m256, x)));
#else
  const Four low = reciprocal_root(__builtin_shufflevector(x, x, 0, 1, 2, 3));
  const Four high = reciprocal_root(__builtin_shufflevector(x, x, 4, 5, 6, 7));
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
#endif
}

/// Normals, and for each whether rounding turns it by no more than a hundredth of a degree.
template <std::size_t kCount>
struct Normals {
  Vectors<typename LanesOf<kCount>::Floats> normals;
  typename LanesOf<kCount>::Ints are_good;
};

template <std::size_t kCount>
inline Normals<kCount> normals_of(const Vectors<typename LanesOf<kCount>::Floats>& a,
                                  const Vectors<typename LanesOf<kCount>::Floats>& b) {
  using Lanes = typename LanesOf<kCount>::Floats;
  // The least sine of the angle between tangents, times the lesser's length in a grid about 1
  // large.
  constexpr float kLeast = 5e-3f;
  const Vectors<Lanes> normal{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  const Lanes square = square_of(normal);
  const auto are_good =
      (square > kLeast * kLeast * square_of(a)) & (square > kLeast * kLeast * square_of(b));
  const Lanes root = reciprocal_root(square);
  return {{normal.x * root, normal.y * root, normal.z * root}, are_good};
}

template <std::size_t kCount>
inline bool are_all(const typename LanesOf<kCount>::Ints& truths) {
  int all = -1;
  for (std::size_t i = 0; i < kCount; ++i) {
    all &= truths[i];
  }
  return all != 0;
}

template <std::size_t kCount>
bool write_normals(const CombinedRow& row, std::size_t n, float* out) {
  using Lanes = typename LanesOf<kCount>::Floats;
  using Ints = typename LanesOf<kCount>::Ints;
  Ints are_good = Ints{} - 1;
  // Vertices j, and the points between these and the next.
  Ints numbers;
  for (std::size_t i = 0; i < kCount; ++i) {
    numbers[i] = static_cast<int>(i) + 1;
  }
  const int last = static_cast<int>(n) + 1;
  for (std::size_t j = 1; j <= n + 1; j += kCount, numbers += static_cast<int>(kCount)) {
    Vectors<Lanes> along_at;
    Vectors<Lanes> across_at;
    Vectors<Lanes> along_between;
    Vectors<Lanes> across_between;
    const auto combine_columns = [&](std::size_t axis, Lanes& along_vertex, Lanes& across_vertex,
                                     Lanes& along_edge, Lanes& across_edge) {
      const float* mean = row.means[axis] + j;
      const float* difference = row.differences[axis] + j;
      const Lanes before = load<Lanes>(mean - 1);
      const Lanes after = load<Lanes>(mean + 1);
      along_vertex = after - before;
      along_edge = 0.25f * (load<Lanes>(mean + 2) - before) + 1.25f * (after - load<Lanes>(mean));
      const Lanes here = load<Lanes>(difference);
      const Lanes around = load<Lanes>(difference - 1);
      const Lanes beyond = load<Lanes>(difference + 1);
      across_vertex = around + 4.0f * here + beyond;
      across_edge = 0.125f * (around + load<Lanes>(difference + 2)) + 2.875f * (here + beyond);
    };
    combine_columns(0, along_at.x, across_at.x, along_between.x, across_between.x);
    combine_columns(1, along_at.y, across_at.y, along_between.y, across_between.y);
    combine_columns(2, along_at.z, across_at.z, along_between.z, across_between.z);
    const Normals<kCount> at = normals_of<kCount>(along_at, across_at);
    const Normals<kCount> between = normals_of<kCount>(along_between, across_between);
    are_good &= (at.are_good | (numbers > last)) & (between.are_good | (numbers >= last));
    out = store_alternating(at.normals, between.normals, out);
  }
  return are_all<kCount>(are_good);
}

bool write_normals_here(const CombinedRow& row, std::size_t n, float* out) {
  return n < 4 ? write_normals<4>(row, n, out) : write_normals<8>(row, n, out);
}

constexpr TensorKernels kKernelsHere{
    refine_grid_here, refine_line_here, refine_inner_rows_here, limit_inner_rows_here,
    limit_line_here,  load_rows_here,   combine_rows_here,      write_normals_here};

}  // namespace
}  // namespace limn
