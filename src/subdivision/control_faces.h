#pragma once

#include <cstdint>
#include <span>

#include "limn/mesh/large_array.h"
#include "subdivision/cage.h"
#include "subdivision/numbering.h"
#include "subdivision/patch.h"
#include "subdivision/ring_tables.h"
#include "subdivision/sweep.h"

// From control faces to patches. Internal to this folder.
namespace limn {

/// Everything known before the first refined vertex is written.
struct RefinementPlan {
  Cage cage;
  std::span<const std::uint8_t> labels;
  std::span<const std::uint8_t> greatest;  ///< Label of each face.
  const Numbering* numbering = nullptr;
  const RingTables* rings = nullptr;
  std::span<const std::uint32_t>
      vertex_owners;  ///< The corner that sees to a vertex; kNone: placed.
};

/// For each vertex of the cage the corner whose face writes it; vertices that never move are
/// written at once.
void place_resting_vertices(Sweep& sweep, const Cage& cage, std::span<const std::uint8_t> labels,
                            std::span<const std::uint8_t> greatest, const RefinedArrays& arrays,
                            LargeArray<std::uint32_t>& owners);

/// Writes everything that becomes of face f. Polygons that stay are left to the caller.
void refine_face(const RefinementPlan& plan, std::uint32_t f, const RefinedArrays& arrays);

}  // namespace limn
