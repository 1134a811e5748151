#include "painting/auto_depth/budget_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace limn {

BudgetSearch::BudgetSearch(std::span<const BudgetStep> steps, const Room& room, Forecast forecast)
    : costs_(steps.size() + 1, 0.0),
      room_(room),
      may_be_left_(room.unspent * static_cast<double>(room.most)),
      forecast_(std::move(forecast)),
      fits_{0, room.least} {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    costs_[i + 1] = costs_[i] + static_cast<double>(cost_of(steps[i]));
  }
}

std::optional<std::size_t> BudgetSearch::next() {
  constexpr int kForetoldProbes = 6;
  const std::size_t end = exceeds_ ? exceeds_->steps : costs_.size();
  if (probes_ == kMostProbes || end - fits_.steps <= 1 ||
      static_cast<double>(room_.most - fits_.count) <= may_be_left_) {
    return std::nullopt;
  }
  ++probes_;
  std::size_t steps = 0;
  if (probes_ > kForetoldProbes) {  // Forecasts are of no use here.
    steps = step_at(0.5 * (costs_[fits_.steps] + costs_[end - 1]));
  } else {
    // In the middle of where it may end.
    const double aim = static_cast<double>(room_.most - room_.least) - 0.5 * may_be_left_;
    steps = steps_to(foretell(0) + std::max(0.0, aim) / legalised_);
  }
  return std::clamp(steps, fits_.steps + 1, end - 1);
}

void BudgetSearch::learn(const Probe& probe) {
  const double foretold = foretell(probe.steps) - foretell(0);
  const auto added = static_cast<double>(probe.count) - static_cast<double>(room_.least);
  if (foretold > 0.0 && added > 0.0) {
    legalised_ = added / foretold;
  }
  if (probe.count <= room_.most) {
    fits_ = probe;
  } else {
    exceeds_ = probe;
  }
}

double BudgetSearch::foretell(std::size_t steps) {
  const auto at = std::ranges::lower_bound(foretold_, steps, {}, &Foretold::steps);
  if (at != foretold_.end() && at->steps == steps) {
    return at->faces;
  }
  double faces = forecast_(steps);
  if (at != foretold_.begin()) {
    faces = std::max(faces, (at - 1)->faces);
  }
  if (at != foretold_.end()) {
    faces = std::min(faces, at->faces);
  }
  return foretold_.insert(at, {steps, faces})->faces;
}

std::size_t BudgetSearch::step_at(double cost) const {
  return static_cast<std::size_t>(std::ranges::lower_bound(costs_, cost) - costs_.begin());
}

double BudgetSearch::cost_to(double faces) const {
  constexpr double kOfNothing = 0.8;  // A cost of so much by itself, for each face there is more.
  if (foretold_.size() == 1) {
    return kOfNothing * (faces - foretold_.front().faces);
  }
  // On the line through the nearer of the two points around and the next on its other side.
  const auto around = std::ranges::upper_bound(foretold_, faces, {}, &Foretold::faces);
  const auto at =
      std::clamp<std::ptrdiff_t>(around - foretold_.begin(), 1, std::ssize(foretold_) - 1);
  auto a = foretold_.begin() + at - 1;
  auto b = a + 1;
  if (b->faces - faces > faces - a->faces && at > 1) {
    --b;
    --a;
  } else if (b->faces - faces <= faces - a->faces && b + 1 != foretold_.end()) {
    ++a;
    ++b;
  }
  const double added = b->faces - a->faces;
  return added > 0.0 ? costs_[a->steps] +
                           (costs_[b->steps] - costs_[a->steps]) * ((faces - a->faces) / added)
                     : costs_.back();
}

std::size_t BudgetSearch::steps_to(double faces) {
  constexpr int kMostForecasts = 32;
  const double near_enough = 0.1 * may_be_left_;
  const std::size_t last = costs_.size() - 1;
  (void)foretell(0);
  for (int i = 0; i < kMostForecasts; ++i) {
    const auto above = std::ranges::upper_bound(foretold_, faces, {}, &Foretold::faces);
    if (above == foretold_.begin()) {
      return 0;
    }
    const Foretold low = *(above - 1);
    const std::size_t end = above == foretold_.end() ? last + 1 : above->steps;
    if (faces - low.faces <= near_enough || end - low.steps <= 1) {
      return low.steps;
    }
    std::size_t steps = step_at(cost_to(faces - 0.5 * near_enough));
    if (above != foretold_.end() && (steps <= low.steps || steps >= end)) {
      steps = step_at(0.5 * (costs_[low.steps] + costs_[above->steps]));
    }
    (void)foretell(std::clamp(steps, low.steps + 1, end - 1));
  }
  return (std::ranges::upper_bound(foretold_, faces, {}, &Foretold::faces) - 1)->steps;
}

}  // namespace limn
