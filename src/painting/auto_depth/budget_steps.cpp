#include "painting/auto_depth/budget_steps.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include <glm/geometric.hpp>

namespace limn {
namespace {

/// How long a face waits until it is hit once more, where all are hit equally often.
double random_wait(std::mt19937& random) {
  return -std::log((static_cast<double>(random()) + 1.0) / 4294967296.0) + 1e-9;
}

/// The class of a gain that is not negative: its exponent and seven more bits. Greater gains come
/// first.
std::size_t class_of(float gain) noexcept {
  return 0x7FFFU - (std::bit_cast<std::uint32_t>(gain) >> 16U);
}
constexpr std::size_t kClasses = 0x8000;

/// Calls `visit(step)` for the steps of every `stride`th face, in order of faces and depths, none
/// of a face more rewarding than the one before; it returns whether to go on with that face.
template <class Visit>
void for_each_step(const BudgetGains& gains, std::uint32_t stride, const Visit& visit) {
  const int deepest = deepest_affordable(*gains.mesh, gains.budget.most);
  std::mt19937 random(1);
  for (std::uint32_t f = 0; f < gains.errors.size(); f += stride) {
    const LevelErrors& errors = gains.errors[f];
    double area = gains.areas[f] / 3.0;  // For each face that is added.
    double last_gain = std::numeric_limits<double>::max();
    double waited = 0.0;
    for (int depth = 0; depth < deepest; ++depth, area *= 0.25) {
      const double before = at_level(errors, depth + gains.first_step);
      const double after = at_level(errors, depth + 1 + gains.first_step);
      double gain = before;
      switch (gains.budget.goal) {
        case FaceBudget::Goal::kMeanSquare:
          gain = (before * before - after * after) * area;
          break;
        case FaceBudget::Goal::kGreatest:
          break;
        case FaceBudget::Goal::kRandom:
          waited += random_wait(random);
          gain = 1.0 / waited;
          break;
      }
      gain = std::min(gain, last_gain);
      last_gain = gain;
      const auto shown = static_cast<float>(gain);
      if (!(gain > 0.0) || !visit(BudgetStep{shown, f, static_cast<std::uint8_t>(depth + 1)})) {
        break;
      }
    }
  }
}

/// How many classes it takes to cost so much.
class ClassCosts {
 public:
  void add(const BudgetStep& step, std::uint64_t times) {
    costs_[class_of(step.gain)] += times * cost_of(step);
  }
  [[nodiscard]] std::size_t classes_within(std::uint64_t cost) const {
    std::size_t count = 0;
    for (std::uint64_t sum = 0; count < kClasses && sum < cost; ++count) {
      sum += costs_[count];
    }
    return count;
  }

 private:
  std::vector<std::uint64_t> costs_ = std::vector<std::uint64_t>(kClasses, 0);
};

std::vector<BudgetStep> steps_within(const BudgetGains& gains, std::size_t classes) {
  std::vector<BudgetStep> steps;
  for_each_step(gains, 1, [&](const BudgetStep& step) {
    const bool is_within = class_of(step.gain) < classes;
    if (is_within) {
      steps.push_back(step);
    }
    return is_within;
  });
  return steps;
}

/// About how many classes are needed, or some more: by one face in so many.
std::size_t foreseen_classes(const BudgetGains& gains, std::uint64_t cost) {
  constexpr std::uint32_t kStride = 16;
  constexpr std::size_t kFewFaces = 4096;
  constexpr std::uint64_t kMargin = 2;
  if (gains.errors.size() < kFewFaces || gains.budget.goal == FaceBudget::Goal::kRandom ||
      cost > std::numeric_limits<std::uint64_t>::max() / kMargin) {
    return kClasses;
  }
  ClassCosts costs;
  for_each_step(gains, kStride, [&](const BudgetStep& step) {
    costs.add(step, kStride);
    return true;
  });
  return costs.classes_within(kMargin * cost);
}

}  // namespace

int deepest_affordable(const ControlMesh& mesh, std::uint64_t most) noexcept {
  int depth = 0;
  while (depth < kMaxDepth && mesh.face_count() + (std::uint64_t{4} << (2 * depth)) <= most) {
    ++depth;
  }
  return depth;
}

std::vector<double> face_areas(const ControlMesh& mesh) {
  std::vector<double> areas(mesh.face_count());
  for (std::size_t f = 0; f < areas.size(); ++f) {
    const auto corners = mesh.face(f);
    const glm::dvec3 origin = mesh.positions()[corners[0]];
    glm::dvec3 sum(0.0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      sum += glm::cross(mesh.positions()[corners[i]] - origin,
                        mesh.positions()[corners[i + 1]] - origin);
    }
    areas[f] = 0.5 * glm::length(sum);
  }
  return areas;
}

std::vector<BudgetStep> most_rewarding(const BudgetGains& gains, std::uint64_t cost) {
  std::size_t classes = foreseen_classes(gains, cost);
  std::vector<BudgetStep> steps = steps_within(gains, classes);
  const auto costs_of = [](const std::vector<BudgetStep>& all) {
    ClassCosts costs;
    for (const BudgetStep& step : all) {
      costs.add(step, 1);
    }
    return costs;
  };
  ClassCosts costs = costs_of(steps);
  if (classes < kClasses && costs.classes_within(cost) >= classes) {
    classes = kClasses;  // The faces that were looked at were not like the others.
    steps = steps_within(gains, classes);
    costs = costs_of(steps);
  }
  classes = costs.classes_within(cost);

  std::vector<std::uint32_t> firsts(classes + 1, 0);
  for (const BudgetStep& step : steps) {
    if (class_of(step.gain) < classes) {
      ++firsts[class_of(step.gain) + 1];
    }
  }
  std::partial_sum(firsts.begin(), firsts.end(), firsts.begin());
  std::vector<BudgetStep> sorted(firsts.back());
  for (const BudgetStep& step : steps) {
    if (class_of(step.gain) < classes) {
      sorted[firsts[class_of(step.gain)]++] = step;
    }
  }
  return sorted;
}

FaceDepths depths_after(std::span<const BudgetStep> steps, std::size_t faces) {
  FaceDepths depths(faces);
  for (const BudgetStep& step : steps) {
    depths.set(step.face, step.depth);
  }
  return depths;
}

}  // namespace limn
