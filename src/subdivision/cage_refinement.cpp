#include "subdivision/cage_refinement.h"

#include <algorithm>

#include "subdivision/fine/fine_counts.h"

namespace limn {

void CageRefinement::begin(const Cage& cage, std::span<const glm::dvec3> points,
                           const glm::dvec3& origin) {
  cage_ = cage;
  cage_.positions = points;
  cage_.origin = origin;
  labels_.resize(points.size());
}

RefinedCounts CageRefinement::number(Sweep& sweep, const FineLabels* fine, int levels) {
  fine_ = fine;
  levels_ = levels;
  greatest_of_all_ = 0;
  is_any_resting_ = false;
  for (const std::uint8_t label : labels_) {
    greatest_of_all_ = std::max(greatest_of_all_, label);
    is_any_resting_ |= label == 0;
  }
  if (fine == nullptr) {
    return numbering_.build(sweep, cage_, labels_, nullptr);
  }
  const FineCounts counts(cage_, labels_, *fine, levels);
  return numbering_.build(sweep, cage_, labels_, &counts);
}

void CageRefinement::run_rings(Sweep& sweep, bool with_limits) {
  rings_.build(sweep, cage_, numbering_.greatest(), with_limits);
}

void CageRefinement::place_resting(Sweep& sweep, const RefinedArrays& arrays) {
  if (is_any_resting_) {
    place_resting_vertices(sweep, plan(), arrays, resting_owners_);
  }
  if (fine_ != nullptr && !sweep.is_cancelled()) {
    fine_trees_.build(plan(), *fine_, levels_);
  }
}

}  // namespace limn
