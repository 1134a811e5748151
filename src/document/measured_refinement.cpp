#include "limn/document/measured_refinement.h"

#include <utility>

#include "limn/part_of_progress.h"

namespace limn {
namespace {

Result<BudgetBaseline> measure_painting(const Document& document, const FaceDepths& depths,
                                        Progress& progress) {
  const Result<DerivedLabels> labels =
      derive_labels(*document.control, depths.values(), document.settings, progress);
  if (!labels) {
    return tl::unexpected(labels.error());
  }
  return measure_refinement(document, *labels, kAllLevels, nullptr, progress)
      .map([](const MeasuredRefinement& measured) {
        return BudgetBaseline{measured.mesh->face_count(), measured.distance.greatest(),
                              measured.distance.root_mean_square()};
      });
}

/// The finest even painting that a budget has room for.
Result<FaceDepths> even_painting(const Document& document, const FaceBudget& budget,
                                 Progress& progress) {
  FaceDepths fits(document.control->face_count());
  for (int depth = 1; depth <= kMaxDepth; ++depth) {
    FaceDepths even(fits.size(), depth);
    const Result<DerivedLabels> labels =
        derive_labels(*document.control, even.values(), document.settings, progress);
    if (!labels) {
      return tl::unexpected(labels.error());
    }
    const std::uint64_t count = budget.unit == FaceBudget::Unit::kTriangles
                                    ? 2 * labels->prediction.faces
                                    : labels->prediction.faces;
    if (count > budget.most) {
      break;
    }
    fits = std::move(even);
  }
  return fits;
}

}  // namespace

Result<MeasuredRefinement> measure_refinement(const Document& document, const DerivedLabels& labels,
                                              int levels, std::shared_ptr<const RefinedMesh> made,
                                              Progress& progress) {
  const VertexLabels kept = labels_up_to(labels, levels);
  RefinedMesh refined;
  // Of another scheme there is nothing to measure, which is said below.
  if (made == nullptr && document.settings.scheme == RefinementScheme::kCatmullClark) {
    Result<RefinedMesh> result = refine(*document.control, kept, document.settings, {}, progress);
    if (!result) {
      return tl::unexpected(std::move(result.error()));
    }
    refined = *std::move(result);
  }
  if (made == nullptr) {
    made = std::make_shared<const RefinedMesh>(std::move(refined));
  }
  return measure_limit_distance(*document.control, kept, document.settings, *made, progress)
      .map([&](LimitDistance distance) {
        return MeasuredRefinement{made, std::move(distance)};
      });
}

Result<BudgetBaselines> measure_budget_baselines(const Document& document, FaceBudget budget,
                                                 Progress& progress) {
  BudgetBaselines baselines;
  const auto keep = [&](BudgetBaseline& to, Progress& part) {
    return [&](const FaceDepths& depths) -> Result<void> {
      return measure_painting(document, depths, part).map([&](const BudgetBaseline& baseline) {
        to = baseline;
      });
    };
  };
  PartOfProgress even_part(progress, 0.0, 0.5);
  if (Result<void> done =
          even_painting(document, budget, even_part).and_then(keep(baselines.uniform, even_part));
      !done) {
    return tl::unexpected(std::move(done.error()));
  }
  PartOfProgress random_part(progress, 0.5, 1.0);
  budget.goal = FaceBudget::Goal::kRandom;
  return depths_for_budget(*document.control, document.settings, {budget, {}}, random_part)
      .map([](BudgetedDepths budgeted) { return std::move(budgeted.chosen.depths); })
      .and_then(keep(baselines.random, random_part))
      .map([&] { return baselines; });
}

}  // namespace limn
