#include "limn/painting/stroke.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limn {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

using Faces = std::vector<std::uint32_t>;

TEST(Stroke, ChangesEachFaceOnceHoweverOftenItIsTouched) {
  FaceDepths depths(6);
  Stroke stroke(depths, DepthChange::add(1));
  EXPECT_TRUE(stroke.touch(depths, Faces{2, 3}));
  EXPECT_TRUE(stroke.touch(depths, Faces{3, 4, 4}));
  EXPECT_FALSE(stroke.touch(depths, Faces{2, 3, 4}));
  EXPECT_THAT(depths.values(), ElementsAre(0, 0, 1, 1, 1, 0));
}

TEST(Stroke, KeepsItsEditsInTheOrderTheyWereMade) {
  FaceDepths depths(6);
  depths.set(5, 7);
  Stroke stroke(depths, DepthChange::set(2));
  stroke.touch(depths, Faces{5});
  stroke.touch(depths, Faces{4, 0});
  EXPECT_THAT(stroke.edits(),
              ElementsAre(DepthEdit{5, 7, 2}, DepthEdit{4, 0, 2}, DepthEdit{0, 0, 2}));
}

TEST(Stroke, AFaceThatCannotChangeIsTouchedButNotEdited) {
  FaceDepths depths(2);
  depths.set(1, kMaxDepth);
  Stroke lower(depths, DepthChange::add(-1));
  EXPECT_FALSE(lower.touch(depths, Faces{0}));
  EXPECT_THAT(lower.edits(), IsEmpty());
  Stroke raise(depths, DepthChange::add(1));
  EXPECT_FALSE(raise.touch(depths, Faces{1}));
  EXPECT_EQ(depths[1], kMaxDepth);
}

TEST(Stroke, RevertingItsEditsGivesBackThePainting) {
  FaceDepths depths(8);
  depths.set(3, 3);
  const FaceDepths before = depths;
  Stroke stroke(depths, DepthChange::add(-1));
  stroke.touch(depths, Faces{3, 2, 3});
  EXPECT_EQ(depths[3], 2);
  revert_edits(depths, stroke.edits());
  EXPECT_EQ(depths, before);
}

}  // namespace
}  // namespace limn
