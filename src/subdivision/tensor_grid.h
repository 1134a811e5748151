#pragma once

#include <cstddef>

#include "subdivision/point.h"

// One Catmull-Clark step of a regular piece of surface is the tensor product of the cubic
// B-spline's rule for curves. Internal to this folder.
namespace limn {

/// n x n faces and the ring of vertices around them: (n + 3) x (n + 3) points, row by row. Vertex
/// (x, y) of the faces, each 0..n, stands at column x + 1 and row y + 1.
struct GridView {
  const StoredPoint* points = nullptr;
  std::size_t stride = 0;  ///< Points from one row to the next.
  std::size_t n = 0;       ///< Faces along a side.
};

/// One line of vertices of the grid, n + 3 of them with the ring's: a row, a column, or a curve
/// that is subdivided on its own.
struct GridLine {
  const StoredPoint* points = nullptr;
  std::size_t along = 1;   ///< Points from one vertex to the next.
  std::size_t across = 0;  ///< Points from a vertex to its neighbour beside the line.
  std::size_t n = 0;
};

/// The same points one level down, ring included: 2 n faces a side, `out` has (2 n + 3)^2 points.
void refine_grid(const GridView& grid, Point* out);

/// The vertices of a line and the points between them one level down, without the ring's: 2 n + 1.
void refine_line(const GridLine& line, Point* out);

/// The vertices that lie inside the faces' square (columns and rows 2..2 n of those of
/// `refine_grid`) as floats, `width` (3 or 2) of each point: (2 n - 1)^2 of these.
void refine_inner_rows(const GridView& grid, float* out, std::size_t width);

/// The same in bilinear faces, which need no ring.
void bilinear_inner_rows(const GridView& grid, float* out, std::size_t width);

/// Their limits, 3 floats each.
void limit_inner_rows(const GridView& grid, float* out);

/// The limits of the vertices 1..2 n - 1 of a line one level down.
void limit_line(const GridLine& line, Point* out);

/// One level down a line that is a curve of its own (a boundary or a crease), with the ring's: 2 n
/// + 3 points, `out_step` apart.
void refine_curve(const GridLine& line, Point* out, std::size_t out_step);

/// The point between two, and the new place of a point between two others.
[[nodiscard]] inline Point curve_edge_point(const Point& a, const Point& b) noexcept {
  return (a + b) * 0.5;
}
[[nodiscard]] inline Point curve_vertex_point(const Point& a, const Point& v,
                                              const Point& b) noexcept {
  return (a + b) * 0.125 + v * 0.75;
}

}  // namespace limn
