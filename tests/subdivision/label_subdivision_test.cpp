#include "limn/subdivision/label_subdivision.h"

#include <vector>

#include <gtest/gtest.h>

#include "limn/mesh/build.h"
#include "limn/subdivision/crack_check.h"
#include "support/shapes.h"

namespace limn {
namespace {

TEST(LabelSubdivision, CubeWithOnePaintedFaceHasTheKnownCounts) {
  const auto cube = test::cube();
  const std::vector<std::pair<std::size_t, std::size_t>> known{
      {24, 26}, {76, 78}, {228, 230}, {724, 726}, {2484, 2486}, {9076, 9078}};
  for (std::uint8_t depth = 1; depth <= 6; ++depth) {
    std::vector<std::uint8_t> depths(6, 0);
    depths[0] = depth;
    IgnoreProgress progress;
    const auto legal = legal_labels(*cube, depths, {}, progress);
    ASSERT_TRUE(legal);
    EXPECT_EQ(legal->steps.size(), 3u);
    const auto refined = refine(*cube, legal->labels, {}, {}, progress);
    ASSERT_TRUE(refined);
    EXPECT_EQ(refined->face_count(), known[depth - 1u].first);
    EXPECT_EQ(refined->vertex_count(), known[depth - 1u].second);
    EXPECT_TRUE(check_cracks(*cube, *refined).is_watertight());
  }
}

}  // namespace
}  // namespace limn
