#pragma once

#include <array>

#include "subdivision/patch_levels.h"
#include "subdivision/patch_limits.h"

// Internal to this folder.
namespace limn {

/// One face's next level, ring included, and where its own points stand.
class Around {
 public:
  /// `node` outlives it: a copy of what was just written would be waited for.
  Around(const Patch& patch, const PatchGrid& node) : node_(&node) {
    step_down(patch, node, points_.data());
  }

  [[nodiscard]] PatchGrid grid() const { return one_level_down(*node_, points_.data()); }
  [[nodiscard]] const Point& at(const GridPlace& place) const {
    return points_[(place.y + 1) * kSide + place.x + 1];
  }
  /// Child i with the points around it.
  [[nodiscard]] GridView child(std::size_t i) const {
    constexpr std::array<std::size_t, 4> kAt{0, 1, kSide + 1, kSide};
    return {points_.data() + kAt[i], kSide, 1};
  }

 private:
  static constexpr std::size_t kSide = 5;

  std::array<Point, kSide * kSide> points_;
  const PatchGrid* node_;
};

/// Where the face point stands in it; corners and midpoints are in patch_limits.h.
inline constexpr GridPlace kCentreOfFour{1, 1};

}  // namespace limn
