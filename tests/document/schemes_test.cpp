// Uniform schemes and edge edits as part of a document: commands, projects, and what is derived.
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "document/project_fixture.h"
#include "limn/document/commands.h"
#include "limn/document/history.h"
#include "limn/document/scheme_refinement.h"

namespace limn {
namespace {

using test::opened;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr SchemeSettings kWarren{.scheme = Scheme::kLoop, .weights = LoopWeights::kWarren};

Document painted(std::string_view name) {
  Document document = opened(name);
  for (std::size_t f = 0; f < document.depths.size(); ++f) {
    document.depths.set(f, static_cast<int>(f % 5));
  }
  return document;
}

std::array<std::uint32_t, 3> triangle(const ControlMesh& mesh, std::size_t f) {
  const auto face = mesh.face(f);
  return {face[0], face[1], face[2]};
}

TEST(SchemeCommand, SetsSchemeAndStageTogetherAndUndoes) {
  Document document = painted("icosahedron");
  History history;
  const Revisions before = document.revisions;
  history.execute(document, scheme_command(kWarren, {false, 3}, "show Loop"));
  EXPECT_EQ(document.scheme, kWarren);
  EXPECT_EQ(document.stage, (Stage{false, 3}));
  EXPECT_GT(document.revisions.stage, before.stage);
  EXPECT_EQ(document.revisions.control, before.control);
  EXPECT_EQ(document.revisions.depths, before.depths);
  EXPECT_EQ(history.undo_name(), "show Loop");
  history.undo(document);
  EXPECT_EQ(document.scheme, std::nullopt);
  EXPECT_EQ(document.stage, Stage{});
  history.redo(document);
  EXPECT_EQ(document.scheme, kWarren);
  history.execute(document, scheme_command(std::nullopt, {true, kAllLevels}, "subdivide"));
  EXPECT_EQ(document.scheme, std::nullopt);
  history.undo(document);
  EXPECT_EQ(document.stage, (Stage{false, 3}));
}

TEST(SchemeCommand, TakesTheCornerRuleOfTheSettings) {
  Document document = opened("grid");
  document.settings.corners = CornerRule::kSmooth;
  EXPECT_EQ(shown_scheme(document), std::nullopt);
  document.scheme = SchemeSettings{.scheme = Scheme::kDooSabin};
  EXPECT_EQ(shown_scheme(document)->corners, CornerRule::kSmooth);
  EXPECT_EQ(shown_scheme(document)->scheme, Scheme::kDooSabin);
}

TEST(EdgeCommands, HalvesKeepTheDepthOfTheirFace) {
  Document document = painted("icosahedron");
  document.stage = {true, 2};
  document.scheme = kWarren;
  const std::shared_ptr<const ControlMesh> before = document.control;
  const FlatTopology& topology = before->topology();
  const std::uint32_t edge = 7;
  const std::size_t v = before->vertex_count();
  auto command = split_edge_command(document, edge);
  ASSERT_TRUE(command);
  (*command)->apply(document);
  ASSERT_EQ(document.control->face_count(), 22U);
  ASSERT_EQ(document.depths.size(), 22U);
  EXPECT_EQ(document.stage, (Stage{true, 2})) << "what is shown follows the edit";
  EXPECT_EQ(document.scheme, kWarren);
  for (const std::uint32_t corner : topology.edge_corners[edge]) {
    const std::uint32_t whole = topology.corner_faces[corner];
    // The vertex opposite is in both halves and in no other face with the new vertex.
    const std::uint32_t ahead =
        topology.corner_vertices[topology.face_offsets[whole] +
                                 (corner - topology.face_offsets[whole] + 2) % 3];
    int halves = 0;
    for (std::size_t f = 0; f < 22; ++f) {
      const auto face = triangle(*document.control, f);
      if (std::ranges::count(face, v) == 1 && std::ranges::count(face, ahead) == 1) {
        EXPECT_EQ(document.depths[f], static_cast<int>(whole % 5)) << f;
        ++halves;
      }
    }
    EXPECT_EQ(halves, 2);
  }
  (*command)->revert(document);
  EXPECT_EQ(document.control, before);
  EXPECT_EQ(document.depths, painted("icosahedron").depths);
  EXPECT_EQ(document.stage, (Stage{true, 2}));
}

TEST(EdgeCommands, AFlipKeepsThePaintingAndComesBackByUndo) {
  Document document = painted("icosahedron");
  const std::shared_ptr<const ControlMesh> before = document.control;
  History history;
  auto command = flip_edge_command(document, 3);
  ASSERT_TRUE(command);
  history.execute(document, *std::move(command));
  EXPECT_NE(document.control, before);
  EXPECT_EQ(document.control->edge_count(), before->edge_count());
  EXPECT_EQ(document.depths, painted("icosahedron").depths);
  EXPECT_EQ(history.undo_name(), "flip edge");
  history.undo(document);
  EXPECT_EQ(document.control, before);
}

TEST(EdgeCommands, RefusalsSayWhyAndChangeNothing) {
  const Document document = painted("cube");
  const auto split = split_edge_command(document, 0);
  ASSERT_FALSE(split);
  EXPECT_EQ(split.error().kind, ErrorKind::kFailed);
  EXPECT_FALSE(split.error().message.empty());
  EXPECT_FALSE(flip_edge_command(document, 0));
}

TEST(FitCommand, TriangulatesInPlaceAndKeepsDepths) {
  Document document = painted("mixed");  // 20 triangles, 30 quads, 12 pentagons.
  document.stage = {true, kAllLevels};
  const auto command = fit_command(document, Fitting::kTriangulate);
  command->apply(document);
  ASSERT_EQ(document.control->face_count(), 20U + 2 * 30 + 3 * 12);
  EXPECT_EQ(document.stage, Stage{});
  std::vector<int> expected;
  const Document before = painted("mixed");
  for (std::size_t f = 0; f < before.depths.size(); ++f) {
    expected.insert(expected.end(), before.control->face(f).size() - 2, before.depths[f]);
  }
  for (std::size_t f = 0; f < expected.size(); ++f) {
    EXPECT_EQ(document.depths[f], expected[f]) << f;
  }
  EXPECT_TRUE(check_fits(*document.control, Scheme::kLoop));
  command->revert(document);
  EXPECT_EQ(document.control->face_count(), 62U);
  EXPECT_EQ(document.depths, before.depths);
  EXPECT_EQ(document.stage, (Stage{true, kAllLevels}));
}

TEST(FitCommand, OneStepOfCatmullClarkTakesOneLevelOff) {
  Document document = painted("icosahedron");
  const auto command = fit_command(document, Fitting::kOneCatmullClarkStep);
  command->apply(document);
  ASSERT_EQ(document.control->face_count(), 60U);
  EXPECT_TRUE(check_fits(*document.control, Scheme::kKobbelt));
  const Document before = painted("icosahedron");
  for (std::size_t f = 0; f < 60; ++f) {
    EXPECT_EQ(document.depths[f], std::max(before.depths[f / 3] - 1, 0)) << f;
    // It lies in the face whose depth it has: every quad keeps one of that face's vertices.
    const auto quad = document.control->face(f);
    EXPECT_TRUE(std::ranges::any_of(quad, [&](std::uint32_t v) {
      return std::ranges::count(before.control->face(f / 3), v) == 1;
    })) << f;
  }
}

TEST(ControlCommands, LeavePaintingByLoopWhereTheMeshIsNoneForIt) {
  Document document = painted("icosahedron");
  document.settings.scheme = RefinementScheme::kLoop;
  document.settings.weights = LoopWeights::kWarren;
  History history;
  const Revisions before = document.revisions;
  history.execute(document, fit_command(document, Fitting::kOneCatmullClarkStep));
  EXPECT_EQ(document.settings.scheme, RefinementScheme::kCatmullClark);
  EXPECT_GT(document.revisions.stage, before.stage);
  history.undo(document);
  EXPECT_EQ(document.settings.scheme, RefinementScheme::kLoop);
  EXPECT_EQ(document.settings.weights, LoopWeights::kWarren);
  auto split = split_edge_command(document, 0);
  ASSERT_TRUE(split);
  history.execute(document, *std::move(split));
  EXPECT_EQ(document.settings.scheme, RefinementScheme::kLoop) << "all triangles still";
  history.execute(document, replace_control_command(opened("cube").control, "apply"));
  EXPECT_EQ(document.settings.scheme, RefinementScheme::kCatmullClark);
  history.undo(document);
  EXPECT_EQ(document.settings.scheme, RefinementScheme::kLoop);
}

class SchemeProject : public test::ProjectFixture {
 protected:
  std::string scheme_text() {
    Document document = painted("icosahedron");
    document.scheme = kWarren;
    document.stage.levels = 2;
    EXPECT_TRUE(save_project(path_, document, std::nullopt));
    return test::without_checksum(test::read_file(path_));
  }
  std::string complaint_about(std::string_view piece, std::string_view other) {
    std::string text = scheme_text();
    const std::size_t at = text.find(piece);
    EXPECT_NE(at, std::string::npos) << piece;
    return complaint(text.replace(at, piece.size(), other));
  }
};

TEST_F(SchemeProject, RoundTripsEverySchemeWithItsChoices) {
  for (const SchemeInfo& info : schemes()) {
    Document document = painted(info.takes == FaceKinds::kTriangles ? "icosahedron" : "cube");
    document.scheme = SchemeSettings{.scheme = info.scheme};
    document.stage.levels = 3;
    if (info.scheme == Scheme::kLoop) {
      document.scheme->weights = LoopWeights::kWarren;
    }
    document.scheme->averages = info.scheme == Scheme::kLinear;
    ASSERT_TRUE(save_project(path_, document, std::nullopt));
    const Result<Project> loaded = load_project(path_);
    ASSERT_TRUE(loaded) << loaded.error().message;
    test::expect_same_document(document, loaded->document);
  }
}

TEST_F(SchemeProject, RoundTripsAdaptiveLoop) {
  for (const LoopWeights weights : {LoopWeights::kOriginal, LoopWeights::kWarren}) {
    Document document = test::opened("icosahedron");
    document.settings.scheme = RefinementScheme::kLoop;
    document.settings.weights = weights;
    ASSERT_TRUE(save_project(path_, document, std::nullopt));
    const Result<Project> loaded = load_project(path_);
    ASSERT_TRUE(loaded) << to_string(loaded.error());
    test::expect_same_document(loaded->document, document);
    EXPECT_EQ(loaded->document.settings, document.settings);
  }
}

TEST_F(SchemeProject, OlderProgramsAreToldApartOnlyByWhatTheyWouldLose) {
  EXPECT_THAT(cube_text(), HasSubstr("\"version\": 1"));
  EXPECT_THAT(scheme_text(), HasSubstr("\"version\": 3"));
}

TEST_F(SchemeProject, NamesTheCulprit) {
  EXPECT_THAT(complaint_about("\"name\": \"loop\"", "\"name\": \"lop\""),
              HasSubstr("/scheme/name"));
  EXPECT_THAT(complaint_about("\"warren\"", "\"waren\""), HasSubstr("/scheme/weights"));
  EXPECT_THAT(complaint_about("\"levels\": 2", "\"levels\": \"all\""), HasSubstr("/stage/levels"));
  EXPECT_THAT(complaint_about("\"levels\": 2", "\"levels\": 13"), HasSubstr("/stage/levels"));
  const std::string misfit =
      complaint_about("\"name\": \"loop\",\n    \"weights\": \"warren\"", "\"name\": \"kobbelt\"");
  EXPECT_THAT(misfit, HasSubstr("/scheme"));
}

TEST_F(SchemeProject, RefusesPaintingByLoopOnWhatIsNoTriangleMesh) {
  Document document = painted("cube");
  document.settings.scheme = RefinementScheme::kLoop;
  ASSERT_TRUE(save_project(path_, document, std::nullopt));
  const Result<Project> loaded = load_project(path_);
  ASSERT_FALSE(loaded);
  EXPECT_EQ(loaded.error().kind, ErrorKind::kBadInput);
  EXPECT_THAT(loaded.error().message, HasSubstr("/settings/adaptive"));
}

TEST(DeriveScheme, GivesEveryLevelWithItsCountsAndTheMeshOfTheLast) {
  const Document document = opened("icosahedron");
  IgnoreProgress progress;
  const auto derived = derive_scheme(*document.control, {.scheme = Scheme::kLoop}, {3}, progress);
  ASSERT_TRUE(derived);
  ASSERT_EQ(derived->steps.size(), 4U);
  for (int level = 0; level <= 3; ++level) {
    const SchemeStep& step = derived->steps[static_cast<std::size_t>(level)];
    const auto faces = std::uint64_t{20} << (2 * level);
    EXPECT_EQ(step.level, level);
    EXPECT_EQ(step.counts, (SchemeCounts{faces / 2 + 2, faces * 3 / 2, faces})) << level;
  }
  EXPECT_EQ(derived->steps[0].seconds, 0.0);
  EXPECT_EQ(derived->mesh->face_count(), 1280U);
  EXPECT_EQ(derived->mesh->vertex_count(), 642U);
  const double part = static_cast<double>(scheme_bytes(derived->steps[3].counts)) /
                      static_cast<double>(derived->mesh->bytes());
  EXPECT_GT(part, 0.8);
  EXPECT_LT(part, 1.5);
}

TEST(DeriveScheme, RefusesWhatIsOverBudgetAndWhatDoesNotFit) {
  const Document document = opened("cube");
  IgnoreProgress progress;
  const auto large =
      derive_scheme(*document.control, {.scheme = Scheme::kCatmullClark}, {3, 100}, progress);
  ASSERT_FALSE(large);
  EXPECT_EQ(large.error().kind, ErrorKind::kOverBudget);
  const auto misfit = derive_scheme(*document.control, {.scheme = Scheme::kLoop}, {1}, progress);
  ASSERT_FALSE(misfit);
  EXPECT_EQ(misfit.error().kind, ErrorKind::kFailed);
}

TEST(SchemeBytes, DoNotOverflow) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(scheme_bytes({kMost, kMost, kMost}), kMost);
  EXPECT_EQ(scheme_bytes({1, 2, 3}), 13U + 16U + 27U);
}

}  // namespace
}  // namespace limn
