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

/// The limits of all vertices that a uniform node owns, out of its last level with the ring; where
/// positions are not the limit's, of those inside also these.
void put_uniform_limits(const Patch& patch, const Node& node, const PatchGrid& last,
                        const RefinedArrays& arrays);

/// The limit of a vertex of the cage. `rings` are the cage's, with limits.
[[nodiscard]] LimitPoint limit_in_cage(const Cage& cage, const RingTables& rings, std::uint32_t v);

}  // namespace limn
