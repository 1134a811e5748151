#pragma once

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "cli/input.h"

namespace limn::cli {

/// A painting that a budget is held against, and how far it is from the limit surface.
struct BudgetBaseline {
  std::uint64_t faces = 0;
  double greatest = 0.0;
  double root_mean_square = 0.0;
};

/// What a painting that aims at the limit surface has come to, in mesh units.
struct ReachedLimit {
  std::optional<double> tolerance;  ///< Of the last rule with one that is no size on the screen.
  double greatest = 0.0;
  double root_mean_square = 0.0;
  bool is_settled = false;
  double diagonal = 0.0;
  std::optional<BudgetBaseline> uniform;  ///< Where the last rule that aims at the limit surface is
                                          ///< a budget: the finest even painting within it,
  std::optional<BudgetBaseline> random;  ///< and faces painted at random.
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
