// All steps of all faces are sorted once, the most rewarding first; by classes of gains that differ
// by less than a hundredth, which is linear. How many of them the budget allows is found like the
// zero of a function that is nearly known: nominal costs foretell where to probe, counting tells.
#include "limn/painting/auto_depth/budget.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
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
constexpr double kSmallestErrorThatCounts = 0.05;

/// Counts are probed at most so often: by then the place is known to a step, or what is left of the
/// budget is less than this part of it.
constexpr int kMostProbes = 24;
constexpr std::uint64_t kFineEnough = 200;

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
    if (task_->demands == nullptr && depths.deepest() == 0) {
      return count_labels(VertexLabels(mesh_->vertex_count(), 0), nullptr);
    }
    const Result<LabelsWithDemands> labels = legal_labels(
        *mesh_, depths.values(), task_->demands != nullptr ? *task_->demands : FineDemands(),
        *settings_, *progress_);
    if (!labels) {
      return tl::unexpected(labels.error());
    }
    return count_labels(labels->legal.labels, labels->fine.get());
  }

 private:
  [[nodiscard]] std::uint64_t count_labels(const VertexLabels& labels,
                                           const FineLabels* fine) const {
    const std::uint64_t faces = predict_refinement(*mesh_, labels, kAllLevels, fine).faces;
    return task_->budget.unit == FaceBudget::Unit::kFaces ? faces : triangles(faces, labels);
  }
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

/// About the greatest error of unrefined faces: vertices stand off the mean of their neighbours by
/// about twice as much.
double rough_error(const ControlMesh& mesh) {
  const FlatTopology& topology = mesh.topology();
  std::vector<glm::dvec3> sums(mesh.vertex_count(), glm::dvec3(0.0));
  std::vector<std::uint32_t> counts(mesh.vertex_count(), 0);
  for (const auto& [a, b] : topology.edge_vertices) {
    sums[a] += mesh.positions()[b];
    sums[b] += mesh.positions()[a];
    ++counts[a];
    ++counts[b];
  }
  double greatest = 0.0;
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const glm::dvec3 off = mesh.positions()[v] - sums[v] / static_cast<double>(counts[v]);
    greatest = std::max(greatest, glm::dot(off, off));
  }
  return 0.5 * std::sqrt(greatest);
}

Result<std::vector<LevelErrors>> errors_for(const ControlMesh& mesh,
                                            const SubdivisionSettings& settings,
                                            const FaceBudget& budget, Progress& progress) {
  FaceErrorOptions options;
  options.corners = settings.corners;
  options.points = settings.points;
  const int first_step = first_step_levels(mesh, settings);
  options.deepest = deepest_affordable(mesh, budget.most) + first_step;
  options.enough = kSmallestErrorThatCounts *
                   std::ldexp(rough_error(mesh), -2 * (even_depth(mesh, budget.most) + first_step));
  return face_errors(mesh, options, progress);
}

/// How long a face waits until it is hit once more, where all are hit equally often.
double random_wait(std::mt19937& random) {
  return -std::log((static_cast<double>(random()) + 1.0) / 4294967296.0) + 1e-9;
}

/// The class of a positive gain: its exponent and seven more bits. Greater gains come first.
std::size_t class_of(float gain) noexcept {
  return 0x7FFFU - (std::bit_cast<std::uint32_t>(gain) >> 16U);
}

/// By classes, the order within each left as it is.
std::vector<Step> sorted_by_class(const std::vector<Step>& steps) {
  std::vector<std::uint32_t> firsts(0x8001, 0);
  for (const Step& step : steps) {
    ++firsts[class_of(step.gain) + 1];
  }
  std::partial_sum(firsts.begin(), firsts.end(), firsts.begin());
  std::vector<Step> sorted(steps.size());
  for (const Step& step : steps) {
    sorted[firsts[class_of(step.gain)]++] = step;
  }
  return sorted;
}

/// Every step of every face, the most rewarding first; of each face they stay in order.
std::vector<Step> ordered_steps(const ControlMesh& mesh, const SubdivisionSettings& settings,
                                const FaceBudget& budget, std::span<const LevelErrors> errors) {
  const int first_step = first_step_levels(mesh, settings);
  const int deepest = deepest_affordable(mesh, budget.most);
  std::vector<Step> steps;
  steps.reserve(3 * errors.size());
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
  return sorted_by_class(steps);
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

/// What a painting leaves of the errors, in the sense of the goal: as faces are refined at their
/// coarsest corner, before legalisation. Neighbours refine more of a face than it asks for itself.
double error_left(const ControlMesh& mesh, const FaceDepths& depths, int first_step,
                  FaceBudget::Goal goal, std::span<const LevelErrors> errors) {
  const VertexLabels labels = vertex_labels(mesh, depths.values());
  const int more = depths.deepest() > 0 ? first_step : 0;
  double left = 0.0;
  for (std::size_t f = 0; f < errors.size(); ++f) {
    int level = kMaxDepth;
    for (const std::uint32_t v : mesh.face(f)) {
      level = std::min<int>(level, labels[v]);
    }
    const double error = at_level(errors[f], level + more);
    left = goal == FaceBudget::Goal::kMeanSquare ? left + error * error * area_of(mesh, f)
                                                 : std::max(left, error);
  }
  return left;
}

FaceDepths even_depths(std::size_t faces, int depth) {
  FaceDepths depths(faces);
  for (std::size_t f = 0; f < faces; ++f) {
    depths.set(f, depth);
  }
  return depths;
}

/// Looks for how many steps fit.
class Prober {
 public:
  /// `nominal` are the sums of costs; with no step it is `least`.
  Prober(std::span<const double> nominal, std::uint64_t least, std::uint64_t most)
      : nominal_(nominal), least_(least), most_(most), fits_{0, least} {}

  [[nodiscard]] const Probe& fits() const noexcept { return fits_; }
  /// Where to look next; nothing where it is known, or well enough.
  [[nodiscard]] std::optional<std::size_t> next();
  void learn(const Probe& probe) {
    before_ = std::exchange(last_, probe);
    if (probe.count <= most_) {
      fits_ = probe;
    } else {
      exceeds_ = probe;
    }
  }

 private:
  /// The sum that is expected to give a little less than the budget.
  [[nodiscard]] double expected() const;

  std::span<const double> nominal_;
  std::uint64_t least_;
  std::uint64_t most_;
  Probe fits_;
  std::optional<Probe> exceeds_;
  Probe last_;  ///< The last probe and the one before; no steps: none.
  Probe before_;
  int probes_ = 0;
};

std::optional<std::size_t> Prober::next() {
  const std::size_t end = exceeds_ ? exceeds_->steps : nominal_.size();
  if (probes_ == kMostProbes || end - fits_.steps <= 1 ||
      most_ - fits_.count <= most_ / kFineEnough) {
    return std::nullopt;
  }
  ++probes_;
  const double low = nominal_[fits_.steps];
  double wanted = expected();
  if (exceeds_ && probes_ > 3 && (probes_ % 2 == 0 || wanted <= low)) {
    wanted = 0.5 * (low + nominal_[exceeds_->steps]);
  }
  const auto at = std::ranges::lower_bound(nominal_, wanted) - nominal_.begin();
  return std::clamp(static_cast<std::size_t>(at), fits_.steps + 1, end - 1);
}

/// What labels and legalisation add makes counts rise with a power of the nominal costs, a little
/// less than 1 at first.
double Prober::expected() const {
  const double room = static_cast<double>(most_ - least_) -
                      0.5 * static_cast<double>(most_) / static_cast<double>(kFineEnough);
  if (last_.steps == 0) {
    return 0.75 * room;
  }
  const auto risen = [this](const Probe& probe) {
    return std::max(1.0, static_cast<double>(probe.count) - static_cast<double>(least_));
  };
  double power = 0.9;
  if (before_.steps != 0 && before_.steps != last_.steps) {
    power = std::log(risen(last_) / risen(before_)) /
            std::log(nominal_[last_.steps] / nominal_[before_.steps]);
    power = std::clamp(power, 0.4, 2.0);
  }
  return nominal_[last_.steps] * std::pow(std::max(room, 1.0) / risen(last_), 1.0 / power);
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
  Prober prober(nominal, *least, budget.most);
  while (const std::optional<std::size_t> at = prober.next()) {
    const Result<std::uint64_t> count = probe(std::span(steps).first(*at));
    if (!count) {
      return tl::unexpected(count.error());
    }
    prober.learn({*at, *count});
  }

  const Probe& fits = prober.fits();
  const int first_step = first_step_levels(mesh, settings);
  BudgetedDepths result;
  result.count = fits.count;
  result.chosen.depths = depths_after(std::span(steps).first(fits.steps), mesh.face_count());
  // Where all faces need about the same and the budget is about an even painting's, that has no
  // seams between levels to pay for.
  const FaceDepths even = even_depths(mesh.face_count(), even_depth(mesh, budget.most));
  if (budget.goal != FaceBudget::Goal::kRandom && even.deepest() > 0 &&
      error_left(mesh, even, first_step, budget.goal, *errors) <
          error_left(mesh, result.chosen.depths, first_step, budget.goal, *errors)) {
    const Result<std::uint64_t> count = counter.count(even);
    if (!count) {
      return tl::unexpected(count.error());
    }
    if (*count <= budget.most) {
      result = {{even, 0.0, 0}, *count};
    }
  }
  const int more = result.chosen.depths.deepest() > 0 ? first_step : 0;
  for (std::size_t f = 0; f < errors->size(); ++f) {
    const float error = at_level((*errors)[f], result.chosen.depths[f] + more);
    result.chosen.expected_error = std::max<double>(result.chosen.expected_error, error);
  }
  return result;
}

}  // namespace limn
