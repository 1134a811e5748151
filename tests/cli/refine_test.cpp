#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "limn/document/project_file.h"
#include "limn/mesh/bundled.h"
#include "limn/mesh/import.h"
#include "limn_program.h"

namespace limn::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

TEST(Refine, LooksAheadUnlessToldOtherwise) {
  for (const std::vector<std::string>& method :
       {std::vector<std::string>{}, {"--legalize", "look-ahead"}, {"--legalize", "greedy"}}) {
    const ScratchFolder scratch;
    std::vector<std::string> arguments{"refine", "cube", "--paint", "faces=0:=5", "--json", "-o"};
    arguments.push_back(scratch.file("out.obj"));
    arguments.insert(arguments.end(), method.begin(), method.end());
    const ProgramRun run = limn(arguments);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(Json::parse(run.out)["relabelled_vertices"],
              !method.empty() && method.back() == "greedy" ? 3 : 2);
  }
}

TEST(Refine, TellsTheStepsOfTheLegalisation) {
  const ProgramRun greedy = limn(
      {"refine", "cube", "--paint", "faces=0:=1", "--legalize", "greedy", "--json", "--steps"});
  ASSERT_EQ(greedy.exit_code, 0) << greedy.err;
  const Json steps = Json::parse(greedy.out)["legalisation"];
  EXPECT_EQ(steps["order"], "greedy");
  ASSERT_EQ(steps["moves"].size(), 3U);
  for (const Json& move : steps["moves"]) {
    EXPECT_EQ(move["label"], 1);
    EXPECT_EQ(move["vertices"].size(), 1U);
  }
  EXPECT_EQ(steps["moves"][0]["illegal_neighbours"], 2) << "a ring of four";
  EXPECT_EQ(steps["moves"][0]["cost"], 0);

  const ProgramRun ahead = limn({"refine", "cube", "--paint", "faces=0:=1", "--json", "--steps"});
  ASSERT_EQ(ahead.exit_code, 0) << ahead.err;
  const Json scored = Json::parse(ahead.out)["legalisation"];
  EXPECT_EQ(scored["order"], "look-ahead");
  EXPECT_EQ(scored["moves"].size(), 2U);
  EXPECT_TRUE(scored["moves"][0]["score"].is_number());

  EXPECT_EQ(limn({"refine", "cube", "--paint", "all:+1", "--steps"}).exit_code, 2)
      << "it is a part of --json";
}

TEST(Refine, OneFaceOfTheCubeToDepthFive) {
  const ScratchFolder scratch;
  const ProgramRun run = limn({"refine", "cube", "--paint", "faces=0:=5", "--legalize", "greedy",
                               "--json", "-o", scratch.file("out.obj")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json numbers = Json::parse(run.out);
  EXPECT_EQ(numbers["faces"], 2484);
  EXPECT_EQ(numbers["vertices"], 2486);
  EXPECT_EQ(numbers["relabelled_vertices"], 3);
  EXPECT_EQ(numbers["uniform_faces"], 6 * 1024);
  EXPECT_EQ(numbers["watertight"], true);

  const auto refined = import_mesh(scratch.file("out.obj"));
  ASSERT_TRUE(refined) << to_string(refined.error());
  EXPECT_EQ(refined->mesh->face_count(), 2484U);
  EXPECT_EQ(refined->mesh->vertex_count(), 2486U);
  EXPECT_TRUE(refined->mesh->is_closed());
  EXPECT_FALSE(refined->report.is_mended());
}

TEST(Refine, ByLoopOnTriangles) {
  const ScratchFolder scratch;
  const ProgramRun run = limn({"refine", "icosahedron", "--adaptive", "loop", "--paint",
                               "faces=0:=3", "--json", "-o", scratch.file("out.obj")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json numbers = Json::parse(run.out);
  EXPECT_EQ(numbers["deepened_faces"], 9);
  EXPECT_EQ(numbers["uniform_faces"], 20 * 64);
  EXPECT_EQ(numbers["watertight"], true);
  const auto refined = import_mesh(scratch.file("out.obj"));
  ASSERT_TRUE(refined) << to_string(refined.error());
  EXPECT_EQ(refined->mesh->face_count(), numbers["faces"].get<std::size_t>());
  EXPECT_TRUE(refined->mesh->is_closed());

  const ProgramRun quads = limn({"refine", "cube", "--adaptive", "loop", "--paint", "all:=1"});
  EXPECT_EQ(quads.exit_code, 1);
  EXPECT_THAT(quads.err, HasSubstr("Triangulate the mesh first"));
}

TEST(Refine, SaysThatAProjectShowsAScheme) {
  const ScratchFolder scratch;
  Document document = make_document(load_bundled_mesh("cube").value(), "cube");
  document.scheme = SchemeSettings{.scheme = Scheme::kDooSabin};
  ASSERT_TRUE(save_project(scratch.file("dual.limn"), document, std::nullopt));
  const ProgramRun run = limn({"refine", scratch.file("dual.limn"), "--paint", "all:=1"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("the project shows Doo-Sabin"));
}

TEST(Refine, RulesApplyInTheOrderGiven) {
  const Json one_after = Json::parse(
      limn({"refine", "cube", "--json", "--paint", "all:=2", "--paint", "faces=0-2:-1"}).out);
  EXPECT_EQ(one_after["faces_by_depth"], (Json{{"1", 3}, {"2", 3}}));
  const Json one_before = Json::parse(
      limn({"refine", "cube", "--json", "--paint", "faces=0-2:-1", "--paint", "all:=2"}).out);
  EXPECT_EQ(one_before["faces_by_depth"], (Json{{"2", 6}}));
}

TEST(Refine, ReadsRulesFromAFile) {
  const ScratchFolder scratch;
  write_file(scratch.file("rules"),
             "# first all of it\nall:+1\n\ndihedral>80:+1  # and the edges\n");
  const ProgramRun run = limn({"refine", "cube", "--json", "--paint", "@" + scratch.file("rules")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(Json::parse(run.out)["faces_by_depth"], (Json{{"2", 6}}));
}

TEST(Refine, PaintsRegionsAndWholePaintings) {
  const auto depths_after = [](std::vector<std::string> rules) {
    std::vector<std::string> words = {"refine", "cube", "--json"};
    for (std::string& rule : rules) {
      words.insert(words.end(), {"--paint", std::move(rule)});
    }
    const ProgramRun run = limn(words);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return Json::parse(run.out)["faces_by_depth"];
  };
  EXPECT_EQ(depths_after({"faces=0:=2", "mirror=x"}), (Json{{"0", 4}, {"2", 2}}));
  EXPECT_EQ(depths_after({"faces=0:=2", "invert"}), (Json{{"0", 1}, {"2", 5}}));
  EXPECT_EQ(depths_after({"smart=0,90:=1"}), (Json{{"0", 1}, {"1", 5}}));
  EXPECT_EQ(depths_after({"faces=0:=2", "flood=0:+1", "grow"}), (Json{{"0", 1}, {"3", 5}}));
  EXPECT_EQ(depths_after({"connected=4:=3", "faces=1:=0", "shrink"}), (Json{{"0", 5}, {"3", 1}}));
  const ProgramRun wrong = limn({"refine", "cube", "--paint", "flood=6:+1"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("There is no face 6"));
}

TEST(Refine, WritesToStandardOutputWhatItWritesToAFile) {
  const ScratchFolder scratch;
  const std::vector<std::string> rules = {"--paint", "dihedral>20:=2", "--paint", "faces=0-9:+1"};
  std::vector<std::string> to_file = {"refine", "creature", "-o", scratch.file("out.obj")};
  std::vector<std::string> to_stream = {"refine", "creature", "-o", "-"};
  to_file.insert(to_file.end(), rules.begin(), rules.end());
  to_stream.insert(to_stream.end(), rules.begin(), rules.end());
  ASSERT_EQ(limn(to_file).exit_code, 0);
  EXPECT_EQ(limn(to_stream).out, read_file(scratch.file("out.obj")));
}

TEST(Refine, GivesTheSameBytesForAnyNumberOfThreads) {
  const auto with_threads = [](const char* threads) {
    return limn({"refine", "creature", "--paint", "all:=2", "--paint", "faces=0-40:=4", "-o", "-",
                 "--threads", threads})
        .out;
  };
  const std::string one = with_threads("1");
  EXPECT_GT(one.size(), 100'000U);
  EXPECT_EQ(one, with_threads("2"));
  EXPECT_EQ(one, with_threads("7"));
}

TEST(Refine, OverBudgetIsItsOwnExitCodeAndWritesNothing) {
  const ScratchFolder scratch;
  const ProgramRun run = limn(
      {"refine", "cube", "--paint", "all:=6", "--budget", "24575", "-o", scratch.file("out.obj")});
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_THAT(run.err, HasSubstr("24576"));
  EXPECT_FALSE(std::filesystem::exists(scratch.file("out.obj")));
  EXPECT_EQ(limn({"refine", "cube", "--paint", "all:=6", "--budget", "24576"}).exit_code, 0);
}

TEST(Refine, CtrlCCancelsWithItsOwnExitCodeAndWritesNothing) {
  // Nineteen million faces take several seconds; the interrupt comes after one.
  const ScratchFolder scratch;
  const ProgramRun run = run_program(
      "/usr/bin/timeout", {"--preserve-status", "--signal=INT", "1", LIMN_PROGRAM, "refine",
                           "creature", "--paint", "all:=7", "-o", scratch.file("out.obj")});
  EXPECT_EQ(run.exit_code, 130);
  EXPECT_THAT(run.err, HasSubstr("cancelled"));
  EXPECT_FALSE(std::filesystem::exists(scratch.file("out.obj")));
}

TEST(Refine, StopsAfterTheLevelsAskedFor) {
  const Json numbers =
      Json::parse(limn({"refine", "cube", "--json", "--paint", "all:=4", "--levels", "2"}).out);
  EXPECT_EQ(numbers["levels"], 2);
  EXPECT_EQ(numbers["faces"], 6 * 16);
}

TEST(Refine, VisibleRaisesTheFacesThatTheCameraSees) {
  const ProgramRun front =
      limn({"refine", "cube", "--json", "--paint", "visible:+1", "--view", "front"});
  ASSERT_EQ(front.exit_code, 0) << front.err;
  EXPECT_EQ(Json::parse(front.out)["faces_by_depth"], (Json{{"0", 5}, {"1", 1}}));
  const ProgramRun iso =
      limn({"refine", "cube", "--json", "--paint", "visible:+1", "--view", "iso"});
  EXPECT_EQ(Json::parse(iso.out)["faces_by_depth"], (Json{{"0", 3}, {"1", 3}}));
}

TEST(Refine, SavesThePaintingAsAProjectAndReadsItBack) {
  const ScratchFolder scratch;
  const std::string project = scratch.file("painted.limn");
  ASSERT_EQ(limn({"refine", "cube", "--paint", "faces=2:=3", "--non-quads", "where-painted", "-o",
                  project})
                .exit_code,
            0);
  const Json numbers = Json::parse(limn({"refine", project, "--json"}).out);
  EXPECT_EQ(numbers["faces_by_depth"], (Json{{"0", 5}, {"3", 1}}));
  EXPECT_EQ(numbers["faces"], 228);
}

TEST(Refine, AFailedWriteLeavesTheOldFile) {
  const ScratchFolder scratch;
  const ProgramRun run = limn({"refine", "cube", "-o", scratch.file("no/such/folder/out.obj")});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("no/such/folder"));
}

TEST(Refine, WritesTheBoundaryRuleInForce) {
  for (const char* levels : {"0", "1"}) {
    const ProgramRun run = limn({"refine", "grid", "--paint", "all:+1", "--levels", levels,
                                 "--corners", "smooth", "-o", "-"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("\nt interpolateboundary 1/0/0 2\n"));
    const ProgramRun again = limn({"refine", "-", "--levels", "0", "-o", "-"}, run.out);
    EXPECT_THAT(again.out, HasSubstr("\nt interpolateboundary 1/0/0 2\n"));
  }
  const ProgramRun closed = limn({"refine", "cube", "--paint", "all:+1", "-o", "-"});
  EXPECT_THAT(closed.out, testing::Not(HasSubstr("interpolateboundary")));
}

TEST(Refine, PositionsOnTheLimitDoNotDependOnTheLevel) {
  const auto corners = [](const char* depth, const char* positions) {
    const ProgramRun run =
        limn({"refine", "cube", "--paint", depth, "--positions", positions, "-o", "-"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const auto mesh = import_obj(run.out, "out").value().mesh;
    return std::vector<glm::dvec3>(mesh->positions().begin(), mesh->positions().begin() + 8);
  };
  const auto one = corners("all:=1", "limit");
  const auto two = corners("all:=2", "limit");
  const auto level = corners("all:=1", "level");
  for (std::size_t v = 0; v < 8; ++v) {
    EXPECT_LT(glm::distance(one[v], two[v]), 1e-6);
    EXPECT_GT(glm::distance(one[v], level[v]), 0.01);
  }
}

TEST(Refine, TextureIsSmoothInsideOrLinear) {
  // Two by two squares whose middle is drawn aside on the texture.
  std::string text;
  for (int i = 0; i < 9; ++i) {
    const std::string x = std::to_string(i % 3);
    const std::string y = std::to_string(i / 3);
    text += "v " + x + " " + y + " 0\nvt " + (i == 4 ? "1.5 1.5" : x + " " + y) + "\n";
  }
  text += "f 1/1 2/2 5/5 4/4\nf 2/2 3/3 6/6 5/5\nf 4/4 5/5 8/8 7/7\nf 5/5 6/6 9/9 8/8\n";
  const auto middle = [&](const char* rule) {
    const ProgramRun run =
        limn({"refine", "-", "--paint", "all:=1", "--texture", rule, "-o", "-"}, text);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const auto mesh = import_obj(run.out, "out").value().mesh;
    for (std::size_t c = 0; c < mesh->topology().corner_vertices.size(); ++c) {
      if (mesh->topology().corner_vertices[c] == 4) {
        return mesh->texture().values[mesh->texture().corner_values[c]];
      }
    }
    return glm::dvec2(-1.0);
  };
  EXPECT_EQ(middle("linear"), glm::dvec2(1.5));
  // At valence 4 half of a point stays, the rest is the mean of its neighbours and that of the
  // faces' centroids.
  const glm::dvec2 smooth = middle("smooth-inside");
  EXPECT_NEAR(smooth.x, 0.5 * 1.5 + 0.25 * 1.0 + 0.25 * (1.0 + 0.5 / 4.0), 1e-6);
  EXPECT_EQ(smooth.x, smooth.y);
}

TEST(Refine, CreasesEdgesByRules) {
  const ProgramRun run = limn({"refine", "cube", "--levels", "0", "-o", "-", "--crease",
                               "angle>80:=2", "--crease", "creased:+0.5"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto creased = import_obj(run.out, "out");
  ASSERT_TRUE(creased) << to_string(creased.error());
  EXPECT_EQ(creased->mesh->creases().edge_sharpness, std::vector<float>(12, 2.5F));
  const ProgramRun cleared =
      limn({"refine", "-", "--levels", "0", "-o", "-", "--crease", "clear"}, run.out);
  ASSERT_EQ(cleared.exit_code, 0) << cleared.err;
  EXPECT_THAT(cleared.out, testing::Not(testing::HasSubstr("crease")));
  const ProgramRun misspelt = limn({"refine", "cube", "--crease", "angel>3:=2"});
  EXPECT_EQ(misspelt.exit_code, 2);
  EXPECT_THAT(misspelt.err, testing::HasSubstr("which edges to crease"));
}

TEST(Refine, GoesFinerThanAFace) {
  const ScratchFolder scratch;
  const auto faces = [&](std::vector<std::string> words) {
    words.insert(words.end(), {"--json", "-o", scratch.file("out.obj")});
    const ProgramRun run = limn(words);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return Json::parse(run.out);
  };
  const Json fine = faces({"refine", "cube", "--fine", "0/2/3/0=5", "--fine", "4/1/0/1=3"});
  EXPECT_EQ(fine["demands"], 2);
  EXPECT_EQ(fine["levels"], 5);
  EXPECT_EQ(fine["watertight"], true);
  EXPECT_GE(fine["faces"], 64 + 16);
  EXPECT_LT(fine["faces"], 1000);
  const Json whole = faces({"refine", "cube", "--paint", "faces=0:=5"});
  EXPECT_LT(fine["faces"], whole["faces"]);

  // A project keeps them, and none drops them.
  ASSERT_TRUE(save_project(
      scratch.file("fine.limn"),
      [] {
        Document document = make_document(load_bundled_mesh("cube").value(), "");
        document.demands.raise(std::vector{FineDemand{{0, 0, 2, 3, 0}, 5}});
        return document;
      }(),
      std::nullopt));
  EXPECT_EQ(faces({"refine", scratch.file("fine.limn")})["levels"], 5);
  EXPECT_EQ(faces({"refine", scratch.file("fine.limn"), "--fine", "none"})["levels"], 0);
  const ProgramRun converted =
      limn({"convert", scratch.file("fine.limn"), scratch.file("left_behind.obj")});
  EXPECT_EQ(converted.exit_code, 0);
  EXPECT_THAT(converted.err, HasSubstr("1 demand on faces finer than control faces stay behind"));

  const auto complaint = [](const std::string& rule) {
    const ProgramRun run = limn({"refine", "cube", "--fine", rule});
    EXPECT_EQ(run.exit_code, 2) << rule;
    return run.err;
  };
  EXPECT_THAT(complaint("0/2/3"), HasSubstr("is not understood"));
  EXPECT_THAT(complaint("0/2/3/0=5x"), HasSubstr("is not understood"));
  EXPECT_THAT(complaint("0/2/3/0=300"), HasSubstr("is not understood"));
  EXPECT_THAT(complaint("6/2/3/0=5"), HasSubstr("no face of level 2"));
  EXPECT_THAT(complaint("0/2/4/0=5"), HasSubstr("no face of level 2"));
  EXPECT_THAT(complaint("0.1/2/3/0=5"), HasSubstr("no face of level 2"));
  EXPECT_THAT(complaint("0/2/3/0=2"), HasSubstr("3..10"));
}

}  // namespace
}  // namespace limn::test
