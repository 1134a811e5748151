#include "limn/painting/crease_palette.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/attribute_shapes.h"

namespace limn {
namespace {

TEST(CreasePalette, BandsByWholeLevels) {
  EXPECT_EQ(sharpness_band(0.01F), 0U);
  EXPECT_EQ(sharpness_band(1.0F), 0U);
  EXPECT_EQ(sharpness_band(1.01F), 1U);
  EXPECT_EQ(sharpness_band(3.5F), 3U);
  EXPECT_EQ(sharpness_band(4.0F), 3U);
  EXPECT_EQ(sharpness_band(4.1F), 4U);
  EXPECT_EQ(sharpness_band(9.99F), 4U);
  EXPECT_EQ(sharpness_band(kInfiniteSharpness), 5U);
  EXPECT_EQ(sharpness_band(1e30F), 5U);
  EXPECT_STREQ(sharpness_band_name(5), "infinite");
}

TEST(CreasePalette, TheSharperTheLighter) {
  int darker = -1;
  for (const Rgb& colour : crease_palette()) {
    const int luma = 299 * colour.red + 587 * colour.green + 114 * colour.blue;
    EXPECT_GT(luma, darker + 15'000);
    darker = luma;
  }
}

TEST(CreasePalette, CountsEdgesAndVerticesByBand) {
  EXPECT_THAT(count_creases(*test::cube()), testing::Each(0U));
  const auto mesh = test::with_tags(
      test::cube_soup(), {{{0, 1}, 0.5F}, {{1, 2}, 2.0F}, {{2, 3}, 1.5F}, {{3, 0}, 10.0F}},
      {{5, 3.5F}});
  EXPECT_THAT(count_creases(*mesh), testing::ElementsAre(1, 2, 0, 1, 0, 1));
}

}  // namespace
}  // namespace limn
