// All steps of all faces are put in order once, the most rewarding first; then how many of them the
// budget allows is searched for, with exact counts.
#include "limn/painting/auto_depth/budget.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
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
#include "painting/auto_depth/budget_search.h"
#include "painting/auto_depth/budget_steps.h"
#include "painting/auto_depth/first_step.h"

namespace limn {
namespace {

/// Shares of the greatest error at the level that an even painting could afford, below which errors
/// need not be told apart.
constexpr double kSmallestErrorThatCounts = 0.05;

/// What refining a painting gives.
class Counter {
 public:
  Counter(const ControlMesh& mesh, const SubdivisionSettings& settings, const BudgetTask& task,
          Progress& progress)
      : mesh_(&mesh), settings_(&settings), task_(&task), progress_(&progress) {}

  /// Of proposed depths, once they are finished.
  [[nodiscard]] Result<std::uint64_t> count(const FaceDepths& proposed) const {
    const FaceDepths depths = finished(proposed);
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

  /// About as many, without legalising and without what is demanded of finer faces.
  [[nodiscard]] double foretell(const FaceDepths& proposed) const {
    const VertexLabels labels = apply_non_quad_rule(
        *mesh_, vertex_labels(*mesh_, finished(proposed).values()), settings_->non_quads);
    const auto zeros = static_cast<double>(std::ranges::count(labels, std::uint8_t{0}));
    const PaintedCounts painted = count_painted(*mesh_, labels);
    // Mending an illegal quad takes faces around that were not painted, if there are any: about so
    // many where nearly none is painted, and where nearly all are.
    constexpr double kAmidUnpainted = 4.4;
    constexpr double kAmidPainted = 1.0;
    const double share = zeros / static_cast<double>(labels.size());
    const double faces = static_cast<double>(painted.faces) +
                         (kAmidPainted + (kAmidUnpainted - kAmidPainted) * share) *
                             static_cast<double>(painted.illegal_quads);
    return task_->budget.unit == FaceBudget::Unit::kFaces ? faces : 2.0 * faces;
  }

 private:
  [[nodiscard]] FaceDepths finished(const FaceDepths& proposed) const {
    return task_->finish ? task_->finish(proposed) : proposed;
  }
  [[nodiscard]] std::uint64_t count_labels(const VertexLabels& labels,
                                           const FineLabels* fine) const {
    const std::uint64_t faces = fine == nullptr
                                    ? count_painted(*mesh_, labels).faces
                                    : predict_refinement(*mesh_, labels, kAllLevels, fine).faces;
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

/// What a painting leaves of the errors, in the sense of the goal: as faces are refined at their
/// coarsest corner, before legalisation. Neighbours refine more of a face than it asks for itself.
double error_left(const ControlMesh& mesh, const FaceDepths& depths, int first_step,
                  FaceBudget::Goal goal, std::span<const LevelErrors> errors,
                  std::span<const double> areas) {
  const VertexLabels labels = vertex_labels(mesh, depths.values());
  const int more = depths.deepest() > 0 ? first_step : 0;
  double left = 0.0;
  for (std::size_t f = 0; f < errors.size(); ++f) {
    int level = kMaxDepth;
    for (const std::uint32_t v : mesh.face(f)) {
      level = std::min<int>(level, labels[v]);
    }
    const double error = at_level(errors[f], level + more);
    left = goal == FaceBudget::Goal::kMeanSquare ? left + error * error * areas[f]
                                                 : std::max(left, error);
  }
  return left;
}

/// Where a count takes as long as much of a refinement, a second one for the last half per cent of
/// a budget does not pay.
double part_unspent(const ControlMesh& mesh) {
  constexpr std::size_t kCountedAtOnce = 30'000;
  return mesh.face_count() > kCountedAtOnce ? 0.01 : 0.005;
}

/// The most of the steps that fit.
Result<BudgetSearch::Probe> spend(const ControlMesh& mesh, const Counter& counter,
                                  std::span<const BudgetStep> steps,
                                  const BudgetSearch::Room& room) {
  const auto depths = [&](std::size_t count) {
    return depths_after(steps.first(count), mesh.face_count());
  };
  BudgetSearch search(steps, room,
                      [&](std::size_t count) { return counter.foretell(depths(count)); });
  while (const std::optional<std::size_t> at = search.next()) {
    const Result<std::uint64_t> count = counter.count(depths(*at));
    if (!count) {
      return tl::unexpected(count.error());
    }
    search.learn({*at, *count});
  }
  return search.fits();
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
  const Result<std::uint64_t> least = counter.count(FaceDepths(mesh.face_count()));
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
  const int first_step = first_step_levels(mesh, settings);
  const std::vector<double> areas = face_areas(mesh);
  const BudgetGains gains{&mesh, budget, first_step, *errors, areas};
  std::vector<BudgetStep> steps = most_rewarding(gains, budget.most);
  const BudgetSearch::Room room{*least, budget.most, part_unspent(mesh)};
  Result<BudgetSearch::Probe> fits = spend(mesh, counter, steps, room);
  // Where steps for all of the budget fit, what is painted already had a part in their faces, or
  // there are no more.
  if (fits && fits->steps == steps.size()) {
    std::vector<BudgetStep> every =
        most_rewarding(gains, std::numeric_limits<std::uint64_t>::max());
    if (every.size() > steps.size()) {
      steps = std::move(every);
      fits = spend(mesh, counter, steps, room);
    }
  }
  if (!fits) {
    return tl::unexpected(fits.error());
  }

  BudgetedDepths result;
  result.count = fits->count;
  result.chosen.depths = depths_after(std::span(steps).first(fits->steps), mesh.face_count());
  // Where all faces need about the same and the budget is about an even painting's, that has no
  // seams between levels to pay for.
  const FaceDepths even(mesh.face_count(), even_depth(mesh, budget.most));
  const auto error_left = [&](const FaceDepths& depths) {
    return limn::error_left(mesh, depths, first_step, budget.goal, *errors, areas);
  };
  if (budget.goal != FaceBudget::Goal::kRandom && even.deepest() > 0 &&
      error_left(even) < error_left(result.chosen.depths)) {
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
