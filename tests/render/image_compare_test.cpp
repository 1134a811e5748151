// That the comparison with goldens can fail.
#include "support/image_compare.h"

#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "render/png.h"

namespace limn::test {
namespace {

namespace fs = std::filesystem;

fs::path golden_file(const std::string& name) {
  return fs::path(LIMN_SOURCE_DIR) / "tests" / "golden" / name;
}

/// A golden of the test's own, removed at its end.
class ImageCompare : public testing::Test {
 protected:
  void SetUp() override {
    if (const char* updating = std::getenv("LIMN_UPDATE_GOLDENS"); updating != nullptr) {
      was_updating_ = updating;
      unsetenv("LIMN_UPDATE_GOLDENS");
    }
  }
  void TearDown() override {
    for (const char* ending : {".png", ".out.png", ".diff.png"}) {
      fs::remove(golden_file(name + ending));
    }
    if (!was_updating_.empty()) {
      setenv("LIMN_UPDATE_GOLDENS", was_updating_.c_str(), 1);
    }
  }

  /// Of this test alone: tests run side by side.
  std::string name = std::string("image_compare_test_") +
                     testing::UnitTest::GetInstance()->current_test_info()->name();
  render::Image image{{4, 3}};

 private:
  std::string was_updating_;
};

TEST_F(ImageCompare, MissingGoldenFailsAndShowsWhatWasDrawn) {
  EXPECT_FALSE(matches_golden(image, name));
  EXPECT_EQ(*render::read_png(golden_file(name + ".out.png")), image);
}

TEST_F(ImageCompare, OneChannelOffByOneFailsAndShowsWhere) {
  ASSERT_TRUE(render::write_png(golden_file(name + ".png"), image));
  EXPECT_TRUE(matches_golden(image, name));
  image.pixel(2, 1)[2] = 1;
  EXPECT_FALSE(matches_golden(image, name));
  const auto diff = render::read_png(golden_file(name + ".diff.png"));
  ASSERT_TRUE(diff);
  EXPECT_GT(diff->pixel(2, 1)[0], 100);
  EXPECT_EQ(diff->pixel(1, 1)[0], 0);
}

TEST_F(ImageCompare, ARoundedPixelInAThousandPasses) {
  const render::Image golden({100, 20});
  ASSERT_TRUE(render::write_png(golden_file(name + ".png"), golden));
  image = golden;
  image.pixel(3, 4)[0] = 2;
  image.pixel(99, 19)[2] = 1;
  EXPECT_TRUE(matches_golden(image, name));
  image.pixel(50, 10)[1] = 1;
  EXPECT_FALSE(matches_golden(image, name)) << "three of two thousand";
  image = golden;
  image.pixel(3, 4)[0] = 3;
  EXPECT_FALSE(matches_golden(image, name)) << "off by three";
}

TEST_F(ImageCompare, AGoldenThatMatchesIsNotRewritten) {
  const render::Image golden({100, 20});
  ASSERT_TRUE(render::write_png(golden_file(name + ".png"), golden));
  image = golden;
  image.pixel(3, 4)[0] = 2;
  setenv("LIMN_UPDATE_GOLDENS", "1", 1);
  EXPECT_TRUE(matches_golden(image, name));
  EXPECT_EQ(*render::read_png(golden_file(name + ".png")), golden);
  image.pixel(3, 4)[0] = 200;
  EXPECT_TRUE(matches_golden(image, name));
  EXPECT_EQ(*render::read_png(golden_file(name + ".png")), image);
  unsetenv("LIMN_UPDATE_GOLDENS");
}

TEST_F(ImageCompare, AnotherSizeFails) {
  ASSERT_TRUE(render::write_png(golden_file(name + ".png"), render::Image({3, 4})));
  EXPECT_FALSE(matches_golden(image, name));
}

TEST_F(ImageCompare, CountsPixelsAndTheLargestDifference) {
  render::Image other = image;
  other.pixel(0, 0)[0] = 10;
  other.pixel(0, 0)[1] = 20;
  other.pixel(3, 2)[3] = 7;
  const ImageDifference difference = compare_images(image, other);
  EXPECT_EQ(difference.pixels, 2U);
  EXPECT_EQ(difference.largest, 20);
}

}  // namespace
}  // namespace limn::test
