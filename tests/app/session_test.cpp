// Drives a session by actions, without a window, and reads what became of the document.
#include "app/session.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "limn/mesh/import.h"
#include "limn/mesh/refined_mesh.h"
#include "support/scratch_folder.h"

namespace limn::app {
namespace {

namespace fs = std::filesystem;
using enum ui::ActionId;
using testing::HasSubstr;
using testing::IsEmpty;

class SessionTest : public testing::Test {
 protected:
  SessionTest() { session_.perform({kOpenBundled, std::string("cube")}); }

  void stroke(std::vector<std::uint32_t> faces, DepthChange change = DepthChange::add(1)) {
    session_.begin_stroke(change);
    session_.touch(faces);
    session_.end_stroke();
  }

  [[nodiscard]] std::vector<int> depths() const {
    const auto values = session_.document().depths.values();
    return {values.begin(), values.end()};
  }

  template <class T>
  [[nodiscard]] const T* modal() const {
    return std::get_if<T>(&session_.modal());
  }

  [[nodiscard]] std::string last_toast() const {
    return session_.toasts().empty() ? "" : session_.toasts().back().text;
  }

  test::ScratchFolder folder_;
  std::vector<std::uint32_t> visible_{0, 2};
  Session session_{{[] {}, [this]() -> Result<std::vector<std::uint32_t>> { return visible_; }}};
};

TEST_F(SessionTest, LeadsFromOneMendedPlaceToTheNext) {
  const fs::path path = folder_.path() / "broken.obj";
  std::ofstream(path)
      << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 5 6 7\nv 8 8 8\nf 1 2 3 4\nf 1 1 2\n";
  session_.perform({kOpen, path.string()});
  EXPECT_THAT(last_toast(), HasSubstr("1 face had fewer than three distinct vertices"));
  const auto loose = static_cast<int>(MendKind::kLooseVertex);
  EXPECT_FALSE(session_.model().mend_focus.has_value());
  session_.perform({kPreviousMend, loose});
  ASSERT_TRUE(session_.model().mend_focus.has_value());
  EXPECT_EQ(session_.model().mend_focus->position, glm::dvec3(8.0));
  session_.perform({kNextMend, loose});
  EXPECT_EQ(session_.model().mend_focus->position, glm::dvec3(5.0, 6.0, 7.0));
  session_.update(10.0);
  EXPECT_LT(glm::distance(session_.view().target, glm::dvec3(5.0, 6.0, 7.0)), 0.1);
  session_.perform({kNextMend, static_cast<int>(MendKind::kFilledUv)});
  EXPECT_EQ(session_.model().mend_focus->element, 0U);
  session_.finish_refinement();  // Else it would be the refinement that is cancelled.
  session_.perform({kCancel});
  EXPECT_FALSE(session_.model().mend_focus.has_value());
}

TEST_F(SessionTest, StrokePaintsLiveAndUndoesAsOne) {
  session_.begin_stroke(DepthChange::add(1));
  const auto before = session_.document().revisions.depths;
  EXPECT_TRUE(session_.touch(std::vector<std::uint32_t>{1, 3}));
  EXPECT_TRUE(session_.touch(std::vector<std::uint32_t>{3, 4}));
  EXPECT_FALSE(session_.touch(std::vector<std::uint32_t>{1, 4}));
  EXPECT_EQ(depths(), (std::vector<int>{0, 1, 0, 1, 1, 0}));
  EXPECT_EQ(session_.document().revisions.depths, before + 2);
  session_.end_stroke();
  session_.perform(kUndo);
  EXPECT_EQ(depths(), std::vector<int>(6, 0));
  session_.perform(kRedo);
  EXPECT_EQ(depths(), (std::vector<int>{0, 1, 0, 1, 1, 0}));
}

TEST_F(SessionTest, EscapeGivesUpTheStroke) {
  session_.begin_stroke(DepthChange::add(1));
  session_.touch(std::vector<std::uint32_t>{1, 3});
  session_.perform(kCancel);
  EXPECT_FALSE(session_.is_stroking());
  EXPECT_EQ(depths(), std::vector<int>(6, 0));
  EXPECT_FALSE(session_.history().can_undo());
}

TEST_F(SessionTest, RulesPaintAndUndo) {
  session_.perform(kRaiseAll);
  session_.perform(kRaiseVisible);
  EXPECT_EQ(depths(), (std::vector<int>{2, 1, 2, 1, 1, 1}));
  session_.perform(kLowerAll);
  EXPECT_EQ(depths(), (std::vector<int>{1, 0, 1, 0, 0, 0}));
  session_.perform({kSetDihedralThreshold, 95.0});
  session_.perform(kRaiseDihedral);
  EXPECT_EQ(depths(), (std::vector<int>{1, 0, 1, 0, 0, 0})) << "a cube's edges are bent by 90";
  session_.perform({kSetDihedralThreshold, 80.0});
  session_.perform(kRaiseDihedral);
  EXPECT_EQ(depths(), (std::vector<int>{2, 1, 2, 1, 1, 1}));
  session_.perform(kZeroAll);
  EXPECT_EQ(depths(), std::vector<int>(6, 0));
  for (int i = 0; i < 3; ++i) {
    session_.perform(kUndo);
  }
  EXPECT_EQ(depths(), (std::vector<int>{2, 1, 2, 1, 1, 1}));
}

TEST_F(SessionTest, CreasesEdgesOverTheThreshold) {
  const auto creases = [this] { return session_.document().control->creases(); };
  stroke({0}, DepthChange::set(2));
  session_.perform(kSubdivide);
  session_.finish_refinement();
  session_.perform({kSetDihedralThreshold, 95.0});
  session_.perform(kCreaseDihedral);
  EXPECT_EQ(creases(), Creases{});
  EXPECT_THAT(last_toast(), HasSubstr("No edge is bent"));
  session_.perform({kSetDihedralThreshold, 80.0});
  session_.perform({kSetCreaseSharpness, 2.5});
  EXPECT_EQ(session_.model().dihedral_edges, 12U);
  const auto* topology = &session_.document().control->topology();
  session_.perform(kCreaseDihedral);
  EXPECT_EQ(creases().edge_sharpness, std::vector<float>(12, 2.5F));
  EXPECT_EQ(&session_.document().control->topology(), topology) << "the surface is shared";
  EXPECT_EQ(session_.document().depths[0], 2) << "the painting stays";
  EXPECT_EQ(session_.document().stage.levels, kAllLevels);
  EXPECT_TRUE(session_.shows_refined()) << "the last refined mesh stays until the next is there";
  EXPECT_EQ(session_.model().crease_counts[2], 12U);
  EXPECT_EQ(session_.model().statistics.crease_edges, 12U);
  session_.finish_refinement();
  EXPECT_EQ(session_.refinement().refined()->control, session_.document().control);

  session_.perform(kCreaseDihedral);
  EXPECT_THAT(last_toast(), HasSubstr("as sharp already"));
  session_.perform({kSetCreaseSharpness, 99.0});
  session_.perform(kCreaseDihedral);
  EXPECT_EQ(creases().edge_sharpness, std::vector<float>(12, kInfiniteSharpness));
  session_.perform(kClearCreases);
  EXPECT_EQ(creases(), Creases{});
  session_.perform(kClearCreases);
  EXPECT_THAT(last_toast(), HasSubstr("nothing to clear"));
  session_.perform(kUndo);
  session_.perform(kUndo);
  EXPECT_EQ(creases().edge_sharpness, std::vector<float>(12, 2.5F));
  session_.perform(kUndo);
  EXPECT_EQ(creases(), Creases{});
  EXPECT_EQ(session_.document().control, session_.document().opened);
}

TEST_F(SessionTest, SettingsOfVerticesAndTextureAreUndoable) {
  session_.perform(kPointsLimit);
  session_.perform(kTextureLinear);
  EXPECT_EQ(session_.document().settings.points, SurfacePoints::kLimit);
  EXPECT_EQ(session_.document().settings.texture, TextureRule::kLinear);
  session_.perform(kTextureSmoothInside);
  session_.perform(kPointsLevel);
  EXPECT_EQ(session_.document().settings, SubdivisionSettings{});
  session_.perform(kUndo);
  EXPECT_EQ(session_.document().settings.points, SurfacePoints::kLimit);
}

TEST_F(SessionTest, AMeshsBoundaryRuleIsHonoured) {
  const std::string path = folder_.file("round.obj");
  std::ofstream(path) << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nt interpolateboundary "
                         "1/0/0 2\n";
  session_.perform({kOpen, path});
  EXPECT_EQ(session_.document().settings.corners, CornerRule::kSmooth);
}

TEST_F(SessionTest, VisibleWithoutAScreenChangesNothing) {
  Session blind({[] {}, {}});
  blind.perform(kRaiseVisible);
  EXPECT_EQ(blind.document().depths.deepest(), 0);
  ASSERT_FALSE(blind.toasts().empty());
  EXPECT_EQ(blind.toasts().back().kind, ui::Toast::Kind::kProblem);
}

TEST_F(SessionTest, SubdividingRefinesAndKeepsThePainting) {
  session_.perform({kToggleLive, false});
  stroke({0}, DepthChange::set(3));
  session_.perform(kSubdivide);
  session_.finish_refinement();
  ASSERT_NE(session_.refinement().refined(), nullptr);
  const Refinement& first = *session_.refinement().refined()->refinement;
  // The table of the algorithm's fixture: one face of a cube at depth 3.
  EXPECT_EQ(first.mesh->face_count(), 228u);
  EXPECT_EQ(first.mesh->vertex_count(), 230u);
  EXPECT_TRUE(first.cracks.is_watertight());
  EXPECT_TRUE(session_.shows_refined());
  EXPECT_EQ(session_.document().control->face_count(), 6u);

  stroke({0}, DepthChange::add(-1));
  session_.finish_refinement();
  EXPECT_EQ(session_.refinement().refined()->refinement->mesh->face_count(), 76u)
      << "painting again follows at once";
  session_.perform(kUndo);
  session_.finish_refinement();
  EXPECT_EQ(session_.refinement().refined()->refinement->mesh->face_count(), 228u);
  session_.perform(kUndo);
  EXPECT_EQ(session_.document().stage.levels, 0) << "subdividing is undone after painting";
  EXPECT_FALSE(session_.shows_refined());
}

TEST_F(SessionTest, TheRefinedMeshFollowsThePaintingFromTheStart) {
  session_.finish_refinement();
  EXPECT_FALSE(session_.shows_refined()) << "nothing is painted yet";
  stroke({0}, DepthChange::set(3));
  session_.finish_refinement();
  EXPECT_TRUE(session_.shows_refined());
  EXPECT_EQ(session_.refinement().refined()->mesh->face_count(), 228u);
  EXPECT_EQ(session_.document().stage, Stage{}) << "no stage of it was asked for";
  session_.perform(kUndo);
  session_.finish_refinement();
  EXPECT_FALSE(session_.shows_refined());
  session_.perform(kRedo);

  session_.perform(kSubdivideOneLevel);
  session_.finish_refinement();
  EXPECT_LT(session_.refinement().refined()->mesh->face_count(), 228u)
      << "whoever asks for a level sees that level";
  session_.perform(kBackToControl);
  session_.finish_refinement();
  EXPECT_EQ(session_.refinement().refined()->mesh->face_count(), 228u);
  session_.perform({kToggleLive, false});
  session_.finish_refinement();
  EXPECT_FALSE(session_.shows_refined());
}

TEST_F(SessionTest, ApplyTakesTheMeshThatFollowsThePainting) {
  stroke({0}, DepthChange::set(3));
  session_.finish_refinement();
  session_.perform(kApply);
  EXPECT_EQ(session_.document().control->face_count(), 228u);
  session_.perform(kUndo);
  EXPECT_EQ(session_.document().control->face_count(), 6u);
}

TEST_F(SessionTest, OneLevelAtATime) {
  session_.perform({kToggleLive, false});
  stroke({0}, DepthChange::set(3));
  session_.perform(kSubdivideOneLevel);
  session_.finish_refinement();
  const auto faces_after = [this] {
    return session_.refinement().refined()->refinement->mesh->face_count();
  };
  const std::size_t one = faces_after();
  session_.perform(kSubdivideOneLevel);
  session_.perform(kSubdivideOneLevel);
  session_.finish_refinement();
  EXPECT_LT(one, faces_after());
  EXPECT_EQ(faces_after(), 228u);
  session_.perform(kBackToControl);
  EXPECT_FALSE(session_.shows_refined());
}

TEST_F(SessionTest, ApplyMakesTheRefinedMeshTheControlMeshAndUndoes) {
  stroke({0}, DepthChange::set(1));
  session_.perform(kSubdivide);
  session_.finish_refinement();
  session_.perform(kApply);
  EXPECT_EQ(session_.document().control->face_count(), 24u);
  EXPECT_EQ(session_.document().depths.size(), 24u);
  EXPECT_EQ(session_.document().depths.deepest(), 0);
  session_.perform(kUndo);
  EXPECT_EQ(session_.document().control->face_count(), 6u);
  EXPECT_EQ(depths(), (std::vector<int>{1, 0, 0, 0, 0, 0}));
  session_.perform(kRedo);
  session_.perform(kRevert);
  EXPECT_EQ(session_.document().control->face_count(), 6u);
}

TEST_F(SessionTest, ApplyKeepsAMeshFarFromTheOriginInItsPlace) {
  const fs::path far = folder_ / "far.obj";
  // Two unit squares; single precision world coordinates are 64 units apart out there.
  std::ofstream(far) << "v 1e9 0 5\nv 1000000001 0 5\nv 1000000002 0 5\n"
                        "v 1e9 1 5\nv 1000000001 1 5\nv 1000000002 1 5\n"
                        "f 1 2 5 4\nf 2 3 6 5\n";
  session_.perform({kOpen, far.string()});
  stroke({0, 1}, DepthChange::set(1));
  session_.perform(kSubdivide);
  session_.finish_refinement();
  session_.perform(kApply);
  const ControlMesh& control = *session_.document().control;
  ASSERT_EQ(control.face_count(), 8u);
  ASSERT_EQ(control.vertex_count(), 15u);
  EXPECT_EQ(control.positions()[1], glm::dvec3(1000000001, 0, 5));
  EXPECT_EQ(control.positions()[5], glm::dvec3(1000000002, 1, 5));
  EXPECT_THAT(control.positions(), testing::Contains(glm::dvec3(1000000001.5, 0.5, 5)));
  EXPECT_EQ(control.bounds().low, glm::dvec3(1e9, 0, 5));
  EXPECT_EQ(control.bounds().high, glm::dvec3(1000000002, 1, 5));
}

TEST_F(SessionTest, BadFileLeavesTheDocumentAndSaysWhy) {
  const fs::path bad = folder_ / "bad.obj";
  std::ofstream(bad) << "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 9\n";
  session_.perform({kOpen, bad.string()});
  EXPECT_EQ(session_.document().name, "cube");
  ASSERT_NE(modal<ui::ErrorDialog>(), nullptr);
  EXPECT_THAT(modal<ui::ErrorDialog>()->title, HasSubstr("bad.obj"));
  EXPECT_EQ(modal<ui::ErrorDialog>()->error.kind, ErrorKind::kBadInput);
  EXPECT_EQ(modal<ui::ErrorDialog>()->error.line, 4u);
  session_.perform(kCancel);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(session_.modal()));
  EXPECT_THAT(session_.recent_files(), IsEmpty());
}

TEST_F(SessionTest, SavedProjectOpensAgainAsItWas) {
  stroke({1, 2}, DepthChange::set(4));
  session_.perform(kSubdivide);
  EXPECT_THAT(session_.title(), HasSubstr("*"));
  const fs::path path = folder_ / "painted";
  session_.perform({kSaveProjectAs, path.string()});
  EXPECT_TRUE(fs::exists(folder_ / "painted.limn")) << "the ending is added";
  EXPECT_FALSE(session_.history().is_modified());
  EXPECT_EQ(session_.title(), "painted.limn - Limn");

  session_.perform({kOpenBundled, std::string("icosahedron")});
  EXPECT_EQ(session_.document().control->face_count(), 20u);
  session_.perform({kOpen, (folder_ / "painted.limn").string()});
  EXPECT_EQ(depths(), (std::vector<int>{0, 4, 4, 0, 0, 0}));
  EXPECT_EQ(session_.document().stage, (Stage{true, kAllLevels}));
  ASSERT_EQ(session_.recent_files().size(), 1u);
}

TEST_F(SessionTest, UnsavedChangesAreAskedAbout) {
  stroke({1});
  session_.perform(kQuit);
  EXPECT_FALSE(session_.wants_to_quit());
  ASSERT_NE(modal<ui::UnsavedQuestion>(), nullptr);
  session_.perform(kCancel);
  EXPECT_FALSE(session_.wants_to_quit());

  session_.perform({kOpenBundled, std::string("icosahedron")});
  ASSERT_NE(modal<ui::UnsavedQuestion>(), nullptr);
  session_.perform(kDiscardChanges);
  EXPECT_EQ(session_.document().control->face_count(), 20u);
  session_.perform(kQuit);
  EXPECT_TRUE(session_.wants_to_quit()) << "nothing was changed since";
}

TEST_F(SessionTest, SaveFirstSavesAndGoesOn) {
  stroke({1});
  session_.perform(kQuit);
  session_.perform(kSaveFirst);
  EXPECT_FALSE(session_.wants_to_quit()) << "it has no name yet";
  ASSERT_NE(modal<ui::PathPrompt>(), nullptr);
  session_.perform({kSaveProjectAs, (folder_ / "x.limn").string()});
  EXPECT_TRUE(fs::exists(folder_ / "x.limn"));
  EXPECT_TRUE(session_.wants_to_quit());
}

TEST_F(SessionTest, FailedSaveDoesNotGoOn) {
  stroke({1});
  session_.perform(kQuit);
  session_.perform(kSaveFirst);
  session_.perform({kSaveProjectAs, (folder_ / "nowhere" / "x.limn").string()});
  EXPECT_FALSE(session_.wants_to_quit());
  EXPECT_NE(modal<ui::ErrorDialog>(), nullptr);
  EXPECT_TRUE(session_.history().is_modified());
}

TEST_F(SessionTest, ExportWaitsForTheRefinement) {
  stroke({0}, DepthChange::set(2));
  const fs::path path = folder_ / "out.obj";
  session_.perform({kExportRefined, path.string()});
  session_.finish_refinement();
  const auto mesh = import_mesh(path);
  ASSERT_TRUE(mesh.has_value()) << to_string(mesh.error());
  EXPECT_EQ(mesh->mesh->face_count(), 76u);
  EXPECT_EQ(session_.document().stage.levels, 0) << "exporting does not subdivide the view";
}

TEST_F(SessionTest, ExportsAreWrittenInAnyFormatOrSayWhyNot) {
  for (const char* name : {"a.ply", "b.OFF", "c.stl"}) {
    session_.perform({kExportRefined, (folder_ / name).string()});
    session_.finish_refinement();
    EXPECT_FALSE(session_.is_busy());
    EXPECT_TRUE(import_mesh(folder_ / name).has_value()) << name;
  }
  session_.perform({kExportRefined, (folder_ / "nowhere" / "d.ply").string()});
  session_.finish_refinement();
  const auto* error = modal<ui::ErrorDialog>();
  ASSERT_NE(error, nullptr);
  EXPECT_EQ(error->title, "Cannot write d.ply");
}

TEST_F(SessionTest, TheExportPromptSaysWhatIsLost) {
  stroke({0}, DepthChange::set(2));
  session_.finish_refinement();
  session_.perform(kExportRefined);
  const auto* prompt = modal<ui::PathPrompt>();
  ASSERT_NE(prompt, nullptr);
  EXPECT_EQ(prompt->losses[static_cast<std::size_t>(MeshFormat::kObj)], "");
  EXPECT_EQ(prompt->losses[static_cast<std::size_t>(MeshFormat::kOff)],
            "OFF files do not hold: the painted depths and normals of the limit surface.");
}

TEST_F(SessionTest, OverTheBudgetItAsksAndObeys) {
  session_.set_face_budget(100);
  stroke({0}, DepthChange::set(3));
  session_.perform(kSubdivide);
  session_.finish_refinement();
  EXPECT_EQ(session_.refinement().refined(), nullptr);
  const auto* question = modal<ui::OverBudgetQuestion>();
  ASSERT_NE(question, nullptr);
  EXPECT_EQ(question->faces, 228u);
  EXPECT_EQ(question->budget, 100u);

  session_.perform(kCancel);
  session_.finish_refinement();
  EXPECT_EQ(modal<ui::OverBudgetQuestion>(), nullptr) << "asked once";
  stroke({1});
  session_.finish_refinement();
  EXPECT_EQ(modal<ui::OverBudgetQuestion>(), nullptr) << "nor at every stroke";

  session_.perform(kSubdivide);
  session_.finish_refinement();
  ASSERT_NE(modal<ui::OverBudgetQuestion>(), nullptr) << "but when asked for again";
  session_.perform(kRefineAnyway);
  session_.finish_refinement();
  ASSERT_NE(session_.refinement().refined(), nullptr);
  EXPECT_GT(session_.refinement().refined()->refinement->mesh->face_count(), 100u);
}

TEST_F(SessionTest, NamingADepthMakesTheBrushSetIt) {
  session_.perform({kSetTargetDepth, 4});
  EXPECT_TRUE(session_.brush().sets_depth);
  EXPECT_EQ(session_.brush().target_depth, 4);
  stroke({5}, DepthChange::set(7));
  session_.set_hover(5u);
  session_.perform(kPickDepth);
  EXPECT_EQ(session_.brush().target_depth, 7);
  session_.perform(kBrushAdds);
  EXPECT_FALSE(session_.brush().sets_depth);
}

TEST_F(SessionTest, FramingGlidesAndEndsExactly) {
  session_.finish_refinement();
  while (session_.update(1.0)) {
  }
  const ViewState start = session_.view();
  session_.perform(kViewFront);
  EXPECT_EQ(session_.view(), start);
  EXPECT_TRUE(session_.update(1.07));
  EXPECT_NE(session_.view(), start);
  EXPECT_TRUE(session_.update(1.2));
  EXPECT_EQ(session_.view().yaw, 0.0);
  EXPECT_EQ(session_.view().pitch, 0.0);
  EXPECT_FALSE(session_.update(1.3));
}

TEST_F(SessionTest, ToastsPass) {
  session_.update(1.0);
  session_.perform(kUndo);
  EXPECT_EQ(last_toast(), "There is nothing to undo.");
  session_.perform(kUndo);
  EXPECT_EQ(session_.toasts().size(), 1u) << "the same is not said twice";
  session_.update(session_.next_update() + 0.01);
  EXPECT_TRUE(session_.toasts().empty());
}

TEST_F(SessionTest, ReplacingTheMeshKeepsThePainting) {
  stroke({0, 5});
  test::write_file(folder_ / "three.obj",
                   "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nf 1 2 3 4\n");
  session_.perform({kReplaceMesh, folder_.file("missing.obj")});
  EXPECT_NE(modal<ui::ErrorDialog>(), nullptr);
  session_.perform(kCancel);
  EXPECT_EQ(session_.document().control->face_count(), 6U);
  session_.perform({kReplaceMesh, folder_.file("three.obj")});
  EXPECT_EQ(session_.document().control->face_count(), 1U);
  EXPECT_THAT(last_toast(), HasSubstr("gone"));
  session_.perform(kUndo);
  EXPECT_EQ(depths(), (std::vector<int>{1, 0, 0, 0, 0, 1}));
}

TEST_F(SessionTest, AFailedLoadChangesNothing) {
  stroke({1});
  session_.perform({kSaveProject, folder_.file("kept.limn")});
  session_.perform({kSaveProjectAs, folder_.file("kept.limn")});
  stroke({2});
  stroke({3});
  session_.perform(kUndo);
  const Document& document = session_.document();
  const auto control = document.control;
  const auto revisions = document.revisions;
  const auto before = depths();
  test::write_file(folder_ / "bad.obj", "v 0 0 0\nf 1 2 3\n");
  test::write_file(folder_ / "bad.limn", "{\"format\": \"limn-project\", \"version\": 99}");
  for (const std::string& bad : {folder_.file("bad.obj"), folder_.file("bad.limn"),
                                 folder_.file("missing.obj"), folder_.path().string()}) {
    session_.perform({kOpen, bad});
    session_.perform(kDiscardChanges);
    ASSERT_NE(modal<ui::ErrorDialog>(), nullptr) << bad;
    session_.perform(kCancel);
    EXPECT_EQ(document.control, control);
    EXPECT_EQ(document.revisions.control, revisions.control);
    EXPECT_EQ(document.revisions.depths, revisions.depths);
    EXPECT_EQ(document.project_path, folder_.file("kept.limn"));
    EXPECT_EQ(depths(), before);
    EXPECT_TRUE(session_.history().is_modified()) << bad;
    EXPECT_TRUE(session_.history().can_undo());
    EXPECT_TRUE(session_.history().can_redo());
  }
}

TEST_F(SessionTest, WhatTheMachineCannotHoldIsRefusedWithTheNumber) {
  session_.set_memory_budget(1000);
  stroke({0});
  session_.perform(kSubdivide);
  session_.finish_refinement();
  const auto* question = modal<ui::OverBudgetQuestion>();
  ASSERT_NE(question, nullptr);
  EXPECT_EQ(question->memory, 1000U);
  EXPECT_EQ(question->faces, 24U);
  EXPECT_GT(question->bytes, 1000U);
  session_.perform(kCancel);
  EXPECT_EQ(session_.refinement().refined(), nullptr);
}

}  // namespace
}  // namespace limn::app
