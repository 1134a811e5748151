#include "app/preferences.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "support/scratch_folder.h"

namespace limn::app {
namespace {

namespace fs = std::filesystem;

class PreferencesTest : public testing::Test {
 protected:
  void write(std::string_view text) const { std::ofstream(path_) << text; }

  test::ScratchFolder folder_;
  fs::path path_ = folder_ / "preferences.json";
};

TEST_F(PreferencesTest, ComeBackAsTheyWereSaved) {
  Preferences saved;
  saved.display.theme = ui::Theme::kLight;
  saved.display.wireframe = !saved.display.wireframe;
  saved.display.smooth = !saved.display.smooth;
  saved.keymap = ui::KeymapId::kClassroom;
  saved.navigation = {ui::NavigationPreset::kMouseOnly, false};
  saved.display.material = ui::Material::kDark;
  saved.brush.radius = 37.5;
  saved.brush.sets_depth = true;
  saved.brush.target_depth = 4;
  saved.brush.fill_angle = 75.0;
  saved.brush.goes_through = true;
  saved.brush.is_fine = true;
  saved.brush.shift_draws_lines = true;
  saved.brush.mirror = {.x = true, .z = true};
  saved.dihedral_threshold = 12.25;
  saved.crease_sharpness = 3.75;
  saved.auto_depth.rules = parse_paint_rules("budget=77t,greatest:max in painted", "test").value();
  saved.auto_depth.choices[1] = std::get<ChooseDepths>(saved.auto_depth.rules[0].action).choice;
  saved.auto_depth.moves_to_limit = false;
  saved.presets = {{"mine", "All of it.", "all:+1\ngrow\n"}, {"other", "", "grow\n"}};
  saved.layout.auto_depth_open = true;
  saved.display.creases = !saved.display.creases;
  saved.face_budget = 123456;
  saved.shows_hints = true;
  saved.layout.panel_width = 401.0;
  saved.layout.display_open = !saved.layout.display_open;
  saved.window = {1711, 913};
  saved.is_maximised = true;
  saved.recent_files = {"/tmp/a b.obj", "/tmp/ä.limn"};
  const fs::path nested = folder_ / "new" / "preferences.json";
  ASSERT_TRUE(save_preferences(nested, saved).has_value());
  const auto loaded = load_preferences(nested);
  ASSERT_TRUE(loaded.has_value()) << to_string(loaded.error());
  EXPECT_EQ(*loaded, saved);
}

TEST_F(PreferencesTest, WithoutAWordOnItTheButtonsAreThoseOfTheKeys) {
  write(R"({"keymap": "classroom"})");
  const auto loaded = load_preferences(path_);
  ASSERT_TRUE(loaded.has_value()) << to_string(loaded.error());
  EXPECT_EQ(loaded->navigation.preset, ui::NavigationPreset::kClassroom);
  EXPECT_TRUE(loaded->navigation.orbits_around_cursor);
}

TEST_F(PreferencesTest, MissingFileGivesDefaults) {
  const auto loaded = load_preferences(folder_ / "none.json");
  ASSERT_TRUE(loaded.has_value());
  EXPECT_TRUE(loaded->shows_hints) << "nobody has been here before";
  Preferences known = *loaded;
  known.shows_hints = false;
  EXPECT_EQ(known, Preferences{});
}

TEST_F(PreferencesTest, BrokenFilesAreErrorsThatNameTheFile) {
  for (const std::string_view text :
       {"", "{", "[]", "3", "{\"theme\": 7}", "{\"panel\": []}", "{\"recent_files\": [1, 2]}",
        "{\"window\": {\"width\": \"wide\"}}", "\xff\xfe"}) {
    write(text);
    const auto loaded = load_preferences(path_);
    ASSERT_FALSE(loaded.has_value()) << text;
    EXPECT_EQ(loaded.error().kind, ErrorKind::kBadInput);
    EXPECT_EQ(loaded.error().path, path_.string());
  }
}

TEST_F(PreferencesTest, NumbersOutOfRangeAreBroughtIntoIt) {
  write(R"({"brush_radius": 1e9, "dihedral_threshold": -5, "panel": {"width": 1},
            "window": {"width": 3, "height": 1000000}, "unknown": true})");
  const auto loaded = load_preferences(path_);
  ASSERT_TRUE(loaded.has_value()) << to_string(loaded.error());
  EXPECT_EQ(loaded->brush.radius, ui::kMaxBrushRadius);
  EXPECT_EQ(loaded->dihedral_threshold, 0.0);
  EXPECT_GE(loaded->layout.panel_width, 200.0);
  EXPECT_EQ(loaded->window, (ui::WindowSize{640.0, 16384.0}));
}

TEST_F(PreferencesTest, RecentFilesKeepTheNewestFirstOnce) {
  std::vector<std::string> recent;
  for (int i = 0; i < 15; ++i) {
    remember_recent(recent, std::to_string(i));
  }
  remember_recent(recent, "9");
  ASSERT_EQ(recent.size(), kMostRecentFiles);
  EXPECT_EQ(recent[0], "9");
  EXPECT_EQ(recent[1], "14");
  EXPECT_EQ(std::count(recent.begin(), recent.end(), "9"), 1);
}

}  // namespace
}  // namespace limn::app
