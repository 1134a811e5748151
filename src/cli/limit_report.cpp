#include "cli/limit_report.h"

#include <memory>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/console.h"
#include "limn/painting/depth_choice.h"

namespace limn::cli {
namespace {

/// The last rule that aims at the limit surface.
const ChooseDepths* last_aim(const PaintingOptions& options) {
  const ChooseDepths* last = nullptr;
  for (const PaintRule& rule : options.rules) {
    if (aims_at_limit(rule)) {
      last = &std::get<ChooseDepths>(rule.action);
    }
  }
  return last;
}

std::optional<double> length_of(const ChooseByTolerance& tolerance, double diagonal) {
  switch (tolerance.unit) {
    case ChooseByTolerance::Unit::kDiagonals:
      return tolerance.distance * diagonal;
    case ChooseByTolerance::Unit::kLength:
      return tolerance.distance;
    case ChooseByTolerance::Unit::kPixels:
      break;
  }
  return std::nullopt;
}

nlohmann::ordered_json baseline_json(const BudgetBaseline& baseline) {
  return {{"faces", baseline.faces},
          {"greatest", baseline.greatest},
          {"root_mean_square", baseline.root_mean_square}};
}

std::string distance_text(double distance, double diagonal) {
  return fmt::format("{:.6g} ({:.4g} % of the diagonal)", distance, 100.0 * distance / diagonal);
}

std::string baseline_text(const BudgetBaseline& baseline) {
  return fmt::format("{:.6g} greatest, {:.6g} r.m.s. with {} faces", baseline.greatest,
                     baseline.root_mean_square, baseline.faces);
}

}  // namespace

Result<std::optional<ReachedLimit>> measure_reached(const PaintingOptions& options,
                                                    const Document& document,
                                                    const Derived& derived) {
  const ChooseDepths* aim = last_aim(options);
  if (aim == nullptr) {
    return std::optional<ReachedLimit>();
  }
  const std::shared_ptr<void> limit = limit_threads(options.threads);
  TerminalProgress progress;
  const Result<MeasuredRefinement> measured =
      measure_refinement(document, derived.labels, options.levels,
                         derived.refinement ? derived.refinement->mesh : nullptr, progress);
  if (!measured) {
    return tl::unexpected(measured.error());
  }
  ReachedLimit reached;
  reached.diagonal = document.control->bounds().diagonal();
  reached.greatest = measured->distance.greatest();
  reached.root_mean_square = measured->distance.root_mean_square();
  reached.is_settled = measured->distance.is_settled;
  if (const auto* tolerance = std::get_if<ChooseByTolerance>(&aim->choice)) {
    reached.tolerance = length_of(*tolerance, reached.diagonal);
  } else {
    Result<BudgetBaselines> baselines =
        measure_budget_baselines(document, std::get<FaceBudget>(aim->choice), progress);
    if (!baselines) {
      return tl::unexpected(std::move(baselines.error()));
    }
    reached.baselines = *baselines;
  }
  return std::optional<ReachedLimit>(reached);
}

nlohmann::ordered_json reached_report(const ReachedLimit& reached) {
  nlohmann::ordered_json report = {{"greatest", reached.greatest},
                                   {"root_mean_square", reached.root_mean_square},
                                   {"settled", reached.is_settled},
                                   {"diagonal", reached.diagonal}};
  if (reached.tolerance) {
    report["tolerance"] = *reached.tolerance;
  }
  if (reached.baselines) {
    report["uniform"] = baseline_json(reached.baselines->uniform);
    report["random"] = baseline_json(reached.baselines->random);
  }
  return report;
}

std::string reached_text(const ReachedLimit& reached) {
  const auto row = [](const char* name, const std::string& value) {
    return fmt::format("{:<22}{}\n", name, value);
  };
  std::string text = row("distance to limit", distance_text(reached.greatest, reached.diagonal) +
                                                  (reached.is_settled ? "" : ", about"));
  text += row("  r.m.s.", distance_text(reached.root_mean_square, reached.diagonal));
  if (reached.tolerance) {
    text +=
        row("  tolerance", distance_text(*reached.tolerance, reached.diagonal) +
                               (reached.greatest > *reached.tolerance ? ", NOT KEPT" : ", kept"));
  }
  if (reached.baselines) {
    text += row("  uniform mesh", baseline_text(reached.baselines->uniform));
    text += row("  painted at random", baseline_text(reached.baselines->random));
  }
  return text;
}

}  // namespace limn::cli
