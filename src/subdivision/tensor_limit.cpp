// The limit of a vertex of a uniform cubic B-spline is (1 4 1)/6 of itself and its neighbours, and
// its tangent has the direction of (-1 0 1). A surface takes the one along and the other across.
#include "subdivision/tensor_limit.h"

#include "limn/contract.h"

namespace limn {
namespace {

[[nodiscard]] Point weighted(const Point& before, const Point& here, const Point& after) noexcept {
  return before + here * 4.0 + after;
}

void put(const glm::dvec3& v, float* out) noexcept {
  out[0] = static_cast<float>(v.x);
  out[1] = static_cast<float>(v.y);
  out[2] = static_cast<float>(v.z);
}

/// The two directions at every inner vertex of a row.
struct RowTangents {
  std::array<Point, kLongestInnerRow> along;
  std::array<Point, kLongestInnerRow> across;
};

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

void limit_inner_row(const GridView& grid, std::size_t row, const LimitRow& out) {
  LIMN_ASSERT(grid.n >= 2 && grid.n - 1 <= kLongestInnerRow);
  const Point* here = grid.points + (row + 1) * grid.stride;
  const Point* below = here - grid.stride;
  const Point* above = here + grid.stride;
  const auto mean = [&](std::size_t x) { return weighted(below[x], here[x], above[x]); };
  const auto difference = [&](std::size_t x) { return above[x] - below[x]; };
  const std::size_t count = grid.n - 1;

  RowTangents tangents;
  std::array<Point, kLongestInnerRow> positions;
  Point means[2] = {mean(1), mean(2)};
  Point differences[2] = {difference(1), difference(2)};
  for (std::size_t i = 0; i < count; ++i) {
    const Point next_mean = mean(i + 3);
    const Point next_difference = difference(i + 3);
    positions[i] = weighted(means[0], means[1], next_mean) * (1.0 / 36.0);
    tangents.along[i] = next_mean - means[0];
    tangents.across[i] = weighted(differences[0], differences[1], next_difference);
    means[0] = means[1];
    means[1] = next_mean;
    differences[0] = differences[1];
    differences[1] = next_difference;
  }
  if (out.positions != nullptr) {
    for (std::size_t i = 0; i < count; ++i) {
      put(to_vec3(positions[i]), out.positions + 3 * i);
    }
  }
  if (out.normals != nullptr) {
    for (std::size_t i = 0; i < count; ++i) {
      put(unit_normal(tangents.along[i], tangents.across[i]), out.normals + 3 * i);
    }
  }
}

}  // namespace limn
