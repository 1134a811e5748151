#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "limn/mesh/import.h"
#include "limn_program.h"

namespace limn::test {
namespace {

using Json = nlohmann::json;
using testing::ContainsRegex;
using testing::HasSubstr;

std::shared_ptr<const ControlMesh> mesh_of(const std::string& obj) {
  const auto imported = import_obj(obj, "output");
  EXPECT_TRUE(imported) << to_string(imported.error());
  EXPECT_FALSE(imported->report.is_mended());
  return imported->mesh;
}

TEST(Subdivide, LoopWithWarrensWeights) {
  const ScratchFolder scratch;
  const ProgramRun run = limn({"subdivide", "icosahedron", "--scheme", "loop", "--weights",
                               "warren", "--levels", "3", "-o", scratch.file("out.obj"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json report = Json::parse(run.out);
  EXPECT_EQ(report["scheme"], "loop");
  EXPECT_EQ(report["weights"], "warren");
  EXPECT_EQ(report["fitted"], false);
  ASSERT_EQ(report["levels"].size(), 3u);
  EXPECT_EQ(report["levels"][2]["vertices"], 642);
  EXPECT_EQ(report["levels"][2]["edges"], 1920);
  EXPECT_EQ(report["levels"][2]["faces"], 1280);
  // Time and size of every step for people.
  EXPECT_THAT(run.err, HasSubstr("level 1: 42 vertices, 120 edges, 80 faces, "));
  EXPECT_THAT(run.err, HasSubstr("level 3: 642 vertices, 1920 edges, 1280 faces, "));

  const auto finer = import_mesh(scratch.file("out.obj"));
  ASSERT_TRUE(finer) << to_string(finer.error());
  EXPECT_EQ(finer->mesh->face_count(), 1280u);
}

TEST(Subdivide, WeightsPlaceVertices) {
  // An old vertex of valence 5 keeps 1 - 5 beta of itself: on the icosahedron, where neighbours are
  // 1 / sqrt(5) along its axis, that is all there is to it.
  const auto height = [](const std::string& weights) {
    const ProgramRun run =
        limn({"subdivide", "icosahedron", "--scheme", "loop", "--weights", weights, "-o", "-"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return glm::length(mesh_of(run.out)->positions()[0]);
  };
  const double around = 0.375 + 0.25 * std::cos(2.0 * std::acos(-1.0) / 5.0);
  const double loops = 0.625 - around * around;
  EXPECT_NEAR(height("original"), 1.0 - loops + loops / std::sqrt(5.0), 1e-6);
  EXPECT_NEAR(height("warren"), 1.0 - 0.375 + 0.375 / std::sqrt(5.0), 1e-6);
}

TEST(Subdivide, EverySchemeSubdividesEveryMeshThatIsMadeToFit) {
  for (const char* scheme : {"linear", "catmull-clark", "loop", "butterfly", "kobbelt", "sqrt3",
                             "doo-sabin", "midedge", "biquartic"}) {
    for (const char* mesh : {"mixed", "grid", "torus_open"}) {
      const ProgramRun run =
          limn({"subdivide", mesh, "--scheme", scheme, "--levels", "2", "--fit", "-o", "-"});
      ASSERT_EQ(run.exit_code, 0) << scheme << " " << mesh << ": " << run.err;
      EXPECT_GT(mesh_of(run.out)->face_count(), 100u) << scheme << " " << mesh;
    }
  }
}

TEST(Subdivide, RefusesAMeshThatDoesNotFitAndSaysWhatWould) {
  const ProgramRun refused = limn({"subdivide", "cube", "--scheme", "loop"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, HasSubstr("face 0 has 4 sides"));
  EXPECT_THAT(refused.err, HasSubstr("Triangulate"));
  EXPECT_THAT(refused.err, HasSubstr("--fit"));
  const ProgramRun fitted = limn({"subdivide", "cube", "--scheme", "loop", "--fit", "--json"});
  ASSERT_EQ(fitted.exit_code, 0) << fitted.err;
  EXPECT_THAT(fitted.err, HasSubstr("cut into triangles"));
  EXPECT_EQ(Json::parse(fitted.out)["fitted"], true);
  EXPECT_EQ(Json::parse(fitted.out)["levels"][0]["faces"], 48);

  const ProgramRun quads =
      limn({"subdivide", "icosahedron", "--scheme", "kobbelt", "--fit", "--json"});
  ASSERT_EQ(quads.exit_code, 0) << quads.err;
  EXPECT_THAT(quads.err, HasSubstr("one Catmull-Clark step"));
  EXPECT_EQ(Json::parse(quads.out)["levels"][0]["faces"], 240);
}

TEST(Subdivide, OffersNoFittingThatDoesNotHelp) {
  const ProgramRun run = limn({"subdivide", "-", "--scheme", "loop", "--fit"},
                              "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("back to back"));
  EXPECT_THAT(run.err, testing::Not(HasSubstr("--fit")));
}

TEST(Subdivide, HoldsToTheBudgetBeforeAnyWork) {
  const ProgramRun run =
      limn({"subdivide", "cube", "--scheme", "catmull-clark", "--levels", "9", "--budget", "1000"});
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_THAT(run.err, HasSubstr("1572864 faces"));
  EXPECT_THAT(run.err, testing::Not(HasSubstr("level 1")));
}

TEST(Subdivide, GivesTheSameBytesForAnyNumberOfThreads) {
  for (const char* scheme : {"loop", "butterfly", "biquartic"}) {
    const auto with_threads = [&](const char* threads) {
      return limn({"subdivide", "torus_open", "--scheme", scheme, "--fit", "--levels", "4", "-o",
                   "-", "--threads", threads})
          .out;
    };
    const std::string one = with_threads("1");
    EXPECT_GT(one.size(), 100000u);
    EXPECT_EQ(one, with_threads("2")) << scheme;
    EXPECT_EQ(one, with_threads("7")) << scheme;
  }
}

TEST(Subdivide, NoLevelsGivesTheMeshItself) {
  const ProgramRun run =
      limn({"subdivide", "cube", "--scheme", "doo-sabin", "--levels", "0", "-o", "-"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(mesh_of(run.out)->face_count(), 6u);
}

TEST(Subdivide, MistakesAreUsageErrors) {
  EXPECT_EQ(limn({"subdivide", "cube"}).exit_code, 2);
  EXPECT_EQ(limn({"subdivide", "cube", "--scheme", "cubic"}).exit_code, 2);
  EXPECT_EQ(limn({"subdivide", "cube", "--scheme", "linear", "--levels", "13"}).exit_code, 2);
  EXPECT_EQ(limn({"subdivide", "cube", "--scheme", "linear", "-o", "out.xyz"}).exit_code, 2);
  EXPECT_EQ(limn({"subdivide", "cube", "--scheme", "linear", "-o", "-", "--json"}).exit_code, 2);
  const ProgramRun weights =
      limn({"subdivide", "cube", "--scheme", "linear", "--weights", "warren"});
  EXPECT_EQ(weights.exit_code, 2);
  EXPECT_THAT(weights.err, HasSubstr("only the scheme loop"));
  EXPECT_EQ(limn({"subdivide", "cube", "--scheme", "kobbelt", "--average"}).exit_code, 2);
}

TEST(Subdivide, AveragedLinearIsSmooth) {
  // A cube's corners: the mean of the centroids of the three quads around after the split.
  const ProgramRun run = limn({"subdivide", "cube", "--scheme", "linear", "--average", "-o", "-"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const glm::dvec3 corner = mesh_of(run.out)->positions()[0];
  const double expected = (0.5 + 0.5 + 1.0) / 3.0;
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(std::abs(corner[i]), expected, 1e-6);
  }
}

TEST(SplitAndFlip, GivesWhatLoopGives) {
  const ProgramRun by_hand = limn({"split-and-flip", "icosahedron", "-o", "-", "--levels", "2"});
  ASSERT_EQ(by_hand.exit_code, 0) << by_hand.err;
  EXPECT_THAT(by_hand.err, HasSubstr("level 2: 162 vertices, 480 edges, 320 faces, "));
  const ProgramRun direct =
      limn({"subdivide", "icosahedron", "--scheme", "loop", "--levels", "2", "-o", "-"});
  const auto one = mesh_of(by_hand.out);
  const auto other = mesh_of(direct.out);
  ASSERT_EQ(one->vertex_count(), other->vertex_count());
  ASSERT_EQ(one->face_count(), other->face_count());
  for (const glm::dvec3& p : one->positions()) {
    double nearest = 1.0;
    for (const glm::dvec3& q : other->positions()) {
      nearest = std::min(nearest, glm::distance(p, q));
    }
    EXPECT_LT(nearest, 1e-6);
  }
}

TEST(SplitAndFlip, RefusesQuadsUnlessToldToCutThem) {
  const ProgramRun refused = limn({"split-and-flip", "cube", "-o", "-"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, HasSubstr("--fit"));
  EXPECT_TRUE(refused.out.empty());
  const ProgramRun fitted = limn({"split-and-flip", "cube", "-o", "-", "--fit"});
  ASSERT_EQ(fitted.exit_code, 0) << fitted.err;
  EXPECT_EQ(mesh_of(fitted.out)->face_count(), 48u);
  EXPECT_EQ(limn({"split-and-flip", "cube", "-o", "-", "--fit", "--levels", "9", "--budget", "99"})
                .exit_code,
            4);
}

TEST(SymmetriseCommand, SplitsOrFlipsDiagonals) {
  const ProgramRun split = limn({"symmetrise", "cube_triangulated", "-o", "-"});
  ASSERT_EQ(split.exit_code, 0) << split.err;
  EXPECT_THAT(split.err, HasSubstr("6 flat pairs of triangles, 6 split"));
  EXPECT_EQ(mesh_of(split.out)->face_count(), 24u);
  for (const char* by : {"flip", "flip-alternately"}) {
    const ProgramRun flipped = limn({"symmetrise", "cube_triangulated", "-o", "-", "--by", by});
    ASSERT_EQ(flipped.exit_code, 0) << flipped.err;
    EXPECT_THAT(flipped.err, ContainsRegex("6 flat pairs of triangles, [1-5] flipped"));
    EXPECT_EQ(mesh_of(flipped.out)->face_count(), 12u);
  }
}

TEST(SymmetriseCommand, SaysWhyItCannot) {
  const ProgramRun quads = limn({"symmetrise", "cube", "-o", "-"});
  EXPECT_EQ(quads.exit_code, 1);
  EXPECT_THAT(quads.err, HasSubstr("Face 0 has 4 sides"));
  EXPECT_EQ(limn({"symmetrise", "cube_triangulated", "-o", "-", "--by", "turning"}).exit_code, 2);
  EXPECT_EQ(limn({"symmetrise", "cube_triangulated"}).exit_code, 2);
}

}  // namespace
}  // namespace limn::test
