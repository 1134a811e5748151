// Strokes, rules and creases of a session, by what becomes of the document.
#include "app/session_fixture.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/document/project_file.h"

namespace limn::app {
namespace {

using enum ui::ActionId;
using testing::HasSubstr;

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

TEST_F(SessionTest, ShowsDemandsOfAProjectAndZeroesThemWithTheRest) {
  Document document = session_.document();
  document.demands.raise(std::vector{FineDemand{{0, 0, 2, 1, 1}, 5}});
  const std::string path = folder_.file("fine.limn");
  ASSERT_TRUE(save_project(path, document, std::nullopt));
  session_.perform({kOpen, path});
  ASSERT_EQ(session_.document().demands, document.demands);
  session_.finish_refinement();
  ASSERT_NE(session_.refinement().refined(), nullptr) << "it follows demands as it follows paint";
  EXPECT_EQ(session_.refinement().refined()->prediction.levels, 5);
  EXPECT_TRUE(session_.refinement().refined()->refinement->cracks.is_watertight());

  stroke({3}, DepthChange::set(1));
  session_.perform(kZeroAll);
  EXPECT_TRUE(session_.document().demands.empty());
  EXPECT_THAT(last_toast(), HasSubstr("1 face changed. 1 demand on finer faces gone."));
  session_.perform(kUndo);
  EXPECT_EQ(session_.document().demands, document.demands);
  EXPECT_EQ(session_.document().depths[3], 1);
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

TEST_F(SessionTest, VisibleWithoutAScreenChangesNothing) {
  Session blind({[] {}, {}});
  blind.perform(kRaiseVisible);
  EXPECT_EQ(blind.document().depths.deepest(), 0);
  ASSERT_FALSE(blind.toasts().empty());
  EXPECT_EQ(blind.toasts().back().kind, ui::Toast::Kind::kProblem);
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

}  // namespace
}  // namespace limn::app
