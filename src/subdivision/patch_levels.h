#pragma once

#include "subdivision/patch.h"

// A step down inside a patch. Internal to this folder.
namespace limn {

/// n x n faces of one level in a patch, and which of the patch's own corners and sides they touch,
/// as in a Node.
struct PatchGrid {
  GridView grid;
  int level = 0;
  std::uint32_t column = 0;  ///< Of the first face among the patch's.
  std::uint32_t row = 0;
  std::uint8_t patch_corners = 0;
  std::uint8_t patch_sides = 0;
};

/// The grid that a step down from this one gives, ring included.
[[nodiscard]] inline PatchGrid one_level_down(const PatchGrid& grid, const Point* points) noexcept {
  const std::size_t n = 2 * grid.grid.n;
  return {{points, n + 3, n}, grid.level + 1,     2 * grid.column,
          2 * grid.row,       grid.patch_corners, grid.patch_sides};
}

/// The face at corner i of the grid.
[[nodiscard]] PatchGrid face_at_corner(const PatchGrid& grid, std::size_t i) noexcept;

/// The vertices of the grid along side i, in the direction of growing column or row.
[[nodiscard]] GridLine side_line(const GridView& grid, std::size_t i) noexcept;

/// The same faces one level down with their ring: (2 n + 3)^2 points, row by row.
void step_down(const Patch& patch, const PatchGrid& from, Point* out);

/// One level down along side i only, in the direction of growing column or row: 2 n + 1 points, of
/// which the corners' do not count. There is room for one more point on either side of them.
void step_down_side(const Patch& patch, const PatchGrid& from, std::size_t side, Point* out);

/// The midpoint of side i of a single face (n = 1), and the face's own.
[[nodiscard]] Point step_down_middle(const Patch& patch, const PatchGrid& from, std::size_t i);
[[nodiscard]] Point centroid(const GridView& grid);

/// Corner i one level down.
[[nodiscard]] Point step_down_corner(const Patch& patch, const PatchGrid& from, std::size_t i);

}  // namespace limn
