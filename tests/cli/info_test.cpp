#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "limn_program.h"

namespace limn::test {
namespace {

using Json = nlohmann::json;

TEST(Info, CountsTheCube) {
  const ProgramRun run = limn({"info", "cube", "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json info = Json::parse(run.out);
  EXPECT_EQ(info["vertices"], 8);
  EXPECT_EQ(info["edges"], 12);
  EXPECT_EQ(info["faces"], 6);
  EXPECT_EQ(info["faces_by_sides"], (Json{{"4", 6}}));
  EXPECT_EQ(info["boundary_edges"], 0);
  EXPECT_EQ(info["components"], 1);
  EXPECT_EQ(info["euler_characteristic"], 2);
}

TEST(Info, ReadsStandardInputAndReportsWhatItMended) {
  const ProgramRun run = limn({"info", "-", "--json"},
                              "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 9 9 9\nvt 0 0\nf 1 2 3 4\n");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json info = Json::parse(run.out);
  EXPECT_EQ(info["vertices"], 4);
  EXPECT_EQ(info["boundary_loops"], 1);
  EXPECT_EQ(info["mended"]["isolated_vertices"], 1);
  EXPECT_THAT(run.err, testing::HasSubstr("1 vertex is in no face"));
}

TEST(Info, CountsCreasesAndTexture) {
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
      "f 1/1 2/2 5/3 4/4\nf 2/1 3/2 6/3 5/4\nt crease 2/1/0 1 4 2.5\nt crease 2/1/0 0 4 1\n"
      "t corner 1/1/0 0 10\n";
  const ProgramRun run = limn({"info", "-", "--json"}, text);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json info = Json::parse(run.out);
  EXPECT_EQ(info["crease_edges"], 1);
  EXPECT_EQ(info["sharp_vertices"], 1);
  EXPECT_EQ(info["uv_points"], 4);
  EXPECT_EQ(info["uv_seams"], 1);
  EXPECT_EQ(info["mended"]["lost_creases"], 1);
  EXPECT_THAT(run.err, testing::HasSubstr("1 crease tag was left out"));
  const ProgramRun people = limn({"info", "-"}, text);
  EXPECT_THAT(people.out, testing::HasSubstr("1 edge, 1 vertex (1 up to 3, 1 infinite)"));
  EXPECT_THAT(people.out, testing::HasSubstr("4 points, 1 seam edge"));
}

TEST(Info, TextForPeopleHasTheCounts) {
  const ProgramRun run = limn({"info", "mixed"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, testing::HasSubstr("triangles"));
  EXPECT_THAT(run.out, testing::HasSubstr("pentagons"));
}

}  // namespace
}  // namespace limn::test
