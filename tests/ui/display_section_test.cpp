// How the mesh is shown, chosen in the panel.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ui/screen.h"

namespace limn::ui {
namespace {

using testing::ElementsAre;

TEST(DisplaySection, ColoursAndMaterialAreChoices) {
  Screen screen({1280, 2000});
  screen.click("Level");
  screen.model.display.tint = Tint::kLevel;
  screen.click("None");
  screen.click("Clay");
  screen.model.display.material = Material::kClay;
  screen.click("Clay");  // That is so already.
  screen.click("Polish");
  screen.click("Numbers");
  EXPECT_THAT(screen.take_actions(),
              ElementsAre(Action(ActionId::kTintLevel), Action(ActionId::kTintNone),
                          Action(ActionId::kMaterialClay), Action(ActionId::kMaterialShiny),
                          Action(ActionId::kToggleNumbers, true)));
}

TEST(DisplaySection, UniformBesideIsAToggle) {
  Screen screen({1280, 2000});
  screen.click("Uniform beside");
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kCompareUniform, true)));
  screen.model.display.second = SchemeSettings{};
  screen.model.display.is_second_uniform = true;
  screen.click("Uniform beside");
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kCompareUniform, false)));
}

TEST(DisplaySection, DistanceIsATint) {
  Screen screen({1280, 2000});
  screen.click("Distance");
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kTintDistance)));
}

TEST(NumbersSection, MeasuresTheDistanceToTheLimit) {
  Screen screen({1280, 3000});
  screen.click("Measure");  // Nothing is refined.
  EXPECT_THAT(screen.take_actions(), testing::IsEmpty());
  screen.model.distance.can_measure = true;
  screen.settle();
  screen.click("Measure");
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kMeasureDistance)));
  screen.model.distance.running = 0.4;
  screen.settle();
  EXPECT_FALSE(screen.has("Measure"));
  screen.click("Cancel");
  EXPECT_THAT(screen.take_actions(), ElementsAre(Action(ActionId::kCancel)));
}

TEST(NumbersSection, WhatIsAmissCanBeLedTo) {
  Screen screen({1280, 3000});
  EXPECT_FALSE(screen.has("next boundary loop"));
  EXPECT_FALSE(screen.has("next T-junction"));
  EXPECT_FALSE(screen.has("next crack"));
  screen.statistics.boundary_loops = 2;
  screen.model.t_junctions = 1;
  RefinementResult result;
  screen.cracks.crack_faces = {4, 7};
  screen.cracks.boundary_edges = 3;
  result.cracks = &screen.cracks;
  screen.model.refinement.result = result;
  screen.settle();
  screen.click("next boundary loop");
  screen.click("next T-junction");
  screen.click("next crack");
  EXPECT_THAT(screen.take_actions(),
              ElementsAre(Action(ActionId::kNextFlaw, static_cast<int>(FlawKind::kBoundary)),
                          Action(ActionId::kNextFlaw, static_cast<int>(FlawKind::kTJunction)),
                          Action(ActionId::kNextFlaw, static_cast<int>(FlawKind::kCrack))));
  EXPECT_FALSE(screen.has("previous crack"));
  screen.model.flaw_focus = FlawFocus{FlawKind::kCrack, 0, 2, {}};
  screen.settle();
  screen.click("previous crack");
  EXPECT_THAT(screen.take_actions(),
              ElementsAre(Action(ActionId::kPreviousFlaw, static_cast<int>(FlawKind::kCrack))));
}

}  // namespace
}  // namespace limn::ui
