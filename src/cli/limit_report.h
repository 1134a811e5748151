#pragma once

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "cli/input.h"
#include "limn/document/measured_refinement.h"

namespace limn::cli {

/// What a painting that aims at the limit surface has come to, in mesh units.
struct ReachedLimit {
  std::optional<double> tolerance;  ///< Where the last rule that aims at the limit surface has
                                    ///< one that is a length.
  double greatest = 0.0;
  double root_mean_square = 0.0;
  bool is_settled = false;
  double diagonal = 0.0;
  std::optional<BudgetBaselines> baselines;  ///< Where that rule is a budget.
};

/// Measures the refinement of a project that was painted by these rules, with progress on the
/// terminal. Nothing where none of them aims at the limit surface.
[[nodiscard]] Result<std::optional<ReachedLimit>> measure_reached(const PaintingOptions& options,
                                                                  const Document& document,
                                                                  const Derived& derived);

[[nodiscard]] nlohmann::ordered_json reached_report(const ReachedLimit& reached);
/// Lines of "name  value", as those of `refinement_text`.
[[nodiscard]] std::string reached_text(const ReachedLimit& reached);

}  // namespace limn::cli
