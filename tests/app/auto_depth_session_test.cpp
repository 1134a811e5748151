// Depths that come about by themselves: on another thread, one step each, held against the rules
// they stand for.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session_fixture.h"
#include "limn/painting/rule_presets.h"
#include "render/camera.h"

namespace limn::app {
namespace {

using enum ui::ActionId;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;

class AutoDepthSession : public SessionTest {
 protected:
  /// What the rules make of a painting, as on the command line.
  [[nodiscard]] std::vector<int> expected(const std::string& rules, FaceDepths depths,
                                          SurfacePoints points = SurfacePoints::kLimit) const {
    PaintContext context;
    context.settings = session_.document().settings;
    context.settings.points = points;
    const ControlMesh& mesh = *session_.document().control;
    const std::vector<PaintRule> parsed = parse_paint_rules(rules, "test").value();
    for (const PaintRule& rule : parsed) {
      EXPECT_TRUE(apply_paint_rule(mesh, rule, context, depths));
    }
    return {depths.values().begin(), depths.values().end()};
  }
  void set(const std::string& rules) { session_.perform({kSetDepthRules, rules}); }
  void choose() {
    session_.perform(kChooseDepths);
    session_.finish_refinement();
  }
  [[nodiscard]] ui::AutoDepthStatus status() const { return session_.model().auto_depth; }
};

TEST_F(AutoDepthSession, PaintsWhatTheRuleSaysAsOneStep) {
  session_.perform({kOpenBundled, std::string("teapot")});
  const FaceDepths before = session_.document().depths;
  set("tolerance=0.001d");
  choose();
  EXPECT_EQ(depths(), expected("tolerance=0.001d", before));
  EXPECT_EQ(session_.document().settings.points, SurfacePoints::kLimit);
  EXPECT_EQ(session_.history().size(), 1U);
  EXPECT_THAT(session_.history().undo_name(), HasSubstr("tolerance=0.001d"));

  ASSERT_TRUE(status().outcome);
  const double asked = 0.001 * session_.document().control->bounds().diagonal();
  EXPECT_EQ(status().outcome->tolerance, asked);
  EXPECT_LE(*status().outcome->expected_error, asked);
  ASSERT_TRUE(session_.model().distance.figures) << "measured without being asked";
  EXPECT_LE(session_.model().distance.figures->greatest(), asked);

  session_.perform(kUndo);
  EXPECT_EQ(session_.document().depths, before);
  EXPECT_EQ(session_.document().settings.points, SurfacePoints::kLevel);
  EXPECT_FALSE(status().outcome) << "this is not what was chosen";
  session_.perform(kRedo);
  EXPECT_EQ(depths(), expected("tolerance=0.001d", before));
  EXPECT_EQ(session_.document().settings.points, SurfacePoints::kLimit);
}

TEST_F(AutoDepthSession, LeavesVerticesAtTheirLevelWhereAsked) {
  session_.perform({kToggleLimitDepths, false});
  set("tolerance=0.01d");
  choose();
  EXPECT_EQ(session_.document().settings.points, SurfacePoints::kLevel);
  EXPECT_EQ(depths(), expected("tolerance=0.01d", FaceDepths(6), SurfacePoints::kLevel));
}

TEST_F(AutoDepthSession, ControlsAreWordsForRules) {
  const auto rule = [this] { return ui::text_of(status().settings.rules); };
  session_.perform({kSetDepthAmount, 0.02});
  EXPECT_EQ(rule(), "tolerance=0.02d\n");
  session_.perform(kToggleMeasuredDepths);
  EXPECT_EQ(rule(), "tolerance=0.02d,measured\n");
  session_.perform({kToggleMeasuredDepths, false});
  session_.perform({kSetDepthMerge, static_cast<int>(DepthMerge::kMax)});
  session_.perform({kSetDepthWithin, std::string("unpainted")});
  EXPECT_EQ(rule(), "tolerance=0.02d:max in unpainted\n");
  session_.perform({kSetDepthSource, static_cast<int>(ui::DepthSource::kBudget)});
  session_.perform({kSetDepthAmount, 1234.0});
  session_.perform({kSetDepthUnit, 1});
  session_.perform({kSetBudgetGoal, 1});
  EXPECT_EQ(rule(), "budget=1234t,greatest:max in unpainted\n");
  session_.perform({kSetDepthWithin, std::string()});
  session_.perform({kSetDepthMerge, 0});
  session_.perform({kSetDepthSource, static_cast<int>(ui::DepthSource::kScreen)});
  session_.perform({kSetDepthAmount, 1e9});
  session_.perform({kSetSilhouettes, 2});
  EXPECT_EQ(rule(), "screen=200px,silhouettes=2\n") << "as far as the slider goes";
  session_.perform({kSetDepthSource, static_cast<int>(ui::DepthSource::kCurve)});
  session_.perform({kSetCurveMeasure, static_cast<int>(FaceMeasure::kDihedral)});
  EXPECT_THAT(rule(), HasSubstr("curve=dihedral,"));
  session_.perform({kSetDepthSource, static_cast<int>(ui::DepthSource::kTolerance)});
  EXPECT_EQ(rule(), "tolerance=0.02d\n") << "as it was left";
  const double diagonal = session_.document().control->bounds().diagonal();
  session_.perform({kSetDepthUnit, 1});
  EXPECT_DOUBLE_EQ(std::get<ChooseByTolerance>(status().settings.choice()->choice).distance,
                   0.02 * diagonal);
  session_.perform({kSetDepthUnit, 0});
  EXPECT_DOUBLE_EQ(std::get<ChooseByTolerance>(status().settings.choice()->choice).distance, 0.02);
  for (const int nonsense : {-1, 99}) {
    session_.perform({kSetDepthSource, nonsense});
    session_.perform({kSetDepthUnit, nonsense});
    session_.perform({kSetDepthMerge, nonsense});
    session_.perform({kSetCurveMeasure, nonsense});
  }
  set("tolerance=");
  EXPECT_THAT(last_toast(), HasSubstr("tolerance"));
  session_.perform({kSetDepthWithin, std::string("everywhere")});
  EXPECT_THAT(last_toast(), HasSubstr("everywhere"));
  EXPECT_EQ(rule(), "tolerance=0.02d\n");
}

TEST_F(AutoDepthSession, LiveChoicesStayOneStepFromThePaintingBefore) {
  stroke({0, 1}, DepthChange::set(2));
  const FaceDepths before = session_.document().depths;
  const std::size_t steps = session_.history().size();
  set("curve=curvature,60/1:add");
  session_.perform({kToggleLiveDepths, true});
  session_.finish_refinement();
  EXPECT_THAT(depths(), ElementsAre(3, 3, 1, 1, 1, 1));
  set("curve=curvature,60/3:add");
  session_.finish_refinement();
  EXPECT_THAT(depths(), ElementsAre(5, 5, 3, 3, 3, 3)) << "on top of what was painted, not of 3";
  set("curve=curvature,60/3:add in painted");
  session_.finish_refinement();
  EXPECT_THAT(depths(), ElementsAre(5, 5, 0, 0, 0, 0));
  EXPECT_EQ(session_.history().size(), steps + 1);
  session_.perform(kUndo);
  EXPECT_EQ(session_.document().depths, before);

  session_.perform(kRedo);
  stroke({5}, DepthChange::set(4));
  set("curve=curvature,60/1:add");
  session_.finish_refinement();
  EXPECT_THAT(depths(), ElementsAre(6, 6, 1, 1, 1, 5)) << "what was painted since is kept";
  EXPECT_EQ(session_.history().size(), steps + 3);
}

TEST_F(AutoDepthSession, WhatTurnsUpTooLateIsNotPainted) {
  set("curve=curvature,60/3");
  session_.perform(kChooseDepths);
  stroke({0}, DepthChange::set(1));
  session_.finish_refinement();
  EXPECT_THAT(depths(), ElementsAre(1, 0, 0, 0, 0, 0));
  EXPECT_THAT(last_toast(), HasSubstr("meanwhile"));
  session_.perform({kToggleLiveDepths, true});
  stroke({0}, DepthChange::set(2));
  session_.finish_refinement();
  EXPECT_THAT(depths(), Each(3)) << "a live choice is made anew";
}

TEST_F(AutoDepthSession, CanBeStopped) {
  session_.perform({kOpenBundled, std::string("creature")});
  set("budget=100000");
  session_.perform(kChooseDepths);
  EXPECT_TRUE(session_.auto_depth().is_choosing());
  EXPECT_TRUE(status().running);
  session_.perform(kCancel);
  EXPECT_FALSE(session_.auto_depth().is_choosing());
  session_.finish_refinement();
  EXPECT_EQ(session_.document().depths.deepest(), 0);
  EXPECT_THAT(last_toast(), HasSubstr("stopped"));
}

TEST_F(AutoDepthSession, AnotherDocumentIsNotPaintedByTheLastOnesRule) {
  set("curve=curvature,60/3");
  session_.perform(kChooseDepths);
  session_.perform({kOpenBundled, std::string("icosahedron")});
  session_.finish_refinement();
  EXPECT_EQ(session_.document().depths.deepest(), 0);
}

TEST_F(AutoDepthSession, VisibleFacesAreThoseOfTheMomentItWasAsked) {
  set("curve=curvature,60/3 in visible");
  session_.perform(kChooseDepths);
  visible_ = {1};
  session_.finish_refinement();
  EXPECT_THAT(depths(), ElementsAre(3, 0, 3, 0, 0, 0));
}

TEST_F(AutoDepthSession, SizesOnTheScreenNeedACamera) {
  set("screen=4px");
  choose();
  EXPECT_THAT(last_toast(), HasSubstr("camera"));
  EXPECT_THAT(depths(), Each(0));
}

TEST_F(AutoDepthSession, TheLimitSurfaceIsCatmullClarks) {
  session_.perform({kOpenBundled, std::string("icosahedron")});
  session_.perform(kAdaptiveLoop);
  choose();
  EXPECT_THAT(last_toast(), HasSubstr("Loop"));
}

TEST_F(AutoDepthSession, ABudgetIsComparedWithUniformAndRandomMeshes) {
  session_.perform({kOpenBundled, std::string("teapot")});
  set("budget=6000");
  choose();
  ASSERT_TRUE(status().outcome && status().outcome->budget);
  EXPECT_FALSE(status().baselines.found);
  session_.perform(kCompareBudget);
  EXPECT_TRUE(status().baselines.running);
  session_.finish_refinement();
  ASSERT_TRUE(status().baselines.found) << status().baselines.problem;
  const BudgetBaselines found = *status().baselines.found;
  const double reached = session_.model().distance.figures->root_mean_square();
  EXPECT_LE(found.uniform.faces, 6000U);
  EXPECT_LE(found.random.faces, 6000U);
  EXPECT_LT(reached, found.uniform.root_mean_square);
  EXPECT_LT(reached, found.random.root_mean_square);
  session_.perform(kCornersSmooth);
  EXPECT_FALSE(status().baselines.found) << "those were of another surface";
}

TEST_F(AutoDepthSession, TheCurveStandsBeforeItsFaces) {
  EXPECT_EQ(status().histogram, nullptr);
  session_.perform({kSetDepthSource, static_cast<int>(ui::DepthSource::kCurve)});
  session_.finish_refinement();
  const ui::MeasureHistogram* faces = status().histogram;
  ASSERT_NE(faces, nullptr);
  EXPECT_EQ(faces->measure, FaceMeasure::kCurvature);
  std::size_t sum = 0;
  for (const std::size_t count : faces->counts) {
    sum += count;
  }
  EXPECT_EQ(sum, 6U);
  EXPECT_GE(faces->high, 60.0) << "a cube's faces bend by more";
  session_.perform({kSetCurveMeasure, static_cast<int>(FaceMeasure::kEdge)});
  EXPECT_EQ(status().histogram, nullptr) << "those were degrees";
  session_.finish_refinement();
  ASSERT_NE(status().histogram, nullptr);
  EXPECT_TRUE(status().histogram->is_logarithmic);
}

TEST_F(AutoDepthSession, PresetsAreKeptUnderTheirNames) {
  session_.perform({kUsePreset, std::string("draft")});
  EXPECT_EQ(ui::text_of(status().settings.rules), "budget=5000\n");
  set("tolerance=0.02d:max in painted");
  session_.perform({kSavePreset, std::string("my own")});
  ASSERT_EQ(status().own_presets.size(), 1U);
  EXPECT_EQ(status().own_presets[0].rules, "tolerance=0.02d:max in painted\n");
  session_.perform({kUsePreset, std::string("game")});
  session_.perform({kUsePreset, std::string("my own")});
  EXPECT_EQ(ui::text_of(status().settings.rules), "tolerance=0.02d:max in painted\n");
  session_.perform({kSavePreset, std::string("draft")});
  EXPECT_THAT(last_toast(), HasSubstr("comes with Limn"));
  session_.perform({kUsePreset, std::string("no such")});
  EXPECT_THAT(last_toast(), HasSubstr("my own"));
  session_.perform({kDeletePreset, std::string("my own")});
  EXPECT_TRUE(status().own_presets.empty());
}

TEST_F(AutoDepthSession, ViewsAreKeptForARun) {
  SessionHost host;
  host.wake = [] {};
  host.screen_view = [](const ViewState& view) {
    return render::screen_view(
        render::make_camera(view, Bounds{{-1, -1, -1}, {1, 1, 1}}, {640, 480}));
  };
  Session session(std::move(host));
  session.perform({kOpenBundled, std::string("cube")});
  session.perform({kSetDepthRules, std::string("screen=20px,silhouettes=0")});
  session.perform(kViewFront);
  session.update(10.0);  // The camera has come to rest.
  session.perform(kKeepView);
  session.perform(kViewBack);
  session.update(20.0);
  session.perform(kKeepView);
  EXPECT_EQ(ui::text_of(session.model().auto_depth.settings.rules),
            "screen=20px,silhouettes=0@view1@view2\n");
  session.perform(kChooseDepths);
  session.finish_refinement();
  const FaceDepths both = session.document().depths;
  session.perform({kSavePreset, std::string("two views")});
  EXPECT_TRUE(session.model().auto_depth.own_presets.empty()) << "views are gone with the run";
  session.perform(kForgetViews);
  EXPECT_EQ(ui::text_of(session.model().auto_depth.settings.rules), "screen=20px,silhouettes=0\n");
  session.perform(kChooseDepths);
  session.finish_refinement();
  const FaceDepths one = session.document().depths;
  int more = 0;
  for (std::size_t f = 0; f < one.size(); ++f) {
    EXPECT_GE(both[f], one[f]);
    more += both[f] > one[f] ? 1 : 0;
  }
  EXPECT_GT(more, 0) << "the front is not seen from behind";
}

}  // namespace
}  // namespace limn::app
