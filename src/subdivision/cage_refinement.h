#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "limn/mesh/large_array.h"
#include "limn/subdivision/prediction.h"
#include "subdivision/cage.h"
#include "subdivision/control_faces.h"
#include "subdivision/fine/fine_trees.h"

// The refinement of one cage, from its points and labels to arrays. Internal to this folder.
namespace limn {

/// Plans a refinement and keeps its arrays for the next one.
///
///   begin(cage, points, origin), fill labels(), counts = number(sweep), run_rings(sweep, false);
///   make room for `counts`, place_resting(sweep, arrays);
///   refine_face(plan(), f, patch, arrays) for every face, from any thread.
class CageRefinement {
 public:
  /// `cage` without its points, which are taken relative to `origin`.
  void begin(const Cage& cage, std::span<const glm::dvec3> points, const glm::dvec3& origin);
  /// One per vertex, to be filled after `begin`.
  [[nodiscard]] std::span<std::uint8_t> labels() noexcept { return labels_; }

  /// The labels are legal. `fine`: labels of finer levels, held to so many levels; null for none.
  RefinedCounts number(Sweep& sweep, const FineLabels* fine = nullptr, int levels = kAllLevels);
  /// `with_limits`: the arrays will take limits.
  void run_rings(Sweep& sweep, bool with_limits);
  /// Vertices that never move, and the owners of all others; and the trees of faces with labels of
  /// finer levels.
  void place_resting(Sweep& sweep, const RefinedArrays& arrays);

  [[nodiscard]] RefinementPlan plan() const noexcept {
    return {cage_,
            labels_,
            numbering_.greatest(),
            greatest_of_all_,
            &LabelCounts::table(),
            &numbering_,
            &rings_,
            resting_owners_,
            fine_ != nullptr ? &fine_trees_ : nullptr};
  }

 private:
  Cage cage_;
  LargeArray<std::uint8_t> labels_;
  std::uint8_t greatest_of_all_ = 0;
  bool is_any_resting_ = false;  ///< Some vertex has label 0.
  LargeArray<std::uint32_t> resting_owners_;
  Numbering numbering_;
  RingTables rings_;
  const FineLabels* fine_ = nullptr;
  int levels_ = kAllLevels;
  FineTrees fine_trees_;
};

}  // namespace limn
