// Rules that choose depths, through the program: what it tells of the distance to the limit
// surface, and cameras from files.
#include <cstdlib>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "limn_program.h"
#include "support/scratch_folder.h"

namespace limn::test {
namespace {

using Numbers = nlohmann::json;
using testing::HasSubstr;

TEST(AutoDepth, TellsTheMeasuredDistanceBesideTheTolerance) {
  const ProgramRun run = limn({"refine", "cube", "--paint", "tolerance=0.01d", "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Numbers reached = Numbers::parse(run.out)["distance_to_limit"];
  EXPECT_NEAR(reached["tolerance"].get<double>(), 0.01 * reached["diagonal"].get<double>(), 1e-12);
  EXPECT_GT(reached["greatest"], 0.0);
  EXPECT_LE(reached["greatest"], reached["tolerance"]);
  EXPECT_LT(reached["root_mean_square"], reached["greatest"]);
  EXPECT_FALSE(reached.contains("uniform"));
  EXPECT_THAT(limn({"refine", "cube", "--paint", "tolerance=0.01d"}).err, HasSubstr(", kept"));
  const ProgramRun painted = limn({"refine", "cube", "--paint", "all:+1", "--json"});
  EXPECT_FALSE(Numbers::parse(painted.out).contains("distance_to_limit"));
}

TEST(AutoDepth, HoldsABudgetAgainstUniformAndRandomPaintings) {
  const ProgramRun run = limn({"refine", "teapot", "--paint", "budget=4000", "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Numbers report = Numbers::parse(run.out);
  const Numbers& reached = report["distance_to_limit"];
  EXPECT_LE(report["faces"], 4000);
  EXPECT_EQ(reached["uniform"]["faces"], 674 * 4);
  EXPECT_LE(reached["random"]["faces"], 4000);
  EXPECT_GT(reached["random"]["faces"], 3000);
  EXPECT_LT(reached["root_mean_square"], reached["uniform"]["root_mean_square"]);
  EXPECT_LT(reached["root_mean_square"], reached["random"]["root_mean_square"]);
}

TEST(AutoDepth, RefusesABudgetBelowTheMeshAsOverBudget) {
  const ProgramRun run = limn({"refine", "teapot", "--paint", "budget=100"});
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_THAT(run.err, HasSubstr("674 faces"));
}

TEST(AutoDepth, LooksThroughTheCamerasOfFiles) {
  const ScratchFolder scratch;
  write_file(scratch / "camera.json",
             R"({"target": [0, 0, 0], "distance": 10, "yaw": 0, "pitch": 0,
                    "fov_degrees": 35, "orthographic": false})");
  const ProgramRun run =
      limn({"refine", "cube", "--paint", "screen=8px@" + scratch.file("camera.json"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Numbers depths = Numbers::parse(run.out)["faces_by_depth"];
  EXPECT_TRUE(depths.contains("0")) << depths;  // The face at the back.
  EXPECT_GT(depths.size(), 1U) << depths;
  const ProgramRun missing = limn({"refine", "cube", "--paint", "screen=8px@nowhere.json"});
  EXPECT_NE(missing.exit_code, 0);
  EXPECT_THAT(missing.err, HasSubstr("nowhere.json"));
}

TEST(Presets, AreListedAndPaintedBy) {
  const Numbers list = Numbers::parse(limn({"presets", "--json"}).out)["presets"];
  ASSERT_GE(list.size(), 5U);
  EXPECT_EQ(list[0]["name"], "draft");
  EXPECT_EQ(list[0]["bundled"], true);
  const std::string rule = list[0]["rules"][0].get<std::string>();
  const ProgramRun by_name = limn({"refine", "teapot", "--paint", "preset=draft", "--json"});
  const ProgramRun by_rule = limn({"refine", "teapot", "--paint", rule, "--json"});
  ASSERT_EQ(by_name.exit_code, 0) << by_name.err;
  EXPECT_EQ(Numbers::parse(by_name.out)["faces_by_depth"],
            Numbers::parse(by_rule.out)["faces_by_depth"]);
  EXPECT_THAT(limn({"presets"}).out, HasSubstr("    budget=5000\n"));
  const ProgramRun missing = limn({"refine", "cube", "--paint", "preset=none"});
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_THAT(missing.err, HasSubstr("draft"));
}

TEST(Presets, SavedInTheWindowAreThereAsWell) {
  const ScratchFolder scratch;
  std::filesystem::create_directories(scratch / "limn");
  write_file(scratch / "limn" / "preferences.json",
             R"({"presets": [{"name": "mine", "rules": "all:+1\ngrow\n"}]})");
  const char* before = std::getenv("XDG_CONFIG_HOME");
  const std::string kept = before != nullptr ? before : "";
  setenv("XDG_CONFIG_HOME", scratch.path().c_str(), 1);
  const ProgramRun run = limn({"refine", "cube", "--paint", "preset=mine", "--json"});
  const ProgramRun list = limn({"presets"});
  if (before != nullptr) {
    setenv("XDG_CONFIG_HOME", kept.c_str(), 1);
  } else {
    unsetenv("XDG_CONFIG_HOME");
  }
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(Numbers::parse(run.out)["faces"], 24);
  EXPECT_THAT(list.out, HasSubstr("mine\n    all:+1\n    grow\n"));
}

}  // namespace
}  // namespace limn::test
