#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "limn/mesh/refined_mesh.h"

// The edges of a refined mesh, found from its faces alone. Internal to this folder.
namespace limn {

/// One side of a face, seen from the edge it lies on.
struct FaceSide {
  std::uint32_t high;  ///< The edge's vertex of the higher number.
  std::uint32_t face;
  bool is_from_low;  ///< Whether the face runs from the lower vertex to the higher one.
};

/// All face sides, grouped by the lower vertex of their edge (group v is `sides[offsets[v] ..
/// offsets[v + 1])`) and sorted by the higher one within: equal neighbours lie on one edge.
struct FaceSides {
  std::vector<std::uint64_t> offsets;
  std::vector<FaceSide> sides;
};

[[nodiscard]] FaceSides gather_face_sides(const RefinedMesh& mesh);

/// Calls `visit(low, sides)` for every edge with the face sides that lie on it.
template <class Visit>
void for_each_edge(const FaceSides& all, const Visit& visit) {
  for (std::uint32_t low = 0; low + 1 < all.offsets.size(); ++low) {
    std::size_t first = all.offsets[low];
    const std::size_t end = all.offsets[low + 1];
    while (first < end) {
      std::size_t last = first + 1;
      while (last < end && all.sides[last].high == all.sides[first].high) {
        ++last;
      }
      visit(low, std::span(all.sides).subspan(first, last - first));
      first = last;
    }
  }
}

}  // namespace limn
