// Uniform schemes, the second half of the viewport, edges and spheres, driven by actions.
#include <string>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "app/session.h"
#include "limn/mesh/refined_mesh.h"

namespace limn::app {
namespace {

using enum ui::ActionId;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class SchemesSessionTest : public testing::Test {
 protected:
  SchemesSessionTest() { open("icosahedron"); }

  void open(const char* name) { session_.perform({kOpenBundled, std::string(name)}); }
  void choose(const char* word) { session_.perform({kSetScheme, std::string(word)}); }
  [[nodiscard]] int level() const { return session_.document().stage.levels; }
  /// Faces of the refined mesh, as soon as it is there; 0 for none.
  [[nodiscard]] std::size_t faces() {
    session_.finish_refinement();
    const JobResult* refined = session_.refinement().refined();
    return refined != nullptr ? refined->mesh->face_count() : 0;
  }
  [[nodiscard]] std::string last_toast() const {
    return session_.toasts().empty() ? "" : session_.toasts().back().text;
  }
  void wait_for_spheres() {
    while (session_.model().sphere.running) {
      session_.update(1.0);
    }
  }

  Session session_{{[] {}, {}}};
};

TEST_F(SchemesSessionTest, StepsForwardAndBackLevelByLevel) {
  session_.perform(kSchemeForward);
  EXPECT_EQ(level(), 0);
  EXPECT_THAT(last_toast(), HasSubstr("Choose a scheme"));
  choose("loop");
  EXPECT_EQ(level(), 0);
  session_.perform(kSchemeForward);
  EXPECT_EQ(faces(), 80U);
  EXPECT_TRUE(session_.shows_refined());
  session_.perform(kSchemeForward);
  EXPECT_EQ(faces(), 320U);
  const ui::Model model = session_.model();
  ASSERT_EQ(model.scheme.steps.size(), 3U);
  EXPECT_EQ(model.scheme.steps[2].counts, (SchemeCounts{162, 480, 320}));
  EXPECT_EQ(model.scheme.counts[5].faces, 20U << 10U);
  EXPECT_EQ(model.refinement.result->faces, 320U);
  EXPECT_EQ(model.refinement.result->uniform_faces, 0U) << "nothing to compare it with";

  session_.perform(kSchemeBack);
  EXPECT_EQ(faces(), 80U);
  session_.perform(kSchemeBack);
  EXPECT_EQ(faces(), 0U);
  EXPECT_FALSE(session_.shows_refined());
  session_.perform(kSchemeBack);
  EXPECT_THAT(last_toast(), HasSubstr("no level before"));
  session_.perform({kSetSchemeLevel, 3});
  EXPECT_EQ(faces(), 1280U);
}

TEST_F(SchemesSessionTest, EveryStepIsUndoneByItself) {
  choose("loop");
  session_.perform(kSchemeForward);
  session_.perform(kSchemeForward);
  session_.perform(kUndo);
  EXPECT_EQ(level(), 1);
  EXPECT_EQ(faces(), 80U);
  session_.perform(kUndo);
  EXPECT_EQ(level(), 0);
  session_.perform(kUndo);
  EXPECT_FALSE(session_.document().scheme);
  EXPECT_FALSE(session_.history().can_undo());
  session_.perform(kRedo);
  session_.perform(kRedo);
  EXPECT_EQ(faces(), 80U);
}

TEST_F(SchemesSessionTest, AnotherSchemeKeepsTheLevel) {
  choose("loop");
  session_.perform({kSetSchemeLevel, 2});
  EXPECT_EQ(faces(), 320U);
  choose("sqrt3");
  EXPECT_EQ(level(), 2);
  EXPECT_EQ(faces(), 180U);
  choose("catmull-clark");
  EXPECT_EQ(faces(), 240U);
  choose("");
  EXPECT_EQ(level(), kAllLevels) << "what is painted is shown to the end";
  EXPECT_FALSE(session_.document().scheme);
  choose("no such scheme");
  EXPECT_THAT(last_toast(), HasSubstr("no scheme"));
}

TEST_F(SchemesSessionTest, WeightsChangeTheSurface) {
  choose("loop");
  session_.perform({kSetSchemeLevel, 1});
  session_.finish_refinement();
  const glm::dvec3 original = session_.refinement().refined()->mesh->position(0);
  session_.perform(kLoopWarren);
  EXPECT_EQ(session_.document().scheme->weights, LoopWeights::kWarren);
  EXPECT_EQ(level(), 1);
  session_.finish_refinement();
  const glm::dvec3 warren = session_.refinement().refined()->mesh->position(0);
  EXPECT_GT(glm::distance(original, warren), 1e-3);
  session_.perform(kUndo);
  session_.finish_refinement();
  EXPECT_EQ(session_.refinement().refined()->mesh->position(0), original);
}

TEST_F(SchemesSessionTest, AMisfitIsToldAndMended) {
  open("cube");
  choose("loop");
  ASSERT_TRUE(session_.model().scheme.misfit);
  EXPECT_THAT(session_.model().scheme.misfit->reason, HasSubstr("triangles"));
  EXPECT_EQ(session_.model().scheme.misfit->fitting, Fitting::kTriangulate);
  session_.perform(kSchemeForward);
  EXPECT_EQ(level(), 0);
  session_.perform(kMakeFit);
  EXPECT_EQ(session_.document().control->face_count(), 12U);
  EXPECT_FALSE(session_.model().scheme.misfit);
  session_.perform(kSchemeForward);
  EXPECT_EQ(faces(), 48U);
  session_.perform(kUndo);
  session_.perform(kUndo);
  EXPECT_EQ(session_.document().control->face_count(), 6U);
  EXPECT_TRUE(session_.model().scheme.misfit);
  EXPECT_EQ(faces(), 0U);
}

TEST_F(SchemesSessionTest, AMisfitOnTheWayStopsAtTheControlMesh) {
  open("cube");
  choose("catmull-clark");
  session_.perform({kSetSchemeLevel, 2});
  EXPECT_EQ(faces(), 96U);
  choose("butterfly");
  EXPECT_EQ(level(), 0);
  EXPECT_EQ(faces(), 0U);
  session_.perform(kUndo);
  EXPECT_EQ(faces(), 96U);
}

TEST_F(SchemesSessionTest, SubdivideGoesBackToThePainting) {
  session_.begin_stroke(DepthChange::set(2));
  session_.touch(std::vector<std::uint32_t>{0});
  session_.end_stroke();
  choose("loop");
  session_.perform(kSubdivideOneLevel);
  EXPECT_EQ(faces(), 80U) << "one level of the scheme";
  session_.perform(kSubdivide);
  EXPECT_FALSE(session_.document().scheme);
  EXPECT_EQ(level(), kAllLevels);
  EXPECT_EQ(faces(), 225U) << "fewer than the 240 of two uniform levels";
  session_.perform(kUndo);
  EXPECT_EQ(faces(), 80U) << "in one step";
}

TEST_F(SchemesSessionTest, OverTheBudgetItAsks) {
  session_.set_face_budget(1000);
  choose("loop");
  session_.perform({kSetSchemeLevel, 3});
  EXPECT_EQ(faces(), 0U);
  const auto* question = std::get_if<ui::OverBudgetQuestion>(&session_.modal());
  ASSERT_NE(question, nullptr);
  EXPECT_EQ(question->faces, 1280U);
  session_.perform(kRefineAnyway);
  EXPECT_EQ(faces(), 1280U);
}

TEST_F(SchemesSessionTest, WhatIsTooLargeIsSteppedBackFrom) {
  session_.set_face_budget(1000);
  choose("loop");
  session_.perform({kSetSchemeLevel, 1});
  EXPECT_EQ(faces(), 80U);
  session_.perform({kSetSchemeLevel, 3});
  session_.finish_refinement();
  session_.perform(kCancel);
  EXPECT_EQ(level(), 1);
  EXPECT_EQ(faces(), 80U);
  session_.perform(kSchemeForward);
  EXPECT_EQ(faces(), 320U) << "and from there on";
}

TEST_F(SchemesSessionTest, ApplyTakesTheSchemesMesh) {
  choose("loop");
  session_.perform({kSetSchemeLevel, 1});
  session_.finish_refinement();
  session_.perform(kApply);
  EXPECT_EQ(session_.document().control->face_count(), 80U);
  EXPECT_EQ(session_.document().control->face(0).size(), 3U);
  EXPECT_EQ(level(), 0);
  EXPECT_TRUE(session_.document().scheme);
  session_.perform(kUndo);
  EXPECT_EQ(faces(), 80U);
}

TEST_F(SchemesSessionTest, TheSecondHalfFollowsTheLevel) {
  choose("loop");
  session_.perform({kSetSecondScheme, std::string("loop:warren")});
  EXPECT_TRUE(session_.is_split());
  EXPECT_FALSE(session_.shows_second_refined());
  session_.perform({kSetSchemeLevel, 2});
  session_.finish_refinement();
  ASSERT_TRUE(session_.shows_second_refined());
  EXPECT_EQ(session_.second().refined()->mesh->face_count(), 320U);
  EXPECT_NE(session_.second().refined()->mesh->positions,
            session_.refinement().refined()->mesh->positions);
  EXPECT_EQ(session_.history().undo_name(), "forward to level 2")
      << "what stands beside is no part of the document";
  session_.perform({kSetSecondScheme, std::string("kobbelt")});
  session_.finish_refinement();
  EXPECT_TRUE(session_.model().second.misfit);
  EXPECT_FALSE(session_.shows_second_refined()) << "the control mesh stands there instead";
  session_.perform({kSetSecondScheme, std::string()});
  EXPECT_FALSE(session_.is_split());
}

TEST_F(SchemesSessionTest, TheSecondHalfShowsNothingOfAMeshThatWentWhileItWasClosed) {
  choose("loop");
  session_.perform({kSetSchemeLevel, 1});
  session_.perform({kSetSecondScheme, std::string("butterfly")});
  session_.finish_refinement();
  ASSERT_TRUE(session_.shows_second_refined());
  session_.perform({kSetSecondScheme, std::string()});
  session_.set_hover_edge(0U);
  session_.perform(kSplitEdge);
  session_.perform({kSetSecondScheme, std::string("butterfly")});
  EXPECT_EQ(session_.second().refined(), nullptr);
  session_.finish_refinement();
  EXPECT_EQ(session_.second().refined()->mesh->face_count(), 88U);
  session_.perform({kSetSecondScheme, std::string()});
  session_.perform({kSetSecondScheme, std::string("butterfly")});
  session_.finish_refinement();
  EXPECT_TRUE(session_.shows_second_refined()) << "closed and opened again";
}

TEST_F(SchemesSessionTest, PaintingByLoopNeedsTriangles) {
  open("cube");
  session_.perform(kAdaptiveLoop);
  EXPECT_EQ(session_.document().settings.scheme, RefinementScheme::kCatmullClark);
  EXPECT_THAT(last_toast(), HasSubstr("triangles"));
  EXPECT_FALSE(session_.history().can_undo());
}

TEST_F(SchemesSessionTest, TheSecondHalfStandsBesideAPaintingAtItsDepth) {
  session_.begin_stroke(DepthChange::set(2));
  session_.touch(std::vector<std::uint32_t>{0});
  session_.end_stroke();
  session_.perform({kSetSecondScheme, std::string("catmull-clark")});
  session_.perform(kSubdivide);
  session_.finish_refinement();
  ASSERT_TRUE(session_.shows_second_refined());
  EXPECT_EQ(session_.second().refined()->mesh->face_count(), 240U);
}

TEST_F(SchemesSessionTest, SplitAndFlipTheEdgeUnderTheCursor) {
  session_.perform(kSplitEdge);
  EXPECT_THAT(last_toast(), HasSubstr("tool for edges"));
  session_.set_hover(0U);
  session_.set_hover_edge(4U);
  EXPECT_EQ(session_.model().hover_edge->vertices,
            session_.document().control->topology().edge_vertices[4]);
  session_.perform(kSplitEdge);
  EXPECT_EQ(session_.document().control->vertex_count(), 13U);
  EXPECT_FALSE(session_.hover_edge()) << "it was one of the mesh before";
  EXPECT_FALSE(session_.hover());
  session_.set_hover_edge(4U);
  session_.perform(kFlipEdge);
  EXPECT_EQ(session_.history().undo_name(), "flip edge");
  session_.perform(kUndo);
  session_.perform(kUndo);
  EXPECT_EQ(session_.document().control, session_.document().opened);
}

TEST_F(SchemesSessionTest, ARefusedEdgeIsExplained) {
  open("cube");
  session_.set_hover_edge(0U);
  session_.perform(kFlipEdge);
  ASSERT_FALSE(session_.toasts().empty());
  EXPECT_EQ(session_.toasts().back().kind, ui::Toast::Kind::kProblem);
  EXPECT_FALSE(session_.history().can_undo());
}

TEST_F(SchemesSessionTest, AnEdgeEditUnderAShownLevelRefinesAnew) {
  choose("loop");
  session_.perform({kSetSchemeLevel, 1});
  EXPECT_EQ(faces(), 80U);
  session_.set_hover_edge(0U);
  session_.perform(kSplitEdge);
  EXPECT_EQ(session_.refinement().refined(), nullptr)
      << "nothing of the other mesh is shown any more";
  EXPECT_EQ(faces(), 88U);
  session_.perform(kUndo);
  EXPECT_EQ(faces(), 80U);
}

TEST_F(SchemesSessionTest, IrregularVerticesAreThoseOfWhatIsShown) {
  session_.perform(kToggleValences);
  EXPECT_THAT(session_.model().valence_counts, ElementsAre(0, 12, 0, 0));
  choose("catmull-clark");
  session_.perform({kSetSchemeLevel, 1});
  session_.finish_refinement();
  EXPECT_THAT(session_.model().valence_counts, ElementsAre(0, 20, 12, 0))
      << "a vertex of three edges in every triangle, one of five at every old vertex";
  session_.perform({kSetSecondScheme, std::string("loop")});
  session_.finish_refinement();
  EXPECT_THAT(session_.second_valences().counts(), ElementsAre(0, 12, 0, 0));
}

TEST_F(SchemesSessionTest, ComparesLoopWithSpheresByBothWeights) {
  session_.perform(kCompareSphere);
  EXPECT_THAT(last_toast(), HasSubstr("Choose a scheme"));
  choose("loop");
  session_.perform(kCompareSphere);
  wait_for_spheres();
  const ui::SphereStatus sphere = session_.model().sphere;
  ASSERT_EQ(sphere.series.size(), 2U) << sphere.problem;
  EXPECT_EQ(sphere.series[0].settings.weights, LoopWeights::kOriginal);
  EXPECT_EQ(sphere.series[1].settings.weights, LoopWeights::kWarren);
  for (const ui::SphereSeries& series : sphere.series) {
    ASSERT_EQ(series.rows.size(), 6U);
    EXPECT_LT(series.rows[0].fit.root_mean_square, 1e-6) << "its corners lie on a sphere";
    EXPECT_GT(series.rows[3].fit.root_mean_square, 1e-4);
    EXPECT_EQ(series.rows[5].faces, 20U << 10U);
  }
  session_.perform(kLoopWarren);
  EXPECT_EQ(session_.model().sphere.series.size(), 2U) << "of both weights";
  choose("butterfly");
  EXPECT_THAT(session_.model().sphere.series, IsEmpty()) << "it was not asked about this one";
}

TEST_F(SchemesSessionTest, ToggleFacesAndTools) {
  EXPECT_TRUE(session_.display().faces);
  session_.perform(kToggleFaces);
  EXPECT_FALSE(session_.display().faces);
  session_.perform(kToolSplitEdge);
  EXPECT_EQ(session_.brush().tool, ui::Tool::kSplitEdge);
  session_.perform(kToolFlipEdge);
  EXPECT_EQ(session_.brush().tool, ui::Tool::kFlipEdge);
}

}  // namespace
}  // namespace limn::app
