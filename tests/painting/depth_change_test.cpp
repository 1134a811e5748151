#include "limn/painting/depth_change.h"

#include <climits>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limn {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

FaceDepths depths_of(std::initializer_list<int> values) {
  FaceDepths depths(values.size());
  std::size_t face = 0;
  for (const int value : values) {
    depths.set(face++, value);
  }
  return depths;
}

TEST(DepthChange, AddsAndSets) {
  EXPECT_EQ(DepthChange::add(1)(3), 4);
  EXPECT_EQ(DepthChange::add(-1)(3), 2);
  EXPECT_EQ(DepthChange::set(5)(3), 5);
  EXPECT_EQ(DepthChange::set(0)(3), 0);
}

TEST(DepthChange, LoweringStopsAtZero) {
  EXPECT_EQ(DepthChange::add(-1)(0), 0);
  EXPECT_EQ(DepthChange::add(-5)(2), 0);
}

TEST(DepthChange, RaisingStopsAtTheGreatestDepth) {
  EXPECT_EQ(DepthChange::add(1)(kMaxDepth), kMaxDepth);
  EXPECT_EQ(DepthChange::add(7)(kMaxDepth - 2), kMaxDepth);
}

TEST(DepthChange, WildAmountsNeitherOverflowNorLeaveTheRange) {
  EXPECT_EQ(DepthChange::add(INT_MAX)(kMaxDepth), kMaxDepth);
  EXPECT_EQ(DepthChange::add(INT_MIN)(0), 0);
  EXPECT_EQ(DepthChange::set(INT_MAX)(0), kMaxDepth);
  EXPECT_EQ(DepthChange::set(INT_MIN)(5), 0);
}

TEST(FaceDepths, StartUnpainted) {
  const FaceDepths depths(4);
  EXPECT_EQ(depths.size(), 4U);
  EXPECT_EQ(depths.deepest(), 0);
  EXPECT_EQ(depths.histogram()[0], 4U);
  EXPECT_EQ(FaceDepths().deepest(), 0);
}

TEST(FaceDepths, HistogramCountsEveryDepth) {
  const FaceDepths depths = depths_of({0, 3, 3, 10, 1, 0, 3});
  EXPECT_THAT(depths.histogram(), ElementsAre(2, 1, 0, 3, 0, 0, 0, 0, 0, 0, 1));
  EXPECT_EQ(depths.deepest(), 10);
}

TEST(PlanEdits, LeavesOutFacesThatStay) {
  const FaceDepths depths = depths_of({0, 2, 0, 1});
  const std::vector<std::uint32_t> faces{0, 1, 2, 3};
  EXPECT_THAT(plan_edits(depths, faces, DepthChange::add(-1)),
              ElementsAre(DepthEdit{1, 2, 1}, DepthEdit{3, 1, 0}));
  EXPECT_THAT(plan_edits(depths, faces, DepthChange::add(0)), IsEmpty());
}

TEST(PlanEdits, ChangesARepeatedFaceOnce) {
  const FaceDepths depths = depths_of({0, 2, 4});
  const std::vector<std::uint32_t> faces{2, 0, 2, 2, 0};
  EXPECT_THAT(plan_edits(depths, faces, DepthChange::add(1)),
              ElementsAre(DepthEdit{2, 4, 5}, DepthEdit{0, 0, 1}));
  const std::vector<std::uint32_t> doubled{1, 1};
  EXPECT_THAT(plan_edits(depths, doubled, DepthChange::add(1)), ElementsAre(DepthEdit{1, 2, 3}));
}

TEST(PlanEdits, RevertGivesBackWhatApplyChanged) {
  std::mt19937 random(20050613);
  for (int round = 0; round < 500; ++round) {
    const std::size_t count = 1 + random() % 40;
    FaceDepths depths(count);
    for (std::size_t f = 0; f < count; ++f) {
      depths.set(f, static_cast<int>(random() % (kMaxDepth + 1)));
    }
    std::vector<std::uint32_t> faces(random() % 60);
    for (std::uint32_t& face : faces) {
      face = static_cast<std::uint32_t>(random() % count);
    }
    const int amount = static_cast<int>(random() % 25) - 12;
    const DepthChange change =
        random() % 2 == 0 ? DepthChange::add(amount) : DepthChange::set(std::abs(amount) % 11);

    const FaceDepths before = depths;
    const std::vector<DepthEdit> edits = plan_edits(depths, faces, change);
    EXPECT_EQ(depths, before);
    apply_edits(depths, edits);
    for (std::uint32_t f = 0; f < count; ++f) {
      const bool is_named = std::find(faces.begin(), faces.end(), f) != faces.end();
      EXPECT_EQ(depths[f], is_named ? change(before[f]) : before[f]);
    }
    revert_edits(depths, edits);
    EXPECT_EQ(depths, before);
  }
}

TEST(PlanEditsDeathTest, EditsThatDoNotFitAreABug) {
  FaceDepths depths = depths_of({1, 2});
  const std::vector<DepthEdit> stale{{0, 0, 1}};
  EXPECT_DEATH(apply_edits(depths, stale), "internal error");
  const std::vector<DepthEdit> beyond{{2, 0, 1}};
  EXPECT_DEATH(apply_edits(depths, beyond), "internal error");
  const std::vector<std::uint32_t> faces{5};
  EXPECT_DEATH((void)plan_edits(depths, faces, DepthChange::add(1)), "internal error");
}

}  // namespace
}  // namespace limn
