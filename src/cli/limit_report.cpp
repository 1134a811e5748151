#include "cli/limit_report.h"

#include <memory>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/console.h"
#include "limn/comparison/limit_distance.h"
#include "limn/document/document.h"
#include "limn/document/refinement.h"
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

Result<LimitDistance> measure(const Document& document, const DerivedLabels& labels, int levels,
                              const std::shared_ptr<const RefinedMesh>& made, Progress& progress) {
  const VertexLabels kept = labels_up_to(labels, levels);
  std::shared_ptr<const RefinedMesh> mesh = made;
  if (mesh == nullptr) {
    Result<RefinedMesh> refined = refine(*document.control, kept, document.settings, {}, progress);
    if (!refined) {
      return tl::unexpected(std::move(refined.error()));
    }
    mesh = std::make_shared<const RefinedMesh>(*std::move(refined));
  }
  return measure_limit_distance(*document.control, kept, document.settings, *mesh, progress);
}

Result<BudgetBaseline> measure_painting(const Document& document, const FaceDepths& depths,
                                        Progress& progress) {
  const Result<DerivedLabels> labels =
      derive_labels(*document.control, depths.values(), document.settings, progress);
  if (!labels) {
    return tl::unexpected(labels.error());
  }
  return measure(document, *labels, kAllLevels, nullptr, progress)
      .map([&](const LimitDistance& distance) {
        return BudgetBaseline{labels->prediction.faces, distance.greatest(),
                              distance.root_mean_square()};
      });
}

/// The finest even painting that a budget has room for.
Result<FaceDepths> even_painting(const Document& document, const FaceBudget& budget,
                                 Progress& progress) {
  FaceDepths fits(document.control->face_count());
  for (int depth = 1; depth <= kMaxDepth; ++depth) {
    FaceDepths even(fits.size());
    for (std::size_t f = 0; f < even.size(); ++f) {
      even.set(f, depth);
    }
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

Result<void> add_baselines(const Document& document, FaceBudget budget, Progress& progress,
                           ReachedLimit& reached) {
  const auto keep = [&](std::optional<BudgetBaseline>& to) {
    return [&](const FaceDepths& depths) -> Result<void> {
      return measure_painting(document, depths, progress).map([&](const BudgetBaseline& baseline) {
        to = baseline;
      });
    };
  };
  if (Result<void> done = even_painting(document, budget, progress).and_then(keep(reached.uniform));
      !done) {
    return done;
  }
  budget.goal = FaceBudget::Goal::kRandom;
  return depths_for_budget(*document.control, document.settings, {budget, {}}, progress)
      .map([](BudgetedDepths budgeted) { return std::move(budgeted.chosen.depths); })
      .and_then(keep(reached.random));
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
  const Result<LimitDistance> distance =
      measure(document, derived.labels, options.levels,
              derived.refinement ? derived.refinement->mesh : nullptr, progress);
  if (!distance) {
    return tl::unexpected(distance.error());
  }
  ReachedLimit reached;
  reached.diagonal = document.control->bounds().diagonal();
  reached.greatest = distance->greatest();
  reached.root_mean_square = distance->root_mean_square();
  reached.is_settled = distance->is_settled;
  if (const auto* tolerance = std::get_if<ChooseByTolerance>(&aim->choice)) {
    reached.tolerance = length_of(*tolerance, reached.diagonal);
  } else if (auto added =
                 add_baselines(document, std::get<FaceBudget>(aim->choice), progress, reached);
             !added) {
    return tl::unexpected(std::move(added.error()));
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
  if (reached.uniform) {
    report["uniform"] = baseline_json(*reached.uniform);
  }
  if (reached.random) {
    report["random"] = baseline_json(*reached.random);
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
  if (reached.uniform) {
    text += row("  uniform mesh", baseline_text(*reached.uniform));
  }
  if (reached.random) {
    text += row("  painted at random", baseline_text(*reached.random));
  }
  return text;
}

}  // namespace limn::cli
