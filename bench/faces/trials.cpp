// The distance is about proportional to a tolerance, and about inversely to a budget. So the next
// one to try follows from the last, and lies between those that were too coarse and fine enough.
#include "faces/trials.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <utility>

#include "limn/comparison/limit_distance.h"
#include "limn/contract.h"
#include "limn/painting/auto_depth/tolerance.h"
#include "limn/subdivision/face_errors.h"
#include "limn/subdivision/label_subdivision.h"

namespace limn::bench {
namespace {

/// Trials for one target.
constexpr int kMostTrials = 5;
/// A figure this near below its target, or a mesh with so few faces more than one that is too
/// coarse, is as good as the best.
constexpr double kNearEnough = 0.98;
constexpr double kFewEnough = 1.02;

Trial measure_depths(const Subject& subject, const FaceDepths& depths, double asked) {
  IgnoreProgress progress;
  const auto legal = legal_labels(*subject.mesh, depths.values(), subject.settings, progress);
  LIMN_EXPECTS(legal.has_value());
  Trial trial = measure(subject, legal->labels);
  trial.asked = asked;
  return trial;
}

/// By a tolerance in diagonals.
template <class Choose>
Trial try_depths(const Subject& subject, double tolerance, const Choose& choose) {
  IgnoreProgress progress;
  const double distance = tolerance * subject.mesh->bounds().diagonal();
  const std::span<const double> distances(&distance, 1);
  const Result<ChosenDepths> chosen = choose(*subject.mesh, subject.settings, distances, progress);
  LIMN_EXPECTS(chosen.has_value());
  return measure_depths(subject, chosen->depths, tolerance);
}

/// What is expected of a uniform mesh, in diagonals.
double expected_of_uniform(const Subject& subject, int level) {
  FaceErrorOptions options;
  options.corners = subject.settings.corners;
  options.points = subject.settings.points;
  IgnoreProgress progress;
  const auto errors = face_errors(*subject.mesh, options, progress);
  LIMN_EXPECTS(errors.has_value());
  double greatest = 0.0;
  for (const LevelErrors& of_face : *errors) {
    greatest = std::max<double>(greatest, at_level(of_face, level));
  }
  return greatest / subject.mesh->bounds().diagonal();
}

/// How coarse meshes may be: a tolerance, or the reciprocal of a budget.
struct Search {
  std::function<Trial(double coarseness)> try_one;
  std::function<double(const Trial&)> coarseness_of;
  double first = 0.0;  ///< Where to begin where nothing was tried before.
};

/// Tries coarsenesses until one is just fine enough. What was tried for other targets counts.
void approach(const Search& search, Figure figure, double target, std::vector<Trial>& trials) {
  std::optional<Trial> fine;  // The coarsest that is fine enough, and the finest that is not.
  std::optional<Trial> coarse;
  const auto learn = [&](const Trial& trial) {
    std::optional<Trial>& kept = figure_of(trial, figure) <= target ? fine : coarse;
    if (!kept || (&kept == &fine) == (search.coarseness_of(trial) > search.coarseness_of(*kept))) {
      kept = trial;
    }
  };
  std::ranges::for_each(trials, learn);
  for (int i = 0; i < kMostTrials; ++i) {
    if (fine && figure_of(*fine, figure) >= kNearEnough * target) {
      return;
    }
    if (fine && coarse &&
        static_cast<double>(fine->faces) <= kFewEnough * static_cast<double>(coarse->faces)) {
      return;
    }
    double at = search.first;
    if (fine && coarse) {
      // Straight between both, in logarithms.
      const double low = std::log(figure_of(*fine, figure));
      const double share = (std::log(target) - low) / (std::log(figure_of(*coarse, figure)) - low);
      const double from = std::log(search.coarseness_of(*fine));
      const double to = std::log(search.coarseness_of(*coarse));
      at = std::exp(from + (to - from) * std::clamp(0.97 * share, 0.15, 0.85));
    } else if (fine || coarse) {
      const Trial& known = fine ? *fine : *coarse;
      const double reached = std::max(figure_of(known, figure), 1e-3 * target);
      at = search.coarseness_of(known) *
           std::clamp(target / reached * (fine ? 1.01 : 0.97), 0.25, 4.0);
    }
    trials.push_back(search.try_one(at));
    learn(trials.back());
  }
}

}  // namespace

double figure_of(const Trial& trial, Figure figure) noexcept {
  return figure == Figure::kGreatest ? trial.greatest : trial.root_mean_square;
}

Trial measure(const Subject& subject, const VertexLabels& labels, std::vector<double>* of_faces) {
  IgnoreProgress progress;
  const Result<RefinedMesh> refined = refine(*subject.mesh, labels, subject.settings, {}, progress);
  LIMN_EXPECTS(refined.has_value());
  LimitDistanceLimits limits;
  limits.change = 0.02;
  limits.samples = std::size_t{1} << 22;
  const Result<LimitDistance> distance =
      measure_limit_distance(*subject.mesh, labels, subject.settings, *refined, progress, limits);
  LIMN_EXPECTS(distance.has_value());
  if (of_faces != nullptr) {
    of_faces->assign(subject.mesh->face_count(), 0.0);
    for (std::size_t f = 0; f < refined->face_count(); ++f) {
      double& most = (*of_faces)[refined->face_control_faces[f]];
      most = std::max<double>(most, distance->of_faces[f]);
    }
  }
  const double diagonal = subject.mesh->bounds().diagonal();
  return {0.0, refined->face_count(), distance->greatest() / diagonal,
          distance->root_mean_square() / diagonal};
}

Trial try_uniform(const Subject& subject, int level) {
  Trial trial = measure(
      subject, VertexLabels(subject.mesh->vertex_count(), static_cast<std::uint8_t>(level)));
  trial.asked = level;
  return trial;
}

Trial try_tolerance(const Subject& subject, double tolerance) {
  return try_depths(subject, tolerance, depths_for_tolerance);
}

Trial try_measured_tolerance(const Subject& subject, double tolerance) {
  return try_depths(subject, tolerance, depths_for_measured_tolerance);
}

Trial try_budget(const Subject& subject, std::uint64_t faces, FaceBudget::Goal goal) {
  IgnoreProgress progress;
  const BudgetTask task{{faces, FaceBudget::Unit::kFaces, goal}, {}};
  const auto chosen = depths_for_budget(*subject.mesh, subject.settings, task, progress);
  LIMN_EXPECTS(chosen.has_value());
  const Trial trial = measure_depths(subject, chosen->chosen.depths, static_cast<double>(faces));
  LIMN_EXPECTS(trial.faces == chosen->count && trial.faces <= faces);
  return trial;
}

void approach_by_tolerance(const Subject& subject, Figure figure, double target, int level,
                           std::vector<Trial>& trials) {
  // What is measured is some three quarters of a tolerance, the mean a fifth of the greatest.
  const Search search{[&](double tolerance) { return try_tolerance(subject, tolerance); },
                      [](const Trial& trial) { return trial.asked; },
                      target * (figure == Figure::kGreatest ? 1.35 : 6.0)};
  if (figure == Figure::kGreatest) {
    // Where errors are much alike, the tolerance that is just met by a uniform mesh.
    trials.push_back(search.try_one(1.0001 * expected_of_uniform(subject, level)));
  }
  approach(search, figure, target, trials);
}

void approach_by_budget(const Subject& subject, Figure figure, double target, std::uint64_t faces,
                        std::vector<Trial>& trials) {
  const FaceBudget::Goal goal =
      figure == Figure::kGreatest ? FaceBudget::Goal::kGreatest : FaceBudget::Goal::kMeanSquare;
  const auto least = static_cast<double>(subject.mesh->face_count());
  const Search search{
      [&](double coarseness) {
        const double most = std::max(least, 1.0 / coarseness);
        return try_budget(subject, static_cast<std::uint64_t>(std::llround(most)), goal);
      },
      [](const Trial& trial) { return 1.0 / trial.asked; }, 1.0 / static_cast<double>(faces)};
  approach(search, figure, target, trials);
}

const Trial* fewest_faces(const std::vector<Trial>& trials, Figure figure, double target) noexcept {
  const Trial* best = nullptr;
  for (const Trial& trial : trials) {
    if (figure_of(trial, figure) <= target && (best == nullptr || trial.faces < best->faces)) {
      best = &trial;
    }
  }
  return best;
}

}  // namespace limn::bench
