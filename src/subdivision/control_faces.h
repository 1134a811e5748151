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

class FineTrees;

/// Everything known before the first refined vertex is written.
struct RefinementPlan {
  Cage cage;
  std::span<const std::uint8_t> labels;
  std::span<const std::uint8_t> greatest;  ///< Numbering::greatest.
  std::uint8_t greatest_of_all = 0;
  const LabelCounts* counts = nullptr;
  const Numbering* numbering = nullptr;
  const RingTables* rings = nullptr;
  std::span<const std::uint32_t> resting_owners;  ///< See place_resting_vertices.
  const FineTrees* fine = nullptr;  ///< Faces with labels of finer levels; null for none.

  /// Whether face f is no quad and stays as it is.
  [[nodiscard]] bool is_resting_polygon(std::uint32_t f) const noexcept {
    return greatest[f] == 0 && cage.side_count(f) != 4;
  }
  /// Whether a corner's face writes the vertex at it.
  [[nodiscard]] bool owns(std::uint32_t corner) const noexcept {
    const std::uint32_t v = cage.topology->corner_vertices[corner];
    return labels[v] > 0 ? cage.topology->corner_ranks[corner] == 0 : resting_owners[v] == corner;
  }
};

/// Writes the vertices of the cage that never move. Those of label 0 that do move get in `owners`
/// the corner whose face writes them: the lowest where a face moves them. Vertices with positive
/// labels are their first corner's.
void place_resting_vertices(Sweep& sweep, const RefinementPlan& plan, const RefinedArrays& arrays,
                            LargeArray<std::uint32_t>& owners);

/// Fetches what `refine_face` will read about face f, if that is refined; and what it will read
/// around it, to be asked for once the former is there. In a large mesh the vertices around a face
/// are far apart in memory, and so are refined faces where few are.
void prefetch_face(const RefinementPlan& plan, std::uint32_t f) noexcept;
void prefetch_around_face(const RefinementPlan& plan, std::uint32_t f) noexcept;

/// Writes everything that becomes of face f, which is no resting polygon. `patch` is room to work
/// in, to be kept from face to face.
void refine_face(const RefinementPlan& plan, std::uint32_t f, Patch& patch,
                 const RefinedArrays& arrays);

}  // namespace limn
