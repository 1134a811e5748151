// The search against counts and forecasts that are made up, good ones and bad ones.
#include "painting/auto_depth/budget_search.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace limn {
namespace {

constexpr std::size_t kSteps = 5000;
constexpr std::uint64_t kLeast = 2000;
constexpr double kUnspent = 0.005;

std::vector<BudgetStep> steps_of_growing_cost() {
  std::vector<BudgetStep> steps;
  for (std::size_t i = 0; i < kSteps; ++i) {
    steps.push_back(
        {1.0F, static_cast<std::uint32_t>(i), static_cast<std::uint8_t>(1 + 3 * i / kSteps)});
  }
  return steps;
}

/// As labels and legalisation do it: much for the first steps, in leaps, and not quite growing.
std::uint64_t real_count(const std::vector<BudgetStep>& steps, std::size_t count) {
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    sum += static_cast<double>(cost_of(steps[i]));
  }
  const double noise = count == 0 ? 0.0 : 12.0 * std::sin(7.0 * static_cast<double>(count));
  return kLeast + static_cast<std::uint64_t>(std::max(0.0, 9.0 * std::pow(sum, 0.85) + noise));
}

struct Found {
  BudgetSearch::Probe fits;
  int counts = 0;
};

Found search(std::uint64_t most, const BudgetSearch::Forecast& forecast) {
  const std::vector<BudgetStep> steps = steps_of_growing_cost();
  BudgetSearch search(steps, {kLeast, most, kUnspent}, forecast);
  Found found;
  while (const auto at = search.next()) {
    EXPECT_GT(*at, 0U);
    EXPECT_LE(*at, steps.size());
    search.learn({*at, real_count(steps, *at)});
    ++found.counts;
  }
  found.fits = search.fits();
  EXPECT_EQ(found.fits.count, found.fits.steps == 0 ? kLeast : real_count(steps, found.fits.steps));
  return found;
}

double foretold_well(std::size_t count) {
  static const std::vector<BudgetStep> steps = steps_of_growing_cost();
  return static_cast<double>(real_count(steps, count));
}

class BudgetSearchOf : public testing::TestWithParam<std::uint64_t> {};

TEST_P(BudgetSearchOf, NeedsOneCountWhereForecastsAreRight) {
  const Found found = search(GetParam(), foretold_well);
  EXPECT_LE(found.fits.count, GetParam());
  EXPECT_GE(static_cast<double>(found.fits.count),
            (1.0 - kUnspent) * static_cast<double>(GetParam()));
  EXPECT_LE(found.counts, 2);
}

TEST_P(BudgetSearchOf, NeedsFewCountsWhereForecastsAreTooLowByAThird) {
  const Found found = search(GetParam(), [](std::size_t count) {
    return kLeast + (foretold_well(count) - kLeast) * 0.67;
  });
  EXPECT_LE(found.fits.count, GetParam());
  EXPECT_GE(static_cast<double>(found.fits.count),
            (1.0 - kUnspent) * static_cast<double>(GetParam()));
  EXPECT_LE(found.counts, 4);
}

TEST_P(BudgetSearchOf, FindsItWhateverIsForetold) {
  const std::vector<BudgetSearch::Forecast> forecasts{
      [](std::size_t) { return 0.0; },
      [](std::size_t) { return 1e9; },
      [](std::size_t count) { return static_cast<double>(count) * 1e-3; },
      [](std::size_t count) { return 1e6 * std::sqrt(static_cast<double>(count)); },
      [](std::size_t count) { return -static_cast<double>(count); },
      [](std::size_t count) { return count < kSteps / 2 ? 0.0 : 1e6; },
      [](std::size_t count) { return static_cast<double>(count * 7919 % 10007); }};
  for (std::size_t i = 0; i < forecasts.size(); ++i) {
    const Found found = search(GetParam(), forecasts[i]);
    EXPECT_LE(found.fits.count, GetParam()) << i;
    EXPECT_GE(found.fits.count, GetParam() - GetParam() / 50) << i;
    EXPECT_LE(found.counts, BudgetSearch::kMostProbes) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Budgets, BudgetSearchOf, testing::Values(4000, 11000, 60000, 150000));

TEST(BudgetSearch, TakesAllStepsWhereAllFit) {
  const Found found = search(100'000'000, foretold_well);
  EXPECT_EQ(found.fits.steps, kSteps);
}

TEST(BudgetSearch, TakesNoneWhereTheFirstIsTooMuch) {
  const Found found = search(kLeast + 1, foretold_well);
  EXPECT_EQ(found.fits.steps, 0U);
  EXPECT_EQ(found.fits.count, kLeast);
}

TEST(BudgetSearch, CountsNothingWhereThereIsNoStep) {
  BudgetSearch search({}, {kLeast, 10 * kLeast, kUnspent}, foretold_well);
  EXPECT_FALSE(search.next());
}

}  // namespace
}  // namespace limn
