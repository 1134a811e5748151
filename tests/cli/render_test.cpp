// Pictures made by the shipped program through OSMesa, compared pixel by pixel with tests/golden.
// The situations are those of the figures that the method is usually shown with, before and after.
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn_program.h"
#include "render/png.h"
#include "support/image_compare.h"

namespace limn::test {
namespace {

using Words = std::vector<std::string>;

class Render : public testing::Test {
 protected:
  void SetUp() override { setenv("LIMN_HEADLESS", "osmesa", 1); }

  /// The picture that `limn render` makes of these arguments.
  render::Image picture(Words arguments) {
    arguments.insert(arguments.begin(), "render");
    for (const char* word : {"--size", "480x360", "-o"}) {
      arguments.emplace_back(word);
    }
    arguments.push_back(scratch_.file("picture.png"));
    const ProgramRun run = limn(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const auto image = render::read_png(scratch_.file("picture.png"));
    EXPECT_TRUE(image) << to_string(image.error());
    return image.value_or(render::Image({1, 1}));
  }

  /// The painted control mesh and its refinement, each against its golden picture.
  void expect_before_and_after(Words arguments, const std::string& name) {
    arguments.insert(arguments.end(), {"--show", "control"});
    EXPECT_TRUE(matches_golden(picture(arguments), name + "_before"));
    arguments.back() = "refined";
    EXPECT_TRUE(matches_golden(picture(arguments), name + "_after"));
  }

 private:
  ScratchFolder scratch_;
};

TEST_F(Render, CubeWithOneFaceAtDepthFive) {
  expect_before_and_after({"cube", "--paint", "faces=5:=5", "--view", "iso"}, "cli_cube_one_face");
}

TEST_F(Render, CreaturePaintedWhereItIsVisibleFromOneSide) {
  // Painted from the right, seen from elsewhere: the border of what was visible runs over it.
  const ScratchFolder scratch;
  const std::string painted = scratch.file("painted.limn");
  const ProgramRun run = limn({"refine", "creature", "--paint", "visible:+2", "--view", "right",
                               "--legalize", "greedy", "-o", painted});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  expect_before_and_after({painted, "--view", "three-quarter"}, "cli_creature_visible");
}

TEST_F(Render, TheLegendCountsTheFacesOfEachDepth) {
  EXPECT_TRUE(matches_golden(picture({"creature", "--paint", "dihedral>30:+1", "--paint",
                                      "dihedral>50:+2", "--view", "left", "--legend"}),
                             "cli_legend"));
}

TEST_F(Render, DistanceFromTheLimitHasColoursAndALegend) {
  EXPECT_TRUE(matches_golden(picture({"mixed", "--paint", "faces=0-8:+2", "--non-quads",
                                      "where-painted", "--colours", "distance", "--legend"}),
                             "cli_distance"));
  EXPECT_TRUE(matches_golden(picture({"creature", "--colours", "distance", "--legend"}),
                             "cli_distance_control"));
}

TEST_F(Render, CreasesHaveALegendOfTheirOwn) {
  const Words creased = {"teapot",        "--crease", "angle>20:=0.5", "--crease",
                         "angle>30:=2.5", "--crease", "angle>50:=inf", "--show",
                         "control",       "--legend", "--light-theme"};
  EXPECT_TRUE(matches_golden(picture(creased), "cli_creases"));
}

TEST_F(Render, NoCreasesLeavesThemOut) {
  const render::Image plain = picture({"cube", "--show", "control"});
  const Words creased = {"cube", "--show", "control", "--crease", "all:=2"};
  EXPECT_FALSE(picture(creased) == plain);
  Words without = creased;
  without.emplace_back("--no-creases");
  EXPECT_TRUE(picture(without) == plain);
}

TEST_F(Render, TeapotPaintedByDihedralAngle) {
  expect_before_and_after({"teapot", "--paint", "dihedral>25:+1", "--paint", "dihedral>45:+1"},
                          "cli_teapot_dihedral");
}

TEST_F(Render, BothShowsTheCageOverTheRefinedSurface) {
  EXPECT_TRUE(matches_golden(picture({"cube", "--paint", "all:=3", "--show", "both", "--smooth",
                                      "--no-wireframe", "--light-theme"}),
                             "cli_both_light"));
}

TEST_F(Render, IllegalFacesAndLabelsAsPainted) {
  EXPECT_TRUE(matches_golden(picture({"grid", "--paint", "faces=78,91,103-106:=2", "--show",
                                      "control", "--illegal", "--labels"}),
                             "cli_illegal_labels"));
}

TEST_F(Render, EveryMaterialWithAndWithoutColours) {
  for (const char* material : {"clay", "dark", "shiny"}) {
    EXPECT_TRUE(matches_golden(
        picture({"creature", "--paint", "all:+1", "--paint", "faces=0-150:+1", "--smooth",
                 "--no-wireframe", "--colours", "none", "--material", material}),
        std::string("cli_material_") + material));
  }
  EXPECT_TRUE(matches_golden(
      picture({"creature", "--paint", "faces=0-200:=2", "--material", "shiny", "--light-theme"}),
      "cli_material_painted"));
}

TEST_F(Render, LevelsColourEachRefinedFaceAndAreCounted) {
  EXPECT_TRUE(matches_golden(picture({"cube", "--paint", "faces=5:=4", "--view", "iso", "--colours",
                                      "level", "--numbers", "--legend"}),
                             "cli_levels"));
}

TEST_F(Render, NumbersStandOnFacesThatAreLargeEnough) {
  expect_before_and_after(
      {"creature", "--paint", "faces=0-200:=2", "--paint", "dihedral>60:+1", "--numbers"},
      "cli_numbers");
}

TEST_F(Render, TheGpuRefinesToTheSameColoursOfLevels) {
  const Words levels = {"cube", "--paint", "faces=5:=3", "--colours", "level", "--legend"};
  Words on_gpu = levels;
  on_gpu.insert(on_gpu.end(), {"--refine-on", "gpu"});
  const auto difference = compare_images(picture(levels), picture(on_gpu));
  EXPECT_LT(difference.pixels, 200U) << "rounding at edges alone";
}

/// One mesh with a boundary, made to fit each.
TEST_F(Render, EveryScheme) {
  for (const char* scheme : {"linear", "catmull-clark", "loop", "butterfly", "kobbelt", "sqrt3",
                             "doo-sabin", "midedge", "biquartic"}) {
    EXPECT_TRUE(
        matches_golden(picture({"torus_open", "--scheme", scheme, "--fit", "--levels", "2"}),
                       std::string("cli_scheme_") + scheme));
  }
}

TEST_F(Render, SchemesShowTheirChoices) {
  const Words loop = {"cube_triangulated", "--scheme", "loop",          "--weights", "warren",
                      "--levels",          "3",        "--light-theme", "--show",    "both"};
  EXPECT_TRUE(matches_golden(picture(loop), "cli_scheme_loop_warren_both"));
  EXPECT_TRUE(matches_golden(picture({"cube", "--scheme", "linear", "--average", "--levels", "3"}),
                             "cli_scheme_linear_averaged"));
}

TEST_F(Render, SphereWithFourFacesByAdaptiveLoop) {
  expect_before_and_after(
      {"sphere", "--paint", "faces=0-3:=3", "--adaptive", "loop", "--view", "iso"},
      "cli_adaptive_loop");
}

TEST_F(Render, SchemesGoWithNoPainting) {
  for (const Words& words :
       {Words{"--paint", "all:+1"}, Words{"--labels"}, Words{"--refine-on", "gpu"},
        Words{"--adaptive", "loop"}, Words{"--weights", "warren"}, Words{"--levels", "13"}}) {
    Words all = {"render", "cube", "--scheme", "doo-sabin", "-o", "unwritten.png"};
    all.insert(all.end(), words.begin(), words.end());
    EXPECT_EQ(limn(all).exit_code, 2) << words.front();
  }
  const ProgramRun refused = limn({"render", "cube", "--scheme", "loop", "-o", "unwritten.png"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, testing::HasSubstr("--fit"));
  EXPECT_FALSE(std::filesystem::exists("unwritten.png"));
}

TEST_F(Render, LooksFromACameraFile) {
  const ScratchFolder scratch;
  write_file(scratch.file("camera.json"),
             R"({"target": [0, 0, 0], "distance": 6, "yaw": 0, "pitch": 0,)"
             R"( "fov_degrees": 35, "orthographic": false})");
  EXPECT_EQ(picture({"cube", "--camera", scratch.file("camera.json")}).size, glm::ivec2(480, 360));
  write_file(scratch.file("camera.json"), R"({"target": [0, 0], "distance": 6})");
  const ProgramRun run = limn(
      {"render", "cube", "--camera", scratch.file("camera.json"), "-o", scratch.file("out.png")});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.err, testing::HasSubstr("/target"));
  EXPECT_FALSE(std::filesystem::exists(scratch.file("out.png")));
}

TEST_F(Render, OnTheGpuLooksTheSame) {
  const Words painted = {"teapot",        "--paint",     "dihedral>20:=3", "--crease",
                         "angle>50:=1.5", "--non-quads", "where-painted"};
  for (const char* shading : {"--no-wireframe", "--smooth"}) {
    Words words = painted;
    words.emplace_back(shading);
    const render::Image by_cpu = picture(words);
    words.insert(words.end(), {"--refine-on", "gpu"});
    const ImageDifference difference = compare_images(picture(words), by_cpu);
    // A vertex that is a ten-millionth off can change a pixel on an edge.
    EXPECT_LE(difference.pixels, 30U) << shading;
    words.insert(words.end(), {"--levels", "0"});
    EXPECT_GT(compare_images(picture(words), by_cpu).pixels, difference.pixels) << shading;
  }
}

TEST_F(Render, OnTheGpuIsReported) {
  const ScratchFolder scratch;
  const Words words = {"render", "cube",        "--paint", "all:=4", "-o", scratch.file("out.png"),
                       "--json", "--refine-on", "gpu"};
  const ProgramRun run = limn(words);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, testing::HasSubstr("\"faces\": 1536"));
  EXPECT_THAT(run.out, testing::HasSubstr("\"refined_on\": \"llvmpipe"));
}

TEST_F(Render, OnTheGpuKeepsToTheBudget) {
  const ScratchFolder scratch;
  const ProgramRun run = limn({"render", "cube", "--paint", "all:=4", "--budget", "1535", "-o",
                               scratch.file("out.png"), "--refine-on", "gpu"});
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_THAT(run.err, testing::HasSubstr("1536 faces"));
}

TEST_F(Render, OnTheGpuSaysWhichLimitIsInTheWay) {
  const ScratchFolder scratch;
  const ProgramRun run = limn({"render", "creature", "--paint", "all:=8", "--budget", "1000000000",
                               "-o", scratch.file("out.png"), "--refine-on", "gpu"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, testing::HasSubstr("GL_MAX_SHADER_STORAGE_BLOCK_SIZE"));
}

}  // namespace
}  // namespace limn::test
