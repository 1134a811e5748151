// Subdividing, budgets, camera and messages of a session, without a window.
#include "app/session_fixture.h"

#include <filesystem>
#include <fstream>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "limn/mesh/refined_mesh.h"

namespace limn::app {
namespace {

namespace fs = std::filesystem;
using enum ui::ActionId;
using testing::HasSubstr;

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

TEST_F(SessionTest, HintsGoOnceOneHasPaintedAndOrbited) {
  EXPECT_FALSE(session_.model().hints.has_value());
  session_.perform({kToggleHints, true});
  EXPECT_EQ(session_.model().hints, ui::HintCard{});
  session_.perform(kRaiseAll);
  EXPECT_EQ(session_.model().hints, ui::HintCard{}) << "that was no stroke";
  stroke({1});
  EXPECT_EQ(session_.model().hints, (ui::HintCard{true, false}));
  ViewState view = session_.view();
  view.target.x += 1.0;
  session_.set_view(view);
  EXPECT_TRUE(session_.shows_hints()) << "a shift is no turn";
  view.yaw += 10.0;
  session_.set_view(view);
  EXPECT_FALSE(session_.shows_hints());
  session_.perform(kToggleHints);
  EXPECT_EQ(session_.model().hints, ui::HintCard{}) << "from the start again";
  session_.perform({kToggleHints, false});
  EXPECT_FALSE(session_.shows_hints());
}

TEST_F(SessionTest, SaysWhatWasDoneWhereThePictureDoesNot) {
  session_.perform(kRaiseAll);
  EXPECT_EQ(last_toast(), "Raise all: 6 faces changed.");
  session_.finish_refinement();
  session_.perform(kApply);
  EXPECT_EQ(last_toast(), "Apply: the control mesh has 24 faces now.");
  session_.perform(kRevert);
  EXPECT_EQ(last_toast(), "Revert: cube is as it was opened.");
  session_.perform({kSetDihedralThreshold, 80.0});
  session_.perform(kCreaseDihedral);
  EXPECT_EQ(last_toast(), "Creases: 12 edges are sharp now.");
  session_.perform(kClearCreases);
  EXPECT_EQ(last_toast(), "Creases: none are left.");
  const std::size_t before = session_.toasts().size();
  stroke({0});
  EXPECT_EQ(session_.toasts().size(), before) << "strokes are seen";
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
