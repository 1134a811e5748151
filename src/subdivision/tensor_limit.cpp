// The limit of a vertex of a uniform cubic B-spline is (1 4 1)/6 of itself and its neighbours, and
// its tangent has the direction of (-1 0 1). A surface takes the one along and the other across.
//
// The normals of a grid are computed four at a time in single precision, coordinate by coordinate,
// of points relative to the middle of the grid. That is exact enough wherever tangents are not tiny
// beside the grid or nearly parallel, and where they are, double precision steps in.
#include "subdivision/tensor_limit.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "limn/contract.h"
#include "subdivision/float_writer.h"

namespace limn {
namespace {

[[nodiscard]] Point weighted(const Point& before, const Point& here, const Point& after) noexcept {
  return before + here * 4.0 + after;
}

void put_floats(const glm::dvec3& v, float* out) noexcept {
  out[0] = static_cast<float>(v.x);
  out[1] = static_cast<float>(v.y);
  out[2] = static_cast<float>(v.z);
}

/// Vertex x of a row with those around it.
PointsAround points_around(const GridView& grid, std::size_t x, std::size_t row) {
  PointsAround points;
  const Point* from = grid.points + row * grid.stride + x;
  for (std::size_t y = 0; y < 3; ++y, from += grid.stride) {
    std::copy_n(from, 3, points.begin() + static_cast<std::ptrdiff_t>(3 * y));
  }
  return points;
}

void write_positions(const GridView& grid, std::size_t row, float* out) {
  const Point* here = grid.points + (row + 1) * grid.stride;
  const Point* below = here - grid.stride;
  const Point* above = here + grid.stride;
  const auto mean = [&](std::size_t x) { return weighted(below[x], here[x], above[x]); };
  Point before = mean(1);
  Point middle = mean(2);
  FloatWriter<3> writer(out);
  for (std::size_t x = 1; x + 1 < grid.n; ++x) {
    const Point after = mean(x + 2);
    writer.put(weighted(before, middle, after) * (1.0 / 36.0));
    before = middle;
    middle = after;
  }
  writer.put_last(weighted(before, middle, mean(grid.n + 1)) * (1.0 / 36.0));
}

void write_precisely(const GridView& grid, std::size_t row, float* normals) {
  for (std::size_t x = 1; x < grid.n; ++x, normals += 3) {
    put_floats(tensor_limit(points_around(grid, x, row)).normal, normals);
  }
}

/// The same coordinate of four vertices.
using Four [[gnu::vector_size(16)]] = float;
using FourInts [[gnu::vector_size(16)]] = std::int32_t;
constexpr std::size_t kFour = 4;

[[nodiscard]] inline Four load(const float* from) noexcept {
  Four four;
  std::memcpy(&four, from, sizeof four);
  return four;
}

inline void store(Four four, float* to) noexcept {
  std::memcpy(to, &four, sizeof four);
}

template <int... kAt>
[[nodiscard]] inline Four shuffled(Four a, Four b) noexcept {
  return __builtin_shufflevector(a, b, kAt...);
}

[[nodiscard]] inline bool all(FourInts truths) noexcept {
  const auto halves = std::bit_cast<std::array<std::int64_t, 2>>(truths);
  return (halves[0] & halves[1]) == -1;
}

/// Good to five millionths; the arguments are positive and normal.
[[nodiscard]] inline Four reciprocal_root(Four x) noexcept {
  const FourInts guess = 0x5F375A86 - (std::bit_cast<FourInts>(x) >> 1);
  Four root = std::bit_cast<Four>(guess);
  for (int i = 0; i < 2; ++i) {
    root = root * (1.5f - 0.5f * x * root * root);  // Newton's method.
  }
  return root;
}

/// Read and written by fours, so it has room for some more.
using FloatRow = std::array<float, kLongestRow + 3 * kFour>;

/// The coordinates of a row of vertices.
struct FloatPoints {
  std::array<FloatRow, 3> coordinates;
};

/// x, y and z of the first, then of the second, and so on.
inline void store_interleaved(Four x, Four y, Four z, float* to) noexcept {
  const Four first = shuffled<0, 4, 1, 5>(x, y);
  const Four second = shuffled<2, 6, 3, 7>(x, y);
  const Four rest = shuffled<2, 3, 6, 7>(z, second);
  store(shuffled<0, 1, 4, 6>(first, shuffled<0, 0, 5, 5>(z, x)), to);
  store(shuffled<0, 2, 4, 5>(shuffled<3, 3, 5, 5>(first, z), second), to + kFour);
  store(shuffled<0, 2, 3, 1>(rest, rest), to + 2 * kFour);
}

class GridNormals {
 public:
  explicit GridNormals(const GridView& grid);
  void write(float* out);

 private:
  void load_row(std::size_t row);
  void combine_rows(std::size_t row);
  bool write_row(float* out) const;

  const GridView* grid_;
  Point middle_{};
  Point scale_{};  ///< The grid becomes about 1 large.
  std::array<FloatPoints, 3> rows_;
  FloatPoints means_;  ///< Of three rows, (1 4 1) and (-1 0 1).
  FloatPoints differences_;
};

GridNormals::GridNormals(const GridView& grid) : grid_(&grid) {
  const std::size_t n = grid.n;
  const auto vertex = [&grid](std::size_t x, std::size_t y) {
    return grid.points[(y + 1) * grid.stride + x + 1];
  };
  middle_ = vertex(n / 2, n / 2);
  double extent = 0.0;
  for (const Point& corner : {vertex(0, 0), vertex(n, 0), vertex(0, n), vertex(n, n)}) {
    for (int axis = 0; axis < 3; ++axis) {
      extent = std::max(extent, std::abs(corner[axis] - middle_[axis]));
    }
  }
  // Where all corners coincide, or are next to doing so, double precision sees to everything.
  const double scale = extent > 1e-100 ? 1.0 / extent : 0.0;
  scale_ = Point{scale, scale, scale, scale};
}

/// Past the row's end stand points of the ring.
void GridNormals::load_row(std::size_t row) {
  const Point* from = grid_->points + (row + 1) * grid_->stride + 1;
  auto& [xs, ys, zs] = rows_[row % 3].coordinates;
  const auto local = [from, middle = middle_, scale = scale_](std::size_t i) {
    return __builtin_convertvector((from[i] - middle) * scale, Four);
  };
  for (std::size_t i = 0; i <= grid_->n; i += kFour) {
    const Four a = local(i);
    const Four b = local(i + 1);
    const Four c = local(i + 2);
    const Four d = local(i + 3);
    const Four first = shuffled<0, 4, 1, 5>(a, b);
    const Four second = shuffled<0, 4, 1, 5>(c, d);
    store(shuffled<0, 1, 4, 5>(first, second), xs.data() + i);
    store(shuffled<2, 3, 6, 7>(first, second), ys.data() + i);
    store(shuffled<0, 1, 4, 5>(shuffled<2, 6, 3, 7>(a, b), shuffled<2, 6, 3, 7>(c, d)),
          zs.data() + i);
  }
}

void GridNormals::combine_rows(std::size_t row) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float* below = rows_[(row + 2) % 3].coordinates[axis].data();
    const float* here = rows_[row % 3].coordinates[axis].data();
    const float* above = rows_[(row + 1) % 3].coordinates[axis].data();
    float* mean = means_.coordinates[axis].data();
    float* difference = differences_.coordinates[axis].data();
    for (std::size_t i = 0; i <= grid_->n; i += kFour) {
      const Four low = load(below + i);
      const Four high = load(above + i);
      store(low + 4.0f * load(here + i) + high, mean + i);
      store(high - low, difference + i);
    }
  }
}

/// Whether all normals of the row are exact enough.
bool GridNormals::write_row(float* out) const {
  // The least sine of the angle between tangents, times the lesser's length, at which rounding
  // turns a normal by no more than a hundredth of a degree.
  constexpr float kLeast = 5e-3f;
  const auto along = [this](std::size_t axis, std::size_t x) {
    const float* mean = means_.coordinates[axis].data() + x;
    return load(mean + 1) - load(mean - 1);
  };
  const auto across = [this](std::size_t axis, std::size_t x) {
    const float* difference = differences_.coordinates[axis].data() + x;
    return load(difference - 1) + 4.0f * load(difference) + load(difference + 1);
  };
  FourInts are_good = {-1, -1, -1, -1};
  const std::size_t n = grid_->n;
  for (std::size_t next = 1; next < n; next += kFour) {
    const std::size_t first = std::min(next, n - kFour);  // The last four overlap those before.
    const Four ax = along(0, first);
    const Four ay = along(1, first);
    const Four az = along(2, first);
    const Four bx = across(0, first);
    const Four by = across(1, first);
    const Four bz = across(2, first);
    const Four x = ay * bz - az * by;
    const Four y = az * bx - ax * bz;
    const Four z = ax * by - ay * bx;
    const Four square = x * x + y * y + z * z;
    are_good &= (square > kLeast * kLeast * (ax * ax + ay * ay + az * az)) &
                (square > kLeast * kLeast * (bx * bx + by * by + bz * bz));
    const Four root = reciprocal_root(square);
    store_interleaved(x * root, y * root, z * root, out + 3 * (first - 1));
  }
  return all(are_good);
}

void GridNormals::write(float* out) {
  load_row(0);
  load_row(1);
  for (std::size_t row = 1; row < grid_->n; ++row) {
    load_row(row + 1);
    combine_rows(row);
    if (!write_row(out)) {
      write_precisely(*grid_, row, out);
    }
    out += 3 * (grid_->n - 1);
  }
}

}  // namespace

LimitPoint tensor_limit(const PointsAround& points) {
  std::array<Point, 3> means;
  std::array<Point, 3> differences;
  for (std::size_t x = 0; x < 3; ++x) {
    means[x] = weighted(points[x], points[3 + x], points[6 + x]);
    differences[x] = points[6 + x] - points[x];
  }
  return {
      to_vec3(weighted(means[0], means[1], means[2]) * (1.0 / 36.0)),
      unit_normal(means[2] - means[0], weighted(differences[0], differences[1], differences[2]))};
}

void limit_inner_rows(const GridView& grid, const LimitArrays& out) {
  LIMN_ASSERT(grid.n >= 2 && grid.n < kLongestRow);
  const std::size_t width = 3 * (grid.n - 1);
  if (out.positions != nullptr) {
    for (std::size_t row = 1; row < grid.n; ++row) {
      write_positions(grid, row, out.positions + (row - 1) * width);
    }
  }
  if (out.normals == nullptr) {
    return;
  }
  constexpr std::size_t kSmallGrid = 4;
  if (grid.n > kSmallGrid) {
    GridNormals(grid).write(out.normals);
    return;
  }
  for (std::size_t row = 1; row < grid.n; ++row) {
    write_precisely(grid, row, out.normals + (row - 1) * width);
  }
}

}  // namespace limn
