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
  std::uint8_t greatest_of_all = 0;
  const Numbering* numbering = nullptr;
  const RingTables* rings = nullptr;
  std::span<const std::uint32_t>
      vertex_owners;  ///< The corner that sees to a vertex; kNone: placed.

  /// Whether face f is no quad and stays as it is.
  [[nodiscard]] bool is_resting_polygon(std::uint32_t f) const noexcept {
    return greatest[f] == 0 && cage.side_count(f) != 4;
  }
};

/// For each vertex of the cage the corner whose face writes it; vertices that never move are
/// written at once.
void place_resting_vertices(Sweep& sweep, const Cage& cage, std::span<const std::uint8_t> labels,
                            std::span<const std::uint8_t> greatest, const RingTables& rings,
                            const RefinedArrays& arrays, LargeArray<std::uint32_t>& owners);

/// Writes everything that becomes of face f, which is no resting polygon.
void refine_face(const RefinementPlan& plan, std::uint32_t f, const RefinedArrays& arrays);

}  // namespace limn
