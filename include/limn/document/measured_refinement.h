#pragma once

#include <cstdint>
#include <memory>

#include "limn/comparison/limit_distance.h"
#include "limn/document/document.h"
#include "limn/document/refinement.h"
#include "limn/error.h"
#include "limn/painting/auto_depth/budget.h"
#include "limn/progress.h"

/// How far from the limit surface a painting comes: what paintings that aim at it are told by.
namespace limn {

/// A refinement and its distance from the limit surface.
struct MeasuredRefinement {
  std::shared_ptr<const RefinedMesh> mesh;
  LimitDistance distance;
};

/// Measures `made`, which came from these labels and stopped after so many levels, or where it is
/// null the mesh that the labels give without demands.
/// Errors: those of `measure_limit_distance`.
[[nodiscard]] Result<MeasuredRefinement> measure_refinement(const Document& document,
                                                            const DerivedLabels& labels, int levels,
                                                            std::shared_ptr<const RefinedMesh> made,
                                                            Progress& progress);

/// A painting that a budget is held against, and how far it is from the limit surface, in mesh
/// units.
struct BudgetBaseline {
  std::uint64_t faces = 0;
  double greatest = 0.0;
  double root_mean_square = 0.0;

  [[nodiscard]] bool operator==(const BudgetBaseline&) const = default;
};
struct BudgetBaselines {
  BudgetBaseline uniform;  ///< The finest even painting within the budget,
  BudgetBaseline random;   ///< and faces painted at random until it is used up.

  [[nodiscard]] bool operator==(const BudgetBaselines&) const = default;
};

/// What else could be had for a budget. Errors: those of `depths_for_budget` and
/// `measure_limit_distance`.
[[nodiscard]] Result<BudgetBaselines> measure_budget_baselines(const Document& document,
                                                               FaceBudget budget,
                                                               Progress& progress);

}  // namespace limn
