// Camera files, whole and damaged.
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/document/project_file.h"
#include "limn/mesh/bundled.h"
#include "support/scratch_folder.h"

namespace limn {
namespace {

using test::read_file;
using test::ScratchFolder;
using test::write_file;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class ViewFile : public ::testing::Test {
 protected:
  std::string complaint(std::string_view text) {
    write_file(path_, text);
    const Result<ViewState> view = load_view(path_);
    return view ? "was loaded" : view.error().message;
  }

  ScratchFolder folder_;
  std::filesystem::path path_ = folder_ / "camera.json";
};

TEST_F(ViewFile, ComesBackAsItWas) {
  for (const ViewState& view :
       {ViewState{}, ViewState{{1e-9, -0.0, 1e12}, 0.1, -1234.5, 90.0, 100.0, true}}) {
    ASSERT_TRUE(save_view(path_, view));
    EXPECT_EQ(load_view(path_).value(), view);
  }
}

TEST_F(ViewFile, IsTheViewOfAProject) {
  const ViewState view{{1, 2, 3}, 4, 5, 6, 7, true};
  ASSERT_TRUE(save_project(folder_ / "p.limn",
                           make_document(load_bundled_mesh("cube").value(), "cube"), view));
  const std::string text = read_file(folder_ / "p.limn");
  const std::size_t begin = text.find('{', text.find("\"view\""));
  write_file(path_, text.substr(begin, text.find('}', begin) - begin + 1));
  EXPECT_EQ(load_view(path_).value(), view);
}

TEST_F(ViewFile, NamesTheCulprit) {
  const std::string good =
      "{\"target\": [0, 0, 0], \"distance\": 3, \"yaw\": 0, \"pitch\": 0, \"fov_degrees\": 35, "
      "\"orthographic\": false}";
  ASSERT_EQ(complaint(good), "was loaded");
  const auto with = [&](std::string_view piece, std::string_view other) {
    std::string text = good;
    return complaint(text.replace(text.find(piece), piece.size(), other));
  };
  EXPECT_THAT(with("[0, 0, 0]", "[0, 0]"), StartsWith("/target: "));
  EXPECT_THAT(with("[0, 0, 0]", "[0, 0, 0, 0]"), StartsWith("/target: "));
  EXPECT_THAT(with("[0, 0, 0]", "[0, \"0\", 0]"), StartsWith("/target/1: "));
  EXPECT_THAT(with("[0, 0, 0]", "0"), StartsWith("/target: "));
  EXPECT_THAT(with("\"distance\": 3", "\"distance\": -3"), StartsWith("/distance: "));
  EXPECT_THAT(with("\"distance\": 3,", ""), StartsWith("/distance: is missing"));
  EXPECT_THAT(with("\"pitch\": 0", "\"pitch\": -90.5"), StartsWith("/pitch: -90.5"));
  EXPECT_THAT(with("\"fov_degrees\": 35", "\"fov_degrees\": 180"), StartsWith("/fov_degrees: "));
  EXPECT_THAT(with("\"fov_degrees\": 35", "\"fov_degrees\": 0"), StartsWith("/fov_degrees: "));
  EXPECT_THAT(with("false", "\"no\""), StartsWith("/orthographic: "));
  EXPECT_THAT(with("\"yaw\": 0", "\"yaw\": 1e400"), HasSubstr("1e400"));
  EXPECT_THAT(complaint("[]"), StartsWith("/: must be an object"));
}

TEST_F(ViewFile, DoesNotSaveWhatItWouldNotLoad) {
  ViewState view;
  view.yaw = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(save_view(path_, view));
  EXPECT_FALSE(std::filesystem::exists(path_));
  EXPECT_FALSE(load_view(folder_.path()));
}

}  // namespace
}  // namespace limn
