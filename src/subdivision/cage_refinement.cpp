#include "subdivision/cage_refinement.h"

#include <algorithm>

namespace limn {

void CageRefinement::begin(const Cage& cage, std::span<const glm::dvec3> points,
                           const glm::dvec3& origin) {
  cage_ = cage;
  cage_.positions = points;
  cage_.origin = origin;
  labels_.resize(points.size());
}

RefinedCounts CageRefinement::number(Sweep& sweep) {
  greatest_of_all_ = 0;
  is_any_resting_ = false;
  for (const std::uint8_t label : labels_) {
    greatest_of_all_ = std::max(greatest_of_all_, label);
    is_any_resting_ |= label == 0;
  }
  return numbering_.build(sweep, cage_, labels_);
}

void CageRefinement::run_rings(Sweep& sweep, bool with_limits) {
  rings_.build(sweep, cage_, numbering_.greatest(), with_limits);
}

void CageRefinement::place_resting(Sweep& sweep, const RefinedArrays& arrays) {
  if (is_any_resting_) {
    place_resting_vertices(sweep, plan(), arrays, resting_owners_);
  }
}

}  // namespace limn
