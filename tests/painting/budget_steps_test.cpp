#include "painting/auto_depth/budget_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace limn {
namespace {

constexpr std::uint64_t kEverything = std::numeric_limits<std::uint64_t>::max();

/// Errors of very different sizes, a few large ones side by side.
std::vector<LevelErrors> random_errors(std::size_t faces) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> power(-5.0, 0.0);
  std::vector<LevelErrors> errors(faces);
  for (std::size_t f = 0; f < faces; ++f) {
    const double error = f % 1000 < 20 ? 3.0 : std::pow(10.0, power(random));
    for (std::size_t level = 0; level < kErrorLevels; ++level) {
      errors[f][level] = static_cast<float>(std::ldexp(error, -2 * static_cast<int>(level)));
    }
  }
  return errors;
}

class BudgetSteps : public testing::TestWithParam<FaceBudget::Goal> {
 protected:
  BudgetSteps() : mesh_(test::control_mesh(test::grid_soup(100, 90))) {
    errors_ = random_errors(mesh_->face_count());
    areas_ = face_areas(*mesh_);
  }
  [[nodiscard]] BudgetGains gains(std::uint64_t most) const {
    return {mesh_.get(), {most, FaceBudget::Unit::kFaces, GetParam()}, 0, errors_, areas_};
  }

  test::MeshPointer mesh_;
  std::vector<LevelErrors> errors_;
  std::vector<double> areas_;
};

TEST_P(BudgetSteps, OfAFaceAreInOrder) {
  std::vector<int> depths(mesh_->face_count(), 0);
  for (const BudgetStep& step : most_rewarding(gains(1'000'000), kEverything)) {
    EXPECT_EQ(step.depth, depths[step.face] + 1);
    depths[step.face] = step.depth;
  }
  EXPECT_GT(*std::ranges::max_element(depths), 3);
}

TEST_P(BudgetSteps, BeginWithTheMostRewarding) {
  float least = std::numeric_limits<float>::max();
  for (const BudgetStep& step : most_rewarding(gains(1'000'000), kEverything)) {
    EXPECT_LE(step.gain, 1.01F * least);
    least = std::min(least, step.gain);
  }
}

TEST_P(BudgetSteps, UpToACostAreTheFirstOfAll) {
  for (const std::uint64_t cost : {100U, 10'000U, 90'000U}) {
    const auto every = most_rewarding(gains(100'000), kEverything);
    const auto some = most_rewarding(gains(100'000), cost);
    ASSERT_LT(some.size(), every.size());
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < some.size(); ++i) {
      EXPECT_EQ(some[i].face, every[i].face) << i;
      EXPECT_EQ(some[i].depth, every[i].depth) << i;
      sum += cost_of(some[i]);
    }
    EXPECT_GE(sum, cost);
  }
}

TEST_P(BudgetSteps, AreTheSameWhereTheFacesLookedAtAreNotLikeTheOthers) {
  // Every sixteenth face promises more than all the others have.
  for (std::size_t f = 0; f < errors_.size(); ++f) {
    errors_[f].fill(0.0F);
    errors_[f][0] = f % 16 == 0 ? 1.0F : 1e-3F;
  }
  const auto every = most_rewarding(gains(100'000), kEverything);
  const auto some = most_rewarding(gains(100'000), 5'000);
  ASSERT_LE(some.size(), every.size());
  EXPECT_GT(some.size(), errors_.size() / 16);
  for (std::size_t i = 0; i < some.size(); ++i) {
    EXPECT_EQ(some[i].face, every[i].face) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Goals, BudgetSteps,
                         testing::Values(FaceBudget::Goal::kMeanSquare, FaceBudget::Goal::kGreatest,
                                         FaceBudget::Goal::kRandom));

TEST(FaceAreas, AreThoseOfPlanarFacesOfAnyShape) {
  PolygonSoup soup;
  soup.positions = {{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {1, 1, 0}, {0, 3, 0}, {2, 0, 4}, {2, 3, 4}};
  soup.add_face(std::array{0U, 1U, 2U, 3U, 4U});  // Not convex.
  soup.add_face(std::array{2U, 1U, 5U, 6U});
  const std::vector<double> areas = face_areas(*test::control_mesh(soup));
  ASSERT_EQ(areas.size(), 2U);
  EXPECT_DOUBLE_EQ(areas[0], 4.0);
  EXPECT_DOUBLE_EQ(areas[1], 12.0);
}

}  // namespace
}  // namespace limn
