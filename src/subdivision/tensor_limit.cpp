// The limit of a vertex of a uniform cubic B-spline is (1 4 1)/6 of itself and its neighbours, and
// its tangent (-1 0 1)/2 of these; between two vertices it is (1 23 23 1)/48 and (-1 -5 5 1)/8. A
// surface takes the one along and the other across. So the limits of a level come of the one
// before.
//
// The normals of a grid are computed some at a time in single precision, coordinate by coordinate,
// of points relative to the middle of the grid (tensor_kernels.inl). That is exact enough wherever
// tangents are not tiny beside the grid or nearly parallel, and where they are, double precision
// steps in.
#include "subdivision/tensor_limit.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "limn/contract.h"
#include "subdivision/tensor_kernels.h"

namespace limn {
namespace {

[[nodiscard]] Point weighted(const Point& before, const Point& here, const Point& after) noexcept {
  return before + here * 4.0 + after;
}

/// Columns of three or four rows combined, ring included: 6 times the mean and twice the tangent.
struct CombinedColumns {
  std::array<Point, kLongestLimitRow> means;
  std::array<Point, kLongestLimitRow> differences;

  /// Of row `row`, or between it and the next.
  CombinedColumns(const GridView& grid, std::size_t row, bool is_between) {
    const Point* here = grid.points + row * grid.stride;
    for (std::size_t i = 0; i < grid.n + 3; ++i, ++here) {
      const Point& before = *(here - grid.stride);
      const Point& above = here[grid.stride];
      if (is_between) {
        const Point& after = here[2 * grid.stride];
        means[i] = (before + after) * 0.125 + (*here + above) * 2.875;
        differences[i] = (after - before) * 0.25 + (above - *here) * 1.25;
      } else {
        means[i] = weighted(before, *here, above);
        differences[i] = above - before;
      }
    }
  }

  /// At vertex i one level down, 0..2 n.
  [[nodiscard]] glm::dvec3 normal(std::size_t i) const noexcept {
    const Point* m = means.data() + i / 2 + 1;
    const Point* d = differences.data() + i / 2 + 1;
    if (i % 2 == 0) {
      return unit_normal(m[1] - m[-1], weighted(d[-1], d[0], d[1]));
    }
    return unit_normal((m[2] - m[-1]) + (m[1] - m[0]) * 5.0, (d[-1] + d[2]) + (d[0] + d[1]) * 23.0);
  }
};

class GridNormals {
 public:
  GridNormals(const GridView& grid, const NormalArrays& out);
  void write();

 private:
  void combine_row(std::size_t y);
  void compute_row(std::size_t y);

  const GridView* grid_;
  const NormalArrays* out_;
  const TensorKernels* kernels_;
  CoordinateRow rows_[kLongestLimitRow];
  /// In turns, so that what is read was not written just before: a processor waits for that.
  std::array<CombinedRow, 2> combined_;
  std::array<float, 6 * (kLongestLimitRow + 8)> normals_;  ///< Those of a row, borders included.
};

GridNormals::GridNormals(const GridView& grid, const NormalArrays& out)
    : grid_(&grid), out_(&out), kernels_(&tensor_kernels()) {
  const std::size_t n = grid.n;
  const auto vertex = [&grid](std::size_t x, std::size_t y) {
    return grid.points[(y + 1) * grid.stride + x + 1];
  };
  const Point middle = vertex(n / 2, n / 2);
  double extent = 0.0;
  for (const Point& corner : {vertex(0, 0), vertex(n, 0), vertex(0, n), vertex(n, n)}) {
    for (int axis = 0; axis < 3; ++axis) {
      extent = std::max(extent, std::abs(corner[axis] - middle[axis]));
    }
  }
  // Where all corners coincide, or are next to doing so, double precision sees to everything.
  const double scale = extent > 1e-100 ? 1.0 / extent : 0.0;
  // The grid becomes about 1 large.
  kernels_->load_rows(grid, middle, Point{scale, scale, scale, scale}, rows_);
}

/// Row y of the next level, 0..2 n, out of those around it. The grid's row 0 is the ring's.
void GridNormals::combine_row(std::size_t y) {
  kernels_->combine_rows(rows_ + y / 2 + 1, grid_->n, y % 2 == 1, combined_[y % 2]);
}

void GridNormals::compute_row(std::size_t y) {
  const std::size_t n = grid_->n;
  if (kernels_->write_normals(combined_[y % 2], n, normals_.data())) {
    return;
  }
  const CombinedColumns columns(*grid_, y / 2 + 1, y % 2 == 1);
  for (std::size_t i = 0; i <= 2 * n; ++i) {
    const glm::vec3 normal = columns.normal(i);
    std::memcpy(normals_.data() + 3 * i, &normal, sizeof normal);
  }
}

void GridNormals::write() {
  const std::size_t n = grid_->n;
  const std::size_t inner = 3 * (2 * n - 1);
  const auto put = [](float* to, const float* from, std::size_t floats) {
    if (to != nullptr) {
      std::memcpy(to, from, floats * sizeof(float));
    }
  };
  const auto put_inner = [&](float* to) { put(to, normals_.data() + 3, inner); };
  const std::size_t first = out_->sides[0] != nullptr ? 0 : 1;
  const std::size_t last = out_->sides[2] != nullptr ? 2 * n : 2 * n - 1;
  combine_row(first);
  for (std::size_t y = first; y <= last; ++y) {
    if (y < last) {
      combine_row(y + 1);
    }
    compute_row(y);
    if (y == 0 || y == 2 * n) {
      put_inner(out_->sides[y == 0 ? 0 : 2]);
      continue;
    }
    put_inner(out_->inner + (y - 1) * inner);
    for (const std::size_t side : {std::size_t{1}, std::size_t{3}}) {
      float* const to = out_->sides[side];
      put(to == nullptr ? to : to + 3 * (y - 1),
          side == 3 ? normals_.data() : normals_.data() + 3 + inner, 3);
    }
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

void limit_normals(const GridView& grid, const NormalArrays& out) {
  LIMN_ASSERT(grid.n + 3 <= kLongestLimitRow);
  GridNormals(grid, out).write();
}

}  // namespace limn
