#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

#include "render/png.h"

namespace limn::render {
namespace {

namespace fs = std::filesystem;

class Png : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }

  fs::path folder =
      fs::path(testing::TempDir()) /
      ("limn_png_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

Image ramp() {
  Image image({7, 5});
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    image.rgba[i] = static_cast<std::uint8_t>(i * 37U);
  }
  return image;
}

TEST_F(Png, ComesBackByteForByte) {
  ASSERT_TRUE(write_png(folder / "a.png", ramp()));
  const auto read = read_png(folder / "a.png");
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(*read, ramp());
}

TEST_F(Png, WritingReplacesAndLeavesNothingBeside) {
  ASSERT_TRUE(write_png(folder / "a.png", Image({3, 3})));
  ASSERT_TRUE(write_png(folder / "a.png", ramp()));
  EXPECT_EQ(*read_png(folder / "a.png"), ramp());
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
}

TEST_F(Png, UnwritableFolderIsAnError) {
  const auto written = write_png(folder / "missing" / "a.png", ramp());
  ASSERT_FALSE(written);
  EXPECT_THAT(to_string(written.error()), testing::HasSubstr("a.png"));
}

TEST_F(Png, MissingFileIsBadInput) {
  const auto read = read_png(folder / "none.png");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().kind, ErrorKind::kBadInput);
}

TEST_F(Png, GarbageAndTruncationAreBadInput) {
  {
    std::ofstream(folder / "garbage.png", std::ios::binary) << "this is no picture";
    const auto read = read_png(folder / "garbage.png");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().kind, ErrorKind::kBadInput);
  }
  ASSERT_TRUE(write_png(folder / "whole.png", ramp()));
  fs::resize_file(folder / "whole.png", fs::file_size(folder / "whole.png") / 2);
  const auto read = read_png(folder / "whole.png");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().kind, ErrorKind::kBadInput);
}

}  // namespace
}  // namespace limn::render
