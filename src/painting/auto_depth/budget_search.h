#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "painting/auto_depth/budget_steps.h"

// How far a budget lasts. Internal to this folder.
namespace limn {

/// Looks for the most of an order of steps that fit a budget, like for the zero of a function that
/// is nearly known. What labels alone make of a mesh is foretold quickly; what legalisation adds to
/// that is about what it added the last time it was counted. Counts need not quite grow with the
/// steps: legalisation is a heuristic, and a step more may come out with fewer faces.
class BudgetSearch {
 public:
  /// A number of steps and the faces they come to.
  struct Probe {
    std::size_t steps = 0;
    std::uint64_t count = 0;
  };
  /// About how many faces the first so many steps come to.
  using Forecast = std::function<double(std::size_t steps)>;

  /// What there is to spend.
  struct Room {
    std::uint64_t least = 0;  ///< Faces with no step, not above
    std::uint64_t most = 0;   ///< the budget.
    double unspent = 0.005;   ///< The part of it that may be left.
  };

  /// Counts are asked for at most so often: by then the place is known to a step, or no more is
  /// left of the budget than may be.
  static constexpr int kMostProbes = 24;

  BudgetSearch(std::span<const BudgetStep> steps, const Room& room, Forecast forecast);

  /// The best so far.
  [[nodiscard]] const Probe& fits() const noexcept { return fits_; }
  /// How many steps to count next; nothing where it is known, or well enough.
  [[nodiscard]] std::optional<std::size_t> next();
  void learn(const Probe& probe);

 private:
  /// A number of steps and the faces that are foretold.
  struct Foretold {
    std::size_t steps = 0;
    double faces = 0.0;
  };

  [[nodiscard]] double foretell(std::size_t steps);
  /// About so many are foretold to come to `faces`.
  [[nodiscard]] std::size_t steps_to(double faces);
  /// What these cost by themselves, as far as what has been foretold tells.
  [[nodiscard]] double cost_to(double faces) const;
  [[nodiscard]] std::size_t step_at(double cost) const;

  std::vector<double> costs_;  ///< Of the first so many steps, each by itself.
  Room room_;
  double may_be_left_;  ///< Faces.
  Forecast forecast_;
  std::vector<Foretold> foretold_;  ///< By steps; faces never fall.
  double legalised_ = 1.0;          ///< Faces really added for each that was foretold.
  Probe fits_;
  std::optional<Probe> exceeds_;
  int probes_ = 0;
};

}  // namespace limn
