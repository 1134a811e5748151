// `limn compare` with the limit surface and with other meshes.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "limn_program.h"

namespace limn::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

const double kCubeDiagonal = std::sqrt(12.0);

Json compared(const std::vector<std::string>& arguments) {
  std::vector<std::string> words{"compare", "--json"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const ProgramRun run = limn(words);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return Json::parse(run.out);
}

/// Its corners are twice as far from the centre as their limits.
TEST(CompareWithLimit, MeasuresTheMeshItselfWhereNothingIsPainted) {
  const Json cube = compared({"cube", "--to", "limit"});
  EXPECT_EQ(cube["faces"], 6);
  EXPECT_NEAR(cube["greatest"], std::sqrt(0.75), 1e-6);
  EXPECT_NEAR(cube["greatest_of_diagonal"], 0.25, 1e-6);
  EXPECT_NEAR(cube["back"]["greatest"], 0.5, 1e-6);
  EXPECT_NEAR(cube["diagonal"], kCubeDiagonal, 1e-9);
  EXPECT_EQ(cube["is_settled"], true);
  EXPECT_LT(cube["there"]["root_mean_square"], cube["there"]["greatest"]);
}

TEST(CompareWithLimit, MeasuresThePaintedRefinement) {
  const Json level = compared({"cube", "--to", "limit", "--paint", "all:+3"});
  EXPECT_EQ(level["faces"], 384);
  EXPECT_LT(level["greatest_of_diagonal"], 0.004);
  const Json capped = compared({"cube", "--to", "limit", "--paint", "all:+3", "--levels", "1"});
  EXPECT_EQ(capped["faces"], 24);
  EXPECT_GT(capped["greatest_of_diagonal"], 0.04);
  const Json limit =
      compared({"cube", "--to", "limit", "--paint", "all:+3", "--positions", "limit"});
  EXPECT_LT(limit["greatest"], level["greatest"]);
}

TEST(CompareWithLimit, IsTheSameOnAnyNumberOfThreads) {
  const std::vector<std::string> words{"mixed", "--to", "limit", "--paint", "faces=0-20:+2"};
  std::vector<std::string> on_one = words;
  on_one.insert(on_one.end(), {"--threads", "1"});
  Json one = compared(on_one);
  Json all = compared(words);
  one.erase("seconds");
  all.erase("seconds");
  EXPECT_EQ(one, all);
}

/// A refined mesh in a file is as far from where it was refined from as the refinement is.
TEST(CompareWithMesh, MeasuresBetweenFilesAndPaintings) {
  const ScratchFolder folder;
  const std::string path = (folder.path() / "refined.obj").string();
  ASSERT_EQ(limn({"refine", "creature", "--paint", "all:+1", "-o", path}).exit_code, 0);
  const Json same = compared({"creature", "--paint", "all:+1", "--to", path});
  EXPECT_LT(same["greatest_of_diagonal"], 1e-7);
  const Json there = compared({"creature", "--to", path});
  const Json back = compared({path, "--to", "creature"});
  EXPECT_GT(there["greatest_of_diagonal"], 1e-3);
  EXPECT_NEAR(there["there"]["greatest"], back["back"]["greatest"],
              0.01 * there["greatest"].get<double>());
  // A project is taken as it is painted.
  const std::string project = (folder.path() / "painted.limn").string();
  ASSERT_EQ(limn({"refine", "creature", "--paint", "all:+1", "-o", project}).exit_code, 0);
  EXPECT_LT(compared({path, "--to", project})["greatest_of_diagonal"], 1e-7);
}

TEST(CompareWithLimit, PrintsATable) {
  const ProgramRun run = limn({"compare", "cube", "--to", "limit"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("to the limit       0.866025  25.00000 %"));
  EXPECT_THAT(run.out, HasSubstr("back                    0.5  14.43376 %"));
}

TEST(CompareWithLimit, SaysWhatIsWrong) {
  EXPECT_EQ(limn({"compare", "cube"}).exit_code, 2);
  EXPECT_EQ(limn({"compare", "no_such_mesh", "--to", "limit"}).exit_code, 3);
  EXPECT_EQ(limn({"compare", "cube", "--to", "no_such_mesh"}).exit_code, 3);
  EXPECT_EQ(
      limn({"compare", "cube", "--to", "limit", "--paint", "all:+7", "--budget", "100"}).exit_code,
      4);
  const ProgramRun loop =
      limn({"compare", "cube_triangulated", "--to", "limit", "--adaptive", "loop"});
  EXPECT_EQ(loop.exit_code, 2);
  EXPECT_THAT(loop.err, HasSubstr("Catmull-Clark"));
}

/// There is a comparison of that name, and a mesh.
TEST(CompareWithLimit, TellsTheSphereFromTheComparison) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"compare", "sphere", "--to", "limit"},
        std::vector<std::string>{"compare", "--to", "limit", "sphere"}}) {
    const ProgramRun run = limn(words);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_THAT(run.err, HasSubstr("limn compare --to limit -- sphere"));
  }
  const ProgramRun sphere = limn({"compare", "--to", "limit", "--", "sphere"});
  EXPECT_EQ(sphere.exit_code, 0) << sphere.err;
  EXPECT_THAT(sphere.out, HasSubstr("sphere: 18 vertices"));
}

}  // namespace
}  // namespace limn::test
