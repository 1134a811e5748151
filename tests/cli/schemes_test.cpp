#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "limn_program.h"

namespace limn::test {
namespace {

using Json = nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(Schemes, TellsOfEveryScheme) {
  const ProgramRun run = limn({"schemes", "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  std::vector<std::string> names;
  for (const Json& scheme : Json::parse(run.out)) {
    names.push_back(scheme["name"]);
    for (const char* key : {"title", "takes", "makes", "continuity", "boundary", "source"}) {
      EXPECT_FALSE(scheme[key].get<std::string>().empty()) << names.back() << " " << key;
    }
    EXPECT_TRUE(scheme["interpolates"].is_boolean());
  }
  EXPECT_THAT(names, ElementsAre("linear", "catmull-clark", "loop", "butterfly", "kobbelt", "sqrt3",
                                 "doo-sabin", "midedge", "biquartic"));
}

TEST(Schemes, TextForPeopleTellsOfAllOrOne) {
  const ProgramRun all = limn({"schemes"});
  ASSERT_EQ(all.exit_code, 0) << all.err;
  EXPECT_THAT(all.out, HasSubstr("butterfly (Modified butterfly)"));
  EXPECT_THAT(all.out, HasSubstr("takes         quads"));
  const ProgramRun one = limn({"schemes", "loop"});
  ASSERT_EQ(one.exit_code, 0) << one.err;
  EXPECT_THAT(one.out, HasSubstr("Loop 1987"));
  EXPECT_THAT(one.out, testing::Not(HasSubstr("butterfly")));
}

/// Two triangles, 0 1 2 and 0 2 3.
constexpr const char* kTwoTriangles = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";

TEST(Schemes, AdjacencyHasTheRowsOfTheExercise) {
  const ProgramRun run = limn({"schemes", "loop", "-", "--adjacency", "--json"}, kTwoTriangles);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json adjacency = Json::parse(run.out);
  // Counter-clockwise, from one boundary neighbour to the other.
  EXPECT_EQ(adjacency["vertices"], Json::parse("[[3,1,2,3],[2,2,0],[3,3,0,1],[2,0,2]]"));
  ASSERT_EQ(adjacency["midpoints"].size(), 5u);
  int inner = 0;
  for (const Json& row : adjacency["midpoints"]) {
    ASSERT_EQ(row.size(), 4u);
    if (!row[3].is_null()) {
      ++inner;
      EXPECT_EQ((std::set<int>{row[0], row[1]}), (std::set<int>{0, 2}));
      EXPECT_EQ((std::set<int>{row[2], row[3]}), (std::set<int>{1, 3}));
    }
  }
  EXPECT_EQ(inner, 1);

  const ProgramRun text = limn({"schemes", "loop", "-", "--adjacency"}, kTwoTriangles);
  ASSERT_EQ(text.exit_code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("# 4 old vertices"));
  EXPECT_THAT(text.out, HasSubstr("\n3 1 2 3\n2 2 0\n3 3 0 1\n2 0 2\n"));
  EXPECT_THAT(text.out, HasSubstr("# 5 midpoints"));
  EXPECT_THAT(text.out, HasSubstr("0 1 2 -\n"));
}

TEST(Schemes, AdjacencyIsLoopsAlone) {
  EXPECT_EQ(limn({"schemes", "butterfly", "icosahedron", "--adjacency"}).exit_code, 2);
  EXPECT_EQ(limn({"schemes", "loop", "--adjacency"}).out,
            limn({"schemes", "loop", "sphere", "--adjacency"}).out);
  EXPECT_EQ(limn({"schemes", "loop", "icosahedron"}).exit_code, 2);
  EXPECT_EQ(limn({"schemes", "lop"}).exit_code, 2);
  const ProgramRun quads = limn({"schemes", "loop", "cube", "--adjacency"});
  EXPECT_EQ(quads.exit_code, 1);
  EXPECT_THAT(quads.err, HasSubstr("--fit"));
  EXPECT_EQ(limn({"schemes", "loop", "cube", "--adjacency", "--fit"}).exit_code, 0);
}

TEST(CompareSphere, AnswersTheExerciseWithoutArguments) {
  const ProgramRun run = limn({"compare", "sphere", "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json tables = Json::parse(run.out);
  ASSERT_EQ(tables.size(), 4u);
  std::vector<std::string> titles;
  for (const Json& table : tables) {
    titles.push_back(table["mesh"].get<std::string>() + " " + table["weights"].get<std::string>());
    ASSERT_EQ(table["levels"].size(), 6u);
    for (const Json& level : table["levels"]) {
      EXPECT_LE(level["least"], 0.0);
      EXPECT_GE(level["greatest"], 0.0);
      EXPECT_LE(level["root_mean_square"].get<double>(),
                std::max(-level["least"].get<double>(), level["greatest"].get<double>()));
    }
  }
  EXPECT_THAT(titles, ElementsAre("sphere original", "sphere warren", "cube_triangulated original",
                                  "cube_triangulated warren"));
  // The cube's corners lie on a sphere; what becomes of them does not.
  EXPECT_NEAR(tables[2]["levels"][0]["radius"], std::sqrt(3.0), 1e-12);
  EXPECT_LT(tables[2]["levels"][0]["root_mean_square"], 1e-12);
  EXPECT_GT(tables[2]["levels"][5]["root_mean_square"], 1e-3);
  EXPECT_EQ(tables[2]["levels"][5]["faces"], 12 * 1024);
}

TEST(CompareSphere, TablesForPeople) {
  const ProgramRun run =
      limn({"compare", "sphere", "icosahedron", "--weights", "original", "--levels", "2"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("icosahedron, Loop, original weights\n"));
  EXPECT_THAT(run.out, testing::Not(HasSubstr("Warren")));
  EXPECT_THAT(run.out, HasSubstr("r.m.s."));
  std::istringstream lines(run.out);
  std::string line;
  int count = 0;
  while (std::getline(lines, line)) {
    count += line.empty() ? 0 : 1;
  }
  EXPECT_EQ(count, 2 + 3);
}

TEST(CompareSphere, AllSchemesFitTheMeshesAsNeeded) {
  const ProgramRun run =
      limn({"compare", "sphere", "cube", "--scheme", "all", "--levels", "2", "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json tables = Json::parse(run.out);
  ASSERT_EQ(tables.size(), 11u);
  EXPECT_EQ(tables[0]["averaged"], false);
  EXPECT_EQ(tables[1]["averaged"], true);
  std::map<std::string, bool> fitted;
  for (const Json& table : tables) {
    fitted[table["scheme"]] = table["fitted"];
  }
  EXPECT_EQ(fitted, (std::map<std::string, bool>{{"linear", false},
                                                 {"catmull-clark", false},
                                                 {"loop", true},
                                                 {"butterfly", true},
                                                 {"kobbelt", false},
                                                 {"sqrt3", true},
                                                 {"doo-sabin", false},
                                                 {"midedge", false},
                                                 {"biquartic", false}}));
  EXPECT_THAT(run.err, HasSubstr("cut into triangles to fit Loop"));
}

TEST(CompareSphere, SaysWhyItCannot) {
  const ProgramRun flat = limn({"compare", "sphere", "-", "--scheme", "linear"},
                               "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                               "f 1 2 3 4\n");
  EXPECT_EQ(flat.exit_code, 1);
  EXPECT_THAT(flat.err, HasSubstr("lie in a plane"));
  const ProgramRun quads = limn({"compare", "sphere", "cube"});
  EXPECT_EQ(quads.exit_code, 1);
  EXPECT_THAT(quads.err, HasSubstr("--fit"));
  const ProgramRun large = limn({"compare", "sphere", "--levels", "12"});
  EXPECT_EQ(large.exit_code, 4);
  EXPECT_THAT(large.err, HasSubstr("536870912 faces"));
  EXPECT_EQ(limn({"compare"}).exit_code, 2);
  EXPECT_EQ(limn({"compare", "sphere", "--average"}).exit_code, 2);
  EXPECT_EQ(limn({"compare", "sphere", "--scheme", "some"}).exit_code, 2);
  EXPECT_EQ(limn({"compare", "sphere", "no_such_mesh"}).exit_code, 3);
}

}  // namespace
}  // namespace limn::test
