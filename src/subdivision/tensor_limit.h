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

/// Where limits go, x after y after z, row by row; either may be null.
struct LimitArrays {
  float* positions = nullptr;
  float* normals = nullptr;
};

/// Vertices of the longest row of a grid.
inline constexpr std::size_t kLongestRow = 65;

/// The limits of the vertices 1..n - 1 of the rows 1..n - 1. The points of the ring do not matter.
/// Normals are right to a hundredth of a degree or to what the rounding of points leaves of them.
void limit_inner_rows(const GridView& grid, const LimitArrays& out);

}  // namespace limn
