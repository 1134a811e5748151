// The kernels for the processor at hand against those for any: not a bit may differ, or a mesh
// would depend on the machine it was refined on.
#include "subdivision/tensor_kernels.h"

#include <bit>
#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace limn {
namespace {

constexpr std::size_t kSides[] = {1, 2, 3, 4, 5, 8, 16, 32};

std::vector<Point> random_grid(std::size_t n, std::mt19937& random) {
  std::uniform_real_distribution<double> height(-0.3, 0.3);
  std::vector<Point> points;
  for (std::size_t y = 0; y < n + 3; ++y) {
    for (std::size_t x = 0; x < n + 3; ++x) {
      points.push_back(Point{static_cast<double>(x) + height(random),
                             static_cast<double>(y) + height(random), height(random), 0.0});
    }
  }
  return points;
}

std::vector<std::uint64_t> bits_of(const std::vector<Point>& points) {
  std::vector<std::uint64_t> bits;
  for (const Point& point : points) {
    for (int lane = 0; lane < 3; ++lane) {
      bits.push_back(std::bit_cast<std::uint64_t>(point[lane]));
    }
  }
  return bits;
}

std::vector<std::uint32_t> bits_of(const std::vector<float>& floats, std::size_t count) {
  std::vector<std::uint32_t> bits;
  for (std::size_t i = 0; i < count; ++i) {
    bits.push_back(std::bit_cast<std::uint32_t>(floats[i]));
  }
  return bits;
}

/// Everything the kernels make of a grid.
struct Made {
  std::vector<std::uint64_t> points;
  std::vector<std::uint32_t> floats;
  bool operator==(const Made&) const = default;
};

Made run(const TensorKernels& kernels, const std::vector<Point>& grid, std::size_t n) {
  const GridView view{grid.data(), n + 3, n};
  const GridLine line{grid.data() + n + 3, 1, n + 3, n};
  Made made;
  const auto keep = [&made](const std::vector<Point>& points) {
    const auto bits = bits_of(points);
    made.points.insert(made.points.end(), bits.begin(), bits.end());
  };
  const auto keep_floats = [&made](const std::vector<float>& floats, std::size_t count) {
    const auto bits = bits_of(floats, count);
    made.floats.insert(made.floats.end(), bits.begin(), bits.end());
  };
  std::vector<Point> refined((2 * n + 3) * (2 * n + 3));
  kernels.refine_grid(view, refined.data());
  keep(refined);
  std::vector<Point> on_line(2 * n + 1);
  kernels.refine_line(line, on_line.data());
  keep(on_line);
  std::vector<Point> limits(2 * n - 1);
  kernels.limit_line(line, limits.data());
  keep(limits);
  const std::size_t inner = (2 * n - 1) * (2 * n - 1);
  for (const std::size_t width : {2u, 3u}) {
    std::vector<float> rows(width * inner);
    kernels.refine_inner_rows(view, rows.data(), width);
    keep_floats(rows, rows.size());
  }
  std::vector<float> limit_rows(3 * inner);
  kernels.limit_inner_rows(view, limit_rows.data());
  keep_floats(limit_rows, limit_rows.size());

  static CoordinateRow rows[kLongestLimitRow];
  kernels.load_rows(view, grid[grid.size() / 2], Point{0.1, 0.1, 0.1, 0.1}, rows);
  for (const bool is_between : {false, true}) {
    CombinedRow combined;
    kernels.combine_rows(rows + 1, n, is_between, combined);
    std::vector<float> normals(3 * (2 * n + 16));
    EXPECT_TRUE(kernels.write_normals(combined, n, normals.data()));
    keep_floats(normals, 3 * (2 * n + 1));
  }
  return made;
}

TEST(TensorKernels, GiveTheSameBitsOnEveryProcessor) {
  std::mt19937 random(7);
  for (const std::size_t n : kSides) {
    const std::vector<Point> grid = random_grid(n, random);
    EXPECT_EQ(run(kBaselineKernels, grid, n), run(tensor_kernels(), grid, n)) << n;
  }
}

TEST(TensorKernels, OwnUpToNormalsThatAreNotExact) {
  constexpr std::size_t n = 4;
  const std::vector<Point> flat((n + 3) * (n + 3), Point{1.0, 2.0, 3.0, 0.0});
  static CoordinateRow rows[kLongestLimitRow];
  tensor_kernels().load_rows({flat.data(), n + 3, n}, Point{}, Point{1.0, 1.0, 1.0, 1.0}, rows);
  CombinedRow combined;
  tensor_kernels().combine_rows(rows + 1, n, false, combined);
  std::vector<float> normals(3 * (2 * n + 16));
  EXPECT_FALSE(tensor_kernels().write_normals(combined, n, normals.data()));
}

}  // namespace
}  // namespace limn
