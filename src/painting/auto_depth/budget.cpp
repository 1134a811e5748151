// All steps of all faces are sorted once, the most rewarding first. How many of them the budget
// allows is found like the zero of a function that is nearly known: nominal costs foretell where to
// probe, counting tells.
#include "limn/painting/auto_depth/budget.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "limn/contract.h"
#include "limn/subdivision/face_errors.h"
#include "limn/subdivision/fine_labels.h"
#include "limn/subdivision/label_subdivision.h"
#include "limn/subdivision/labels.h"
#include "limn/subdivision/prediction.h"
#include "painting/auto_depth/first_step.h"

namespace limn {
namespace {

/// One face, one level deeper.
struct Step {
  float gain = 0.0F;  ///< Per face added.
  std::uint32_t face = 0;
  std::uint8_t depth = 0;  ///< Afterwards.
};

/// Shares of the greatest error at the level that an even painting could afford, below which errors
/// need not be told apart.
constexpr double kSmallestErrorThatCounts = 1e-3;

/// Counts are probed at most so often: by then the place is known to a step, or to a thousandth of
/// the budget.
constexpr int kMostProbes = 24;
constexpr std::uint64_t kFineEnough = 1000;

/// Of the triangles around the first corner, added as vectors: a planar face's area.
double area_of(const ControlMesh& mesh, std::size_t f) {
  const auto corners = mesh.face(f);
  const glm::dvec3 origin = mesh.positions()[corners[0]];
  glm::dvec3 sum(0.0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += glm::cross(mesh.positions()[corners[i]] - origin,
                      mesh.positions()[corners[i + 1]] - origin);
  }
  return 0.5 * glm::length(sum);
}

/// What refining a painting gives.
class Counter {
 public:
  Counter(const ControlMesh& mesh, const SubdivisionSettings& settings, const BudgetTask& task,
          Progress& progress)
      : mesh_(&mesh), settings_(&settings), task_(&task), progress_(&progress) {}

  /// Of proposed depths, once they are finished.
  [[nodiscard]] Result<std::uint64_t> count(const FaceDepths& proposed) const {
    const FaceDepths depths = task_->finish ? task_->finish(proposed) : proposed;
    const Result<LabelsWithDemands> labels = legal_labels(
        *mesh_, depths.values(), task_->demands != nullptr ? *task_->demands : FineDemands(),
        *settings_, *progress_);
    if (!labels) {
      return tl::unexpected(labels.error());
    }
    const std::uint64_t faces =
        predict_refinement(*mesh_, labels->legal.labels, kAllLevels, labels->fine.get()).faces;
    return task_->budget.unit == FaceBudget::Unit::kFaces ? faces
                                                          : triangles(faces, labels->legal.labels);
  }

 private:
  /// All faces are quads but those that are none and stay.
  [[nodiscard]] std::uint64_t triangles(std::uint64_t faces, const VertexLabels& labels) const {
    std::uint64_t total = 2 * faces;
    for (std::size_t f = 0; f < mesh_->face_count() && !mesh_->is_all_quads(); ++f) {
      const auto corners = mesh_->face(f);
      if (corners.size() != 4 &&
          std::ranges::all_of(corners, [&](std::uint32_t v) { return labels[v] == 0; })) {
        total = total - 2 + (corners.size() - 2);
      }
    }
    return total;
  }

  const ControlMesh* mesh_;
  const SubdivisionSettings* settings_;
  const BudgetTask* task_;
  Progress* progress_;
};

/// How deep a single face could go, all others staying as they are.
int deepest_affordable(const ControlMesh& mesh, std::uint64_t most) {
  int depth = 0;
  while (depth < kMaxDepth && mesh.face_count() + (std::uint64_t{4} << (2 * depth)) <= most) {
    ++depth;
  }
  return depth;
}

/// How deep all faces could go.
int even_depth(const ControlMesh& mesh, std::uint64_t most) {
  int depth = 0;
  while (depth < kMaxDepth && mesh.face_count() << (2 * (depth + 1)) <= most) {
    ++depth;
  }
  return depth;
}

Result<std::vector<LevelErrors>> errors_for(const ControlMesh& mesh,
                                            const SubdivisionSettings& settings,
                                            const FaceBudget& budget, Progress& progress) {
  FaceErrorOptions options;
  options.corners = settings.corners;
  options.points = settings.points;
  const int first_step = first_step_levels(mesh, settings);
  const int even = even_depth(mesh, budget.most);
  // First roughly: how large errors are that such a budget leaves.
  options.deepest = even + first_step;
  options.enough = 1e-3 * mesh.bounds().diagonal();
  auto rough = face_errors(mesh, options, progress);
  if (!rough) {
    return rough;
  }
  float greatest = 0.0F;
  for (const LevelErrors& errors : *rough) {
    greatest = std::max(greatest, at_level(errors, even + first_step));
  }
  options.deepest = deepest_affordable(mesh, budget.most) + first_step;
  options.enough = kSmallestErrorThatCounts * greatest;
  return face_errors(mesh, options, progress);
}

/// How long a face waits until it is hit once more, where all are hit equally often.
double random_wait(std::mt19937& random) {
  return -std::log((static_cast<double>(random()) + 1.0) / 4294967296.0) + 1e-9;
}

/// Every step of every face, the most rewarding first; of each face they stay in order.
std::vector<Step> ordered_steps(const ControlMesh& mesh, const SubdivisionSettings& settings,
                                const FaceBudget& budget, std::span<const LevelErrors> errors) {
  const int first_step = first_step_levels(mesh, settings);
  const int deepest = deepest_affordable(mesh, budget.most);
  std::vector<Step> steps;
  std::mt19937 random(1);
  for (std::uint32_t f = 0; f < errors.size(); ++f) {
    const double area = area_of(mesh, f);
    double last_gain = std::numeric_limits<double>::max();
    double waited = 0.0;
    for (int depth = 0; depth < deepest; ++depth) {
      // A face that is first to be painted gets the uniform first step as well.
      const double before = at_level(errors[f], depth + first_step);
      const double after = at_level(errors[f], depth + 1 + first_step);
      double gain = before;
      switch (budget.goal) {
        case FaceBudget::Goal::kMeanSquare:
          gain = (before * before - after * after) * area / std::ldexp(3.0, 2 * depth);
          break;
        case FaceBudget::Goal::kGreatest:
          break;
        case FaceBudget::Goal::kRandom:
          waited += random_wait(random);
          gain = 1.0 / waited;
          break;
      }
      gain = std::min(gain, last_gain);
      if (!(gain > 0.0)) {
        break;
      }
      last_gain = gain;
      steps.push_back({static_cast<float>(gain), f, static_cast<std::uint8_t>(depth + 1)});
    }
  }
  std::ranges::stable_sort(steps, [](const Step& a, const Step& b) {
    return a.gain != b.gain ? a.gain > b.gain : a.depth < b.depth;
  });
  return steps;
}

FaceDepths depths_after(std::span<const Step> steps, std::size_t faces) {
  FaceDepths depths(faces);
  for (const Step& step : steps) {
    depths.set(step.face, step.depth);
  }
  return depths;
}

/// Faces that the first so many steps add, by themselves.
std::vector<double> nominal_costs(std::span<const Step> steps) {
  std::vector<double> sums(steps.size() + 1, 0.0);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    sums[i + 1] = sums[i] + std::ldexp(3.0, 2 * (steps[i].depth - 1));
  }
  return sums;
}

/// A number of steps and what they come to.
struct Probe {
  std::size_t steps = 0;
  std::uint64_t count = 0;
};

/// Where to look next between what fits and what does not.
std::size_t next_probe(const Probe& fits, const Probe& exceeds, std::uint64_t most,
                       std::span<const double> nominal, bool bisects) {
  const std::size_t first = fits.steps + 1;
  const std::size_t last = exceeds.steps - 1;
  if (bisects) {
    return first + (last - first) / 2;
  }
  const double share =
      static_cast<double>(most - fits.count) / static_cast<double>(exceeds.count - fits.count);
  const double wanted =
      nominal[fits.steps] + share * (nominal[exceeds.steps] - nominal[fits.steps]);
  const auto at = std::ranges::lower_bound(nominal, wanted) - nominal.begin();
  return std::clamp(static_cast<std::size_t>(at), first, last);
}

}  // namespace

Result<BudgetedDepths> depths_for_budget(const ControlMesh& mesh,
                                         const SubdivisionSettings& settings,
                                         const BudgetTask& task, Progress& progress) {
  if (Result<void> has_limit = check_has_limit(settings); !has_limit) {
    return tl::unexpected(std::move(has_limit.error()));
  }
  const FaceBudget& budget = task.budget;
  const Counter counter(mesh, settings, task, progress);
  const auto probe = [&](std::span<const Step> steps) {
    return counter.count(depths_after(steps, mesh.face_count()));
  };
  const Result<std::uint64_t> least = probe({});
  if (!least) {
    return tl::unexpected(least.error());
  }
  if (*least > budget.most) {
    return fail(ErrorKind::kOverBudget,
                fmt::format("Without any further painting there are {} {} already, more than the "
                            "budget of {}. Raise the budget or clear what is painted.",
                            *least, budget.unit == FaceBudget::Unit::kFaces ? "faces" : "triangles",
                            budget.most));
  }
  const Result<std::vector<LevelErrors>> errors = errors_for(mesh, settings, budget, progress);
  if (!errors) {
    return tl::unexpected(errors.error());
  }
  const std::vector<Step> steps = ordered_steps(mesh, settings, budget, *errors);
  const std::vector<double> nominal = nominal_costs(steps);
  // More steps than this cannot fit, whatever labels have in common.
  const double room = static_cast<double>(budget.most);
  const auto beyond =
      static_cast<std::size_t>(std::ranges::upper_bound(nominal, 2.0 * room) - nominal.begin());

  Probe fits{0, *least};
  std::optional<Probe> exceeds;
  for (int i = 0; i < kMostProbes; ++i) {
    std::size_t at = 0;
    if (!exceeds) {
      // Labels and legalisation add about as much again where the painting is in small pieces.
      at = std::min(steps.size(),
                    i == 0 ? static_cast<std::size_t>(
                                 std::ranges::lower_bound(nominal, 0.6 * room) - nominal.begin())
                           : std::max(beyond, 2 * fits.steps));
    } else if (exceeds->steps - fits.steps <= 1 ||
               budget.most - fits.count <= budget.most / kFineEnough) {
      break;
    } else {
      at = next_probe(fits, *exceeds, budget.most, nominal, i % 3 == 2);
    }
    if (at == fits.steps) {
      break;
    }
    const Result<std::uint64_t> count = probe(std::span(steps).first(at));
    if (!count) {
      return tl::unexpected(count.error());
    }
    if (*count <= budget.most) {
      fits = {at, *count};
    } else {
      exceeds = {at, *count};
    }
  }

  BudgetedDepths result;
  result.count = fits.count;
  result.chosen.depths = depths_after(std::span(steps).first(fits.steps), mesh.face_count());
  const int first_step = fits.steps > 0 ? first_step_levels(mesh, settings) : 0;
  for (std::size_t f = 0; f < errors->size(); ++f) {
    const float error = at_level((*errors)[f], result.chosen.depths[f] + first_step);
    result.chosen.expected_error = std::max<double>(result.chosen.expected_error, error);
  }
  return result;
}

}  // namespace limn
