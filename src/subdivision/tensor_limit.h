#pragma once

#include <array>

#include "subdivision/limit_point.h"
#include "subdivision/tensor_grid.h"

// The limit of a regular piece of surface: that of the cubic B-spline, along and across. Internal
// to this folder.
namespace limn {

/// A regular vertex with the eight around it: 3 x 3 points, row by row.
using PointsAround = std::array<Point, 9>;

/// The limit of the vertex in the middle.
[[nodiscard]] LimitPoint tensor_limit(const PointsAround& points);

/// Where what the inner vertices of a row become goes, x after y after z; either may be null.
struct LimitRow {
  float* positions = nullptr;
  float* normals = nullptr;
};

/// Inner vertices of the longest row of a grid.
inline constexpr std::size_t kLongestInnerRow = 63;

/// The limits of the vertices 1..n - 1 of row `row`, which is 1..n - 1 as well.
void limit_inner_row(const GridView& grid, std::size_t row, const LimitRow& out);

}  // namespace limn
