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

}  // namespace
}  // namespace limn::ui
