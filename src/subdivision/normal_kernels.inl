// The kernels of limit normals, in single precision: some vertices at a time, coordinate by
// coordinate.
#include "subdivision/kernel_lanes.inl"

namespace limn {
namespace {

inline void store_fours(const Four& four, float* to) {
  store(four, to);
}
/// The second half goes behind what six fours take.
inline void store_fours(const Eight& eight, float* to) {
  store(low_half(eight), to);
  store(high_half(eight), to + 24);
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
      Four x;
      Four y;
      Four z;
      transpose(a, b, c, d, x, y, z);
      store(x, xs + i);
      store(y, ys + i);
      store(z, zs + i);
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
  const Lanes by = 1.0f / root(square);
  return {{normal.x * by, normal.y * by, normal.z * by}, are_good};
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

}  // namespace
}  // namespace limn
