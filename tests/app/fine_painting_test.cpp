// Painting on faces of the refined mesh: with the mouse over what is drawn, and what becomes of the
// document.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "app/desk.h"
#include "app/session_fixture.h"
#include "limn/document/project_file.h"
#include "limn/document/scheme_refinement.h"
#include "limn/painting/fine_paint.h"
#include "render/picking/screen_region.h"
#include "ui/availability.h"

namespace limn::app {
namespace {

using enum ui::ActionId;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// The refined vertices that are not where uniform Catmull-Clark has one of their level.
std::size_t count_off(const Document& document, const RefinedMesh& refined) {
  const int deepest = *std::ranges::max_element(refined.vertex_levels);
  const double close = 1e-6 * document.control->bounds().diagonal();
  std::size_t off = 0;
  for (int level = 0; level <= deepest; ++level) {
    IgnoreProgress progress;
    const auto uniform =
        derive_scheme(*document.control, {.scheme = Scheme::kCatmullClark}, {level}, progress)
            .value();
    // By ascending x, so that few are looked at.
    std::vector<glm::dvec3> points(uniform.mesh->vertex_count());
    for (std::size_t v = 0; v < points.size(); ++v) {
      points[v] = uniform.mesh->position(v);
    }
    std::ranges::sort(points, {}, &glm::dvec3::x);
    for (std::size_t v = 0; v < refined.vertex_count(); ++v) {
      if (refined.vertex_levels[v] != level) {
        continue;
      }
      const glm::dvec3 at = refined.position(v);
      auto near = std::ranges::lower_bound(points, at.x - close, {}, &glm::dvec3::x);
      while (near != points.end() && near->x <= at.x + close && glm::distance(*near, at) > close) {
        ++near;
      }
      off += near == points.end() || near->x > at.x + close ? 1 : 0;
    }
  }
  return off;
}

/// The cube, painted 2 deep, in the middle of a small window.
class FinePainting : public testing::Test {
 protected:
  FinePainting() {
    session().perform({kOpenBundled, std::string("cube")});
    session().perform({kSetTargetDepth, 2});
    session().perform(kRaiseAll);
    session().perform(kRaiseAll);
    session().perform(kBrushAdds);
    session().perform({kSetBrushRadius, 2.0});
    session().perform({kToggleFine, true});
    settle();
  }

  [[nodiscard]] Session& session() { return desk_.session(); }
  [[nodiscard]] const Document& document() { return desk_.session().document(); }
  [[nodiscard]] const RefinedMesh& refined() { return *session().refinement().refined()->mesh; }
  void settle() {
    session().finish_refinement();
    desk_.draw_frame();
    desk_.draw_frame();
  }
  [[nodiscard]] ui::WindowPoint middle(double right = 0.0, double down = 0.0) {
    const ui::WindowRect& place = desk_.offscreen().workbench().place().rect;
    return {place.origin.x + place.size.width / 2.0 + right,
            place.origin.y + place.size.height / 2.0 + down};
  }
  void stroke(ui::WindowPoint from, ui::WindowPoint to) {
    desk_.drag(from, to);
    settle();
  }
  void click(ui::WindowPoint at) { stroke(at, at); }
  /// What shows under the brush there.
  [[nodiscard]] ShownFaces under(ui::WindowPoint at) {
    const ViewportPlace& place = desk_.offscreen().workbench().place();
    const render::FramebufferPoint pixel = place.to_pixel(at);
    return desk_.scene().shown_faces_in(
        session(), place.size, render::BrushCapsule{pixel, pixel, session().brush().radius},
        Reach::kVisible);
  }
  /// Where the middle of the face under the cursor shows.
  [[nodiscard]] ui::WindowPoint middle_of_face(ui::WindowPoint at) {
    const ViewportPlace& place = desk_.offscreen().workbench().place();
    const ShownFaces faces = under(at);
    const auto corners = faces.refined->mesh->face(faces.faces.front());
    glm::dvec3 sum(0.0);
    for (const std::uint32_t corner : corners) {
      sum += faces.refined->mesh->position(corner);
    }
    const auto shown = render::project(ViewportScene::camera(session(), place.size),
                                       sum / static_cast<double>(corners.size()));
    EXPECT_TRUE(shown);
    return {place.rect.origin.x + shown->point.x, place.rect.origin.y + shown->point.y};
  }
  [[nodiscard]] Painting painting() {
    return {*document().control, document().depths, document().demands};
  }
  [[nodiscard]] std::vector<FineDemand> demands() {
    return {document().demands.all().begin(), document().demands.all().end()};
  }
  [[nodiscard]] std::string undo_name() { return session().history().undo_name(); }

  Desk desk_{{640.0, 480.0}};
};

TEST_F(FinePainting, AStrokeRaisesTheFacesUnderTheBrushAlone) {
  session().perform({kSetBrushRadius, 14.0});
  desk_.point_at(middle());
  desk_.draw_frame();
  const ShownFaces faces = under(middle());
  ASSERT_GT(faces.faces.size(), 1U);
  ASSERT_LT(faces.faces.size(), 30U);
  ASSERT_NE(faces.refined, nullptr);
  const std::vector<FineFace> names = names_of(faces);
  click(middle());
  std::vector<FineDemand> wanted;
  for (const FineFace& name : names) {
    EXPECT_EQ(name.level, 2);
    wanted.push_back({name, 3});
  }
  EXPECT_EQ(document().demands, FineDemands(wanted));
  EXPECT_THAT(document().depths.values(), Each(2));
  EXPECT_EQ(undo_name(), "paint " + std::to_string(names.size()) + " finer faces");
  EXPECT_EQ(count_off(document(), refined()), 0U);
  const std::size_t finer = refined().face_count();
  EXPECT_GT(finer, 96U);
  EXPECT_LT(finer, 200U) << "not all around";

  session().perform(kUndo);
  settle();
  EXPECT_TRUE(document().demands.empty());
  EXPECT_EQ(refined().face_count(), 96U);
  session().perform(kRedo);
  settle();
  EXPECT_EQ(document().demands, FineDemands(wanted));
  EXPECT_EQ(refined().face_count(), finer);
}

TEST_F(FinePainting, WhatIsUnderTheBrushLightsUpAndIsForetold) {
  desk_.point_at(middle());
  desk_.draw_frame();
  session().finish_forecast();
  const auto forecast = session().forecast();
  ASSERT_TRUE(forecast);
  EXPECT_EQ(forecast->faces, under(middle()).faces.size());
  EXPECT_EQ(forecast->depth, 3);
  const std::size_t before = refined().face_count();
  const render::Image lit = desk_.viewport_of(desk_.picture());
  click(middle());
  EXPECT_EQ(static_cast<std::int64_t>(refined().face_count() - before), forecast->added_faces);
  session().perform(kUndo);
  desk_.point_at(ui::WindowPoint{1.0, 1.0});
  const render::Image unlit = desk_.viewport_of(desk_.picture());
  std::size_t differing = 0;
  for (std::size_t i = 0; i < lit.rgba.size(); i += 4) {
    differing += std::equal(&lit.rgba[i], &lit.rgba[i] + 3, &unlit.rgba[i]) ? 0 : 1;
  }
  EXPECT_GT(differing, 100U);
  EXPECT_LT(differing, lit.rgba.size() / 4 / 20) << "a whole control face is more than that";
}

TEST_F(FinePainting, IsTimedFromTheReleaseToThePicture) {
  Workbench& workbench = desk_.offscreen().workbench();
  workbench.note_shown(0.0);
  const auto before = workbench.stroke_seconds();
  click(middle());
  workbench.note_shown(1000.0);
  EXPECT_NE(workbench.stroke_seconds(), before);
}

TEST_F(FinePainting, EachFaceChangesOnceAStroke) {
  const auto there_and_back = [this](bool lets_others_in) {
    desk_.press(middle(-20.0));
    for (const double right : {20.0, -20.0, 20.0, -20.0}) {
      desk_.point_at(middle(right));
      desk_.draw_frame();
      if (lets_others_in) {
        session().finish_refinement();
      }
    }
    desk_.drag(middle(-20.0), middle(-20.0));  // Its release ends the stroke.
    settle();
    const std::vector<FineDemand> all = demands();
    session().perform(kUndo);
    settle();
    return all;
  };
  const std::vector<FineDemand> made = there_and_back(false);
  ASSERT_THAT(made, Not(IsEmpty()));
  for (const FineDemand& demand : made) {
    EXPECT_EQ(demand.face.level, 2);
    EXPECT_EQ(demand.depth, 3);
  }
  // A refinement that is still on its way when a stroke begins waits for its end.
  session().perform(kUndo);
  session().perform(kRedo);
  EXPECT_EQ(there_and_back(true), made);
}

TEST_F(FinePainting, AStrokeGoesByTheMeshThatItBeganOn) {
  const ShownFaces faces = under(middle());
  desk_.press(middle());
  const auto before = session().refinement().shared_refined();
  ASSERT_EQ(faces.refined, before);
  // Something else has it refined anew in mid-stroke.
  session().perform({kSetCreaseSharpness, 1.0});
  session().refinement().wait_until_idle();
  for (int i = 0; i < 3; ++i) {
    desk_.draw_frame();
    EXPECT_EQ(session().refinement().shared_refined(), before);
  }
  desk_.drag(middle(), middle());
  std::vector<FineDemand> wanted;
  for (const FineFace& name : names_of(faces)) {
    wanted.push_back({name, 3});
  }
  EXPECT_EQ(document().demands, FineDemands(wanted));
}

TEST_F(FinePainting, AClickBeforeTheMeshHasFollowedMeansThePlaceThatIsSeen) {
  const ShownFaces seen = under(middle());
  const auto stroke_over_seen = [&] {
    session().begin_fine_stroke(DepthChange::add(1));
    session().touch(seen);
    session().end_stroke();
  };
  stroke_over_seen();
  const std::vector<FineFace> names = names_of(seen);
  stroke_over_seen();
  for (const FineFace& name : names) {
    EXPECT_EQ(depth_asked(painting(), name), 4) << "once more than the first click asked for";
  }
  EXPECT_EQ(demands().size(), names.size()) << "and nothing else";
  session().perform({kOpenBundled, std::string("creature")});
  session().perform(kDiscardChanges);
  session().perform(kRaiseAll);
  stroke_over_seen();
  EXPECT_TRUE(document().demands.empty()) << "of a mesh that is gone";
}

TEST_F(FinePainting, TheOrderOfStrokesAndRepeatsMakeNoDifference) {
  session().perform({kSetTargetDepth, 5});
  // On three sides of the cube.
  const std::array<ui::WindowPoint, 3> places{middle_of_face(middle(0.0, -70.0)),
                                              middle_of_face(middle(-60.0, 20.0)),
                                              middle_of_face(middle(60.0, 20.0))};
  std::array<std::size_t, 3> order{0, 1, 2};
  std::optional<FineDemands> first;
  std::vector<glm::vec3> positions;
  do {
    for (const std::size_t i : order) {
      click(places[i]);
      click(places[order[1]]);
    }
    EXPECT_EQ(document().demands.size(), 3U);
    if (!first) {
      first = document().demands;
      positions.assign(refined().positions.begin(), refined().positions.end());
      EXPECT_EQ(count_off(document(), refined()), 0U);
    }
    EXPECT_EQ(document().demands, *first);
    EXPECT_TRUE(std::ranges::equal(refined().positions, positions));
    session().perform(kClearFine);
    settle();
  } while (std::ranges::next_permutation(order).found);
}

TEST_F(FinePainting, ThatOverlapsLeavesTheSurfaceAsItIsInWhateverOrder) {
  session().perform({kSetBrushRadius, 12.0});
  std::array<ui::WindowPoint, 3> places{middle(-12.0), middle(12.0), middle(0.0, 12.0)};
  for (const bool is_turned : {false, true}) {
    if (is_turned) {
      std::ranges::reverse(places);
    }
    for (const ui::WindowPoint& place : places) {
      stroke(place, middle());
    }
    EXPECT_EQ(count_off(document(), refined()), 0U);
    EXPECT_TRUE(session().refinement().refined()->refinement->cracks.is_watertight());
    session().perform(kClearFine);
    settle();
  }
}

TEST_F(FinePainting, ShiftTakesBackAndEscGivesUp) {
  click(middle());
  click(middle());
  EXPECT_THAT(demands(), Not(IsEmpty()));
  session().perform(kToolLower);
  click(middle());
  click(middle());
  EXPECT_THAT(demands(), IsEmpty());
  EXPECT_THAT(document().depths.values(), Each(2));
  const std::string before = undo_name();
  desk_.press(middle());
  session().perform(kCancel);
  desk_.drag(middle(), middle());
  EXPECT_EQ(session().is_stroking(), false);
  EXPECT_EQ(undo_name(), before);
  click(middle_of_face(middle(0.0, -70.0)));
  EXPECT_EQ(std::ranges::count(document().depths.values(), 2), 5)
      << "lower than its control face is painted: the rest of that is asked for by itself";
  EXPECT_EQ(demands().size(), 3U);
  EXPECT_EQ(refined().face_count(), 96U) << "a hole of one face is filled by those around it";
  session().perform(kUndo);
  settle();
  session().perform({kSetBrushRadius, 300.0});
  session().perform({kTogglePaintThrough, true});
  click(middle());
  EXPECT_EQ(refined().face_count(), 24U);
  EXPECT_THAT(demands(), IsEmpty());
  EXPECT_EQ(count_off(document(), refined()), 0U);
}

TEST_F(FinePainting, SetsTheTargetDepthAndPicksIt) {
  session().perform({kSetTargetDepth, 4});
  click(middle());
  for (const FineDemand& demand : demands()) {
    EXPECT_EQ(demand.depth, 4);
  }
  session().perform({kSetTargetDepth, 1});
  desk_.point_at(middle());
  desk_.draw_frame();
  session().perform(kPickDepth);
  EXPECT_EQ(session().brush().target_depth, 4);
  const auto hover = session().model().hover;
  ASSERT_TRUE(hover && hover->fine);
  EXPECT_EQ(hover->fine->level, 4);
  EXPECT_EQ(hover->fine->depth, 4);
}

TEST_F(FinePainting, ARectangleTakesTheFacesThatShowInIt) {
  session().perform(kToolRectangle);
  desk_.drag(middle(-15.0, -15.0), middle(15.0, 15.0));
  settle();
  const std::size_t shown = demands().size();
  EXPECT_GT(shown, 1U);
  EXPECT_EQ(undo_name(), "rectangle, " + std::to_string(shown) + " finer faces");
  session().perform(kUndo);
  settle();
  session().perform({kTogglePaintThrough, true});
  desk_.drag(middle(-15.0, -15.0), middle(15.0, 15.0));
  settle();
  EXPECT_GT(demands().size(), shown) << "and those behind them";
}

TEST_F(FinePainting, IsMirrored) {
  session().perform({kToggleMirrorX, true});
  session().perform({kToggleMirrorZ, true});
  session().perform({kSetTargetDepth, 4});
  click(middle(40.0, 30.0));
  EXPECT_EQ(demands().size(), 4U);
  const glm::dvec3 centre = document().control->bounds().centre();
  std::size_t deep = 0;
  for (std::size_t v = 0; v < refined().vertex_count(); ++v) {
    if (refined().vertex_levels[v] != 4) {
      continue;
    }
    ++deep;
    const glm::dvec3 away = refined().position(v) - centre;
    for (const glm::dvec3 sign : {glm::dvec3(-1, 1, 1), glm::dvec3(1, 1, -1)}) {
      bool has_image = false;
      for (std::size_t w = 0; w < refined().vertex_count() && !has_image; ++w) {
        has_image = glm::distance(refined().position(w) - centre, sign * away) < 1e-6;
      }
      EXPECT_TRUE(has_image);
    }
  }
  EXPECT_GT(deep, 4U * 4U);
}

TEST_F(FinePainting, IsClearedByAnActionOfItsOwn) {
  click(middle());
  const std::vector<FineDemand> made = demands();
  session().perform(kClearFine);
  EXPECT_THAT(demands(), IsEmpty());
  EXPECT_THAT(document().depths.values(), Each(2));
  EXPECT_FALSE(ui::is_available(session().model(), kClearFine));
  EXPECT_THAT(ui::why_unavailable(session().model(), kClearFine), HasSubstr("Nothing"));
  session().perform(kUndo);
  EXPECT_EQ(demands(), made);
}

TEST_F(FinePainting, IsSavedAndOpened) {
  test::ScratchFolder folder;
  click(middle());
  const std::vector<FineDemand> made = demands();
  session().perform({kSaveProject, {}});
  session().perform({kSaveProjectAs, (folder / "fine.limn").string()});
  session().perform(kUndo);
  session().perform({kOpen, (folder / "fine.limn").string()});
  session().perform(kDiscardChanges);
  EXPECT_EQ(demands(), made);
  settle();
  EXPECT_EQ(count_off(document(), refined()), 0U);
}

TEST_F(FinePainting, SaysWhereItIsNotToBeHad) {
  EXPECT_THAT(ui::why_not_fine(session().model()), IsEmpty());
  EXPECT_TRUE(session().paints_fine());
  session().perform(kShowControl);
  EXPECT_FALSE(session().paints_fine());
  EXPECT_THAT(ui::why_not_fine(session().model()), HasSubstr("control mesh is shown"));
  session().perform({kToggleFine, false});
  session().perform({kToggleFine, true});
  EXPECT_EQ(session().display().show, ui::ShowMode::kRefined) << "who turns it on wants to use it";
  session().perform(kToolFill);
  EXPECT_FALSE(session().paints_fine());
  EXPECT_THAT(ui::why_not_fine(session().model()), HasSubstr("Fills"));
  session().perform(kToolPaint);
  session().perform({kSetScheme, std::string("doo-sabin")});
  EXPECT_FALSE(ui::is_available(session().model(), kToggleFine));
  EXPECT_THAT(ui::why_not_fine(session().model()), HasSubstr("As painted"));
  session().perform({kSetScheme, std::string()});
  session().perform({kToggleLive, false});
  session().perform(kBackToControl);
  EXPECT_THAT(ui::why_not_fine(session().model()), HasSubstr("until you subdivide"));
  session().perform({kOpenBundled, std::string("icosahedron")});
  session().perform(kDiscardChanges);
  session().perform({kToggleLive, true});
  EXPECT_THAT(ui::why_not_fine(session().model()), HasSubstr("until there is a refined mesh"));
  session().perform(kAdaptiveLoop);
  EXPECT_FALSE(ui::is_available(session().model(), kToggleFine));
  EXPECT_THAT(ui::why_not_fine(session().model()), HasSubstr("Loop"));
  session().perform(kRaiseAll);
  settle();
  EXPECT_FALSE(session().paints_fine());
}

TEST_F(FinePainting, TakesWholeFacesWhereNothingIsRefinedYet) {
  session().perform(kZeroAll);
  settle();
  click(middle());
  EXPECT_EQ(std::ranges::count(document().depths.values(), 1), 1);
  EXPECT_THAT(demands(), IsEmpty());
  click(middle());
  EXPECT_EQ(std::ranges::count(document().depths.values(), 1), 1) << "now a quarter of it";
  EXPECT_THAT(demands(), Not(IsEmpty()));
}

TEST_F(FinePainting, WorksOnFacesThatAreNoQuads) {
  for (const auto rule : {kNonQuadsUniformFirstStep, kNonQuadsWherePainted}) {
    session().perform({kOpenBundled, std::string("mixed")});
    session().perform(kDiscardChanges);
    session().perform(rule);
    session().perform({kSetBrushRadius, 30.0});
    session().perform({kToggleFine, false});
    click(middle());
    session().perform({kToggleFine, true});
    for (const double right : {-30.0, 0.0, 30.0}) {
      stroke(middle(right, -20.0), middle(right, 20.0));
    }
    EXPECT_THAT(demands(), Not(IsEmpty()));
    EXPECT_EQ(count_off(document(), refined()), 0U);
    const ShownFaces faces = under(middle());
    ASSERT_NE(faces.refined, nullptr);
    EXPECT_EQ(faces_named(*faces.refined, names_of(faces)), faces.faces);
    session().perform(kToolLower);
    stroke(middle(-30.0), middle(30.0));
    EXPECT_EQ(count_off(document(), refined()), 0U);
    session().perform(kToolPaint);
  }
}

}  // namespace
}  // namespace limn::app
