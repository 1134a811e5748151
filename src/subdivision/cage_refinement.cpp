#include "subdivision/cage_refinement.h"

#include <algorithm>

namespace limn {

void CageRefinement::begin(const Cage& cage, std::span<const glm::dvec3> points,
                           const glm::dvec3& origin) {
  cage_ = cage;
  points_.resize(points.size());
  std::ranges::transform(points, points_.begin(),
                         [&origin](const glm::dvec3& p) { return to_point(p - origin); });
  cage_.points = points_;
  labels_.resize(points.size());
}

RefinedCounts CageRefinement::number(Sweep& sweep) {
  greatest_of_all_ = labels_.empty() ? std::uint8_t{0} : *std::ranges::max_element(labels_);
  return numbering_.build(sweep, cage_, labels_);
}

void CageRefinement::run_rings(Sweep& sweep, bool with_limits) {
  rings_.build(sweep, cage_, numbering_.greatest(), with_limits);
}

void CageRefinement::place_resting(Sweep& sweep, const RefinedArrays& arrays) {
  place_resting_vertices(sweep, cage_, labels_, numbering_.greatest(), rings_, arrays, owners_);
}

}  // namespace limn
