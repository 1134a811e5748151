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

/// Where the limit normals of a grid's next level go, 3 floats each.
struct NormalArrays {
  float* inner = nullptr;         ///< Of the vertices that refine_inner_rows writes.
  std::array<float*, 4> sides{};  ///< Of the 2 n - 1 on side i (0 is the first row, 1 the last
                                  ///< column), in the direction of growing columns or rows. May be
                                  ///< null.
};

/// Normals are right to a hundredth of a degree or to what the rounding of points leaves of them.
/// n + 3 <= kLongestLimitRow (tensor_kernels.h).
void limit_normals(const GridView& grid, const NormalArrays& out);

}  // namespace limn
