#pragma once

#include <cstddef>
#include <cstdint>

#include "subdivision/limit_point.h"
#include "subdivision/patch_levels.h"
#include "subdivision/ring_tables.h"

// Limits of the vertices of a refinement. Internal to this folder.
namespace limn {

/// A vertex of a grid: 0..n along and across.
struct GridPlace {
  std::size_t x = 0;
  std::size_t y = 0;
};

/// The limit of a vertex of a patch at any level.
[[nodiscard]] LimitPoint limit_in_patch(const Patch& patch, const PatchGrid& at,
                                        const GridPlace& place);

/// In a face's next level the corners, and the midpoints of the sides.
inline constexpr std::array<GridPlace, 4> kCornersOfFour{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}};
inline constexpr std::array<GridPlace, 4> kMiddlesOfFour{{{1, 0}, {2, 1}, {1, 2}, {0, 1}}};

/// How the limits along a side of a grid are found.
enum class SideLimits {
  kSmooth,    ///< As inside.
  kMirrored,  ///< As inside, once what lies beyond mirrors what lies within.
  kWearing,   ///< Vertex by vertex: it changes rules at some level.
};

[[nodiscard]] SideLimits side_limits(const Patch& patch, const PatchGrid& grid, std::size_t i);

/// Replaces the ring beyond side i, so that the rules inside give those of the curve. `points` are
/// the grid's.
void mirror_ring(const GridView& grid, std::size_t i, Point* points);

/// The limits of all vertices that a uniform node owns, out of its last level but one with the
/// ring. `points` are that level's, and lose those beyond the patch's own sides.
void put_uniform_limits(const Patch& patch, const Node& node, const PatchGrid& before_last,
                        Point* points, const RefinedArrays& arrays);

/// The same for a node of one level, whose positions are all put.
void put_last_limits(const Patch& patch, const Node& node, const PatchGrid& grid,
                     const RefinedArrays& arrays);

/// The limit of a vertex of the cage. `rings` are the cage's, with limits.
[[nodiscard]] LimitPoint limit_in_cage(const Cage& cage, const RingTables& rings, std::uint32_t v);

}  // namespace limn
