// Demands on faces finer than control faces: in documents, commands, projects and refinements.
#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "document/project_fixture.h"
#include "limn/document/commands.h"
#include "limn/document/history.h"
#include "limn/document/refinement.h"
#include "limn/mesh/bundled.h"
#include "limn/subdivision/fine_places.h"
#include "support/shapes.h"

namespace limn {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::unique_ptr<Command> demand(const Document& document, std::vector<FineDemand> raised) {
  FineDemands demands = document.demands;
  demands.raise(raised);
  return paint_command({}, "paint finely", demands.edits_from(document.demands));
}

Refinement refined(const Document& document) {
  IgnoreProgress progress;
  const DerivedLabels labels = derive_labels(*document.control, document.depths.values(),
                                             document.settings, progress, document.demands)
                                   .value();
  RefinementOptions options;
  options.settings = document.settings;
  return derive_refinement(*document.control, labels, options, progress).value();
}

TEST(PaintCommand, ChangesDemandsAloneAndBack) {
  Document document = test::opened("cube");
  History history;
  const std::vector<FineDemand> first{{{0, 0, 2, 1, 1}, 5}, {{3, 0, 1, 0, 1}, 4}};
  const std::vector<FineDemand> second{{{0, 0, 1, 0, 0}, 6}};  // Covers the first one's first.
  const Revisions before = document.revisions;
  history.execute(document, demand(document, first));
  EXPECT_NE(document.revisions.depths, before.depths);
  EXPECT_EQ(document.revisions.control, before.control);
  EXPECT_EQ(document.revisions.stage, before.stage);
  const FineDemands after_first = document.demands;
  EXPECT_EQ(after_first.size(), 2u);
  history.execute(document, demand(document, second));
  const FineDemands after_second = document.demands;
  EXPECT_EQ(after_second, FineDemands(std::vector{first[1], second[0]}));
  history.undo(document);
  EXPECT_EQ(document.demands, after_first);
  history.undo(document);
  EXPECT_TRUE(document.demands.empty());
  history.redo(document);
  history.redo(document);
  EXPECT_EQ(document.demands, after_second);
}

TEST(PaintCommand, WithDemandsThatAreThereCountsNothing) {
  Document document = test::opened("cube");
  demand(document, {{{0, 0, 2, 1, 1}, 5}})->apply(document);
  const Revisions before = document.revisions;
  const auto again = demand(document, {{{0, 0, 2, 1, 1}, 5}, {{0, 0, 3, 2, 2}, 4}});
  again->apply(document);
  EXPECT_EQ(document.revisions.depths, before.depths);
}

TEST(Demands, GoWithTheControlMeshAndComeBackWithUndo) {
  Document document = test::opened("cube");
  History history;
  history.execute(document, demand(document, {{{0, 0, 2, 1, 1}, 5}}));
  const FineDemands painted = document.demands;
  const auto refinement = refined(document);
  history.execute(document, replace_control_command(to_control_mesh(*refinement.mesh), "apply"));
  EXPECT_TRUE(document.demands.empty());
  history.undo(document);
  EXPECT_EQ(document.demands, painted);
  history.execute(document, revert_command());
  EXPECT_TRUE(document.demands.empty());
  history.undo(document);
  EXPECT_EQ(document.demands, painted);
}

TEST(Demands, StayOnFacesThatAnEditLeavesAlone) {
  Document document = test::opened("icosahedron");
  const ControlMesh& mesh = *document.control;
  const std::uint32_t edge = 5;
  std::vector<FineDemand> everywhere;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    everywhere.push_back({{f, 1, 2, 0, 1}, 4});
  }
  demand(document, everywhere)->apply(document);
  std::vector<FineDemand> elsewhere;
  std::ranges::copy_if(everywhere, std::back_inserter(elsewhere), [&](const FineDemand& at) {
    return std::ranges::none_of(mesh.topology().edge_corners[edge], [&](std::uint32_t corner) {
      return mesh.topology().corner_faces[corner] == at.face.control_face;
    });
  });
  ASSERT_EQ(elsewhere.size(), everywhere.size() - 2);
  for (auto& command : {flip_edge_command(document, edge), split_edge_command(document, edge)}) {
    ASSERT_TRUE(command);
    (*command)->apply(document);
    EXPECT_EQ(document.demands, FineDemands(elsewhere));
    (*command)->revert(document);
    EXPECT_EQ(document.demands, FineDemands(everywhere));
  }
}

TEST(Demands, AreRefinedWatertightAndAsPredicted) {
  for (const std::string_view name : {"cube", "mixed", "grid", "torus_open"}) {
    SCOPED_TRACE(name);
    Document document = test::opened(name);
    document.depths.set(0, 1);
    const auto sides = document.control->face(1).size();
    demand(document, {{{1, sides == 4 ? 0U : 2U, 2, 1, 0}, 6}})->apply(document);
    const Refinement refinement = refined(document);
    EXPECT_TRUE(refinement.cracks.is_watertight());
    EXPECT_EQ(refinement.prediction.faces, refinement.mesh->face_count());
    EXPECT_EQ(refinement.prediction.vertices, refinement.mesh->vertex_count());
    EXPECT_EQ(refinement.prediction.levels, 6);
    EXPECT_GE(std::ranges::count(refinement.mesh->face_levels, 6), 256);
  }
}

TEST(Demands, OnAFaceOfTheRefinedMeshRaiseThatFace) {
  // What a brush on the refined view does, stroke upon stroke.
  Document document = test::opened("cube");
  document.depths.set(0, 2);
  for (int stroke = 0; stroke < 3; ++stroke) {
    IgnoreProgress progress;
    const DerivedLabels labels = derive_labels(*document.control, document.depths.values(),
                                               document.settings, progress, document.demands)
                                     .value();
    const Refinement before = refined(document);
    // A face of the finest.
    const auto finest = std::ranges::max_element(before.mesh->face_levels);
    const auto face = static_cast<std::uint32_t>(finest - before.mesh->face_levels.begin());
    const RefinedFrom from{document.control.get(), &labels.legal.labels, labels.fine.get(),
                           kAllLevels};
    const FineFace place = places_of(from, *before.mesh, {&face, 1})[0];
    ASSERT_EQ(place.level, 2 + stroke);
    demand(document, {{place, static_cast<std::uint8_t>(place.level + 1)}})->apply(document);
    const Refinement after = refined(document);
    EXPECT_TRUE(after.cracks.is_watertight());
    const auto count = [](const RefinedMesh& mesh, int level) {
      return std::ranges::count(mesh.face_levels, level);
    };
    // Its four quads, and Y-elements or whole faces around.
    EXPECT_GE(count(*after.mesh, place.level + 1), 4);
    EXPECT_LE(after.mesh->face_count(), before.mesh->face_count() + 100);
  }
}

TEST(Demands, ArePassedOverByLoop) {
  Document document = test::opened("icosahedron");
  document.settings.scheme = RefinementScheme::kLoop;
  document.depths.set(3, 2);
  const std::size_t faces = refined(document).mesh->face_count();
  demand(document, {{{1, 0, 1, 0, 0}, 4}})->apply(document);
  EXPECT_EQ(refined(document).mesh->face_count(), faces);
}

using DemandsInProjects = test::ProjectFixture;

TEST_F(DemandsInProjects, ComeBackAsTheyWere) {
  Document document = test::opened("mixed");
  std::vector<FineDemand> demands;
  for (std::uint32_t f = 0; f < document.control->face_count(); ++f) {
    const auto sides = static_cast<std::uint32_t>(document.control->face(f).size());
    demands.push_back({{f, sides == 4 ? 0 : f % sides, 3, static_cast<std::uint16_t>(f % 4), 2},
                       static_cast<std::uint8_t>(4 + f % 7)});
  }
  document.demands.raise(demands);
  ASSERT_TRUE(save_project(path_, document, std::nullopt));
  const Result<Project> loaded = load_project(path_);
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  test::expect_same_document(document, loaded->document);
  EXPECT_EQ(loaded->document.demands.size(), demands.size());
  const std::string text = test::read_file(path_);
  EXPECT_THAT(text, HasSubstr("\"version\": 5"));
  ASSERT_TRUE(save_project(path_, loaded->document, std::nullopt));
  EXPECT_EQ(test::read_file(path_), text);
}

TEST_F(DemandsInProjects, NameTheCulprit) {
  const auto with = [&](const std::string& list) {
    return complaint_with("\"mesh\": {", "\"demands\": " + list + ",\n  \"mesh\": {");
  };
  EXPECT_EQ(with("[0, 0, 2, 3, 0, 5]"), "was loaded");
  EXPECT_EQ(with("[]"), "was loaded");
  EXPECT_THAT(with("[0, 0, 2, 3, 0]"), StartsWith("/demands: has 5 numbers"));
  EXPECT_THAT(with("[0, 0, 2, 3, 0, 5, 6, 0, 2, 3, 0, 5]"), StartsWith("/demands/6: is no demand"));
  EXPECT_THAT(with("[0, 0, 2, 4, 0, 5]"), StartsWith("/demands/0: "));
  EXPECT_THAT(with("[0, 1, 2, 3, 0, 5]"), StartsWith("/demands/0: "));
  EXPECT_THAT(with("[0, 0, 2, 3, 0, 2]"), StartsWith("/demands/0: "));
  EXPECT_THAT(with("[0, 0, 2, 3, 0, 11]"), StartsWith("/demands/0: "));
  EXPECT_THAT(with("[0, 0, 258, 3, 0, 5]"), StartsWith("/demands/0: "));
  EXPECT_THAT(with("[0, 0, 2, 65539, 0, 5]"), StartsWith("/demands/0: "));
  EXPECT_THAT(with("[0, 0, 2, 3, 0, 5.0]"), StartsWith("/demands/5: must be a whole number"));
  EXPECT_THAT(with("[0, 0, -2, 3, 0, 5]"), StartsWith("/demands/2: must be a whole number"));
  EXPECT_THAT(with("[[0, 0, 2, 3, 0, 5]]"), StartsWith("/demands/0: must be a whole number"));
  EXPECT_THAT(with("{}"), StartsWith("/demands: must be a list"));
  EXPECT_THAT(with("[], \"demands\": []"), HasSubstr("twice"));
}

}  // namespace
}  // namespace limn
