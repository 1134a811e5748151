// The panel of schemes as someone uses it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "ui/panels.h"
#include "ui/scheme_text.h"
#include "ui/screen.h"

namespace limn::ui {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class SchemesSection : public testing::Test {
 protected:
  SchemesSection() : screen_({1280, 1500}) {
    PanelLayout layout;
    layout.paint_open = layout.subdivide_open = layout.display_open = layout.numbers_open = false;
    layout.schemes_open = true;
    screen_.gui().set_layout(layout);
    counts_ = predict_scheme(*screen_.document.control, SchemeSettings{}, kMostSchemeLevels);
    screen_.settle();
    static_cast<void>(screen_.take_actions());
  }

  void show(const SchemeSettings& settings, int level = 0) {
    screen_.document.scheme = settings;
    screen_.document.stage.levels = level;
    screen_.model.scheme.counts = counts_;
    screen_.settle();
  }

  Screen screen_;
  std::vector<SchemeCounts> counts_;
};

TEST_F(SchemesSection, EverySchemeCanBeChosen) {
  for (const SchemeInfo& info : schemes()) {
    screen_.document.scheme.reset();
    screen_.settle();
    screen_.click("Scheme");
    screen_.click("Scheme: " + std::string(info.title));
    EXPECT_THAT(screen_.take_actions(),
                ElementsAre(Action(ActionId::kSetScheme, std::string(info.name))));
  }
  show({.scheme = Scheme::kKobbelt});
  screen_.click("Scheme");
  screen_.click("Scheme: As painted");
  EXPECT_THAT(screen_.take_actions(), ElementsAre(Action(ActionId::kSetScheme, std::string())));
}

TEST_F(SchemesSection, AnyVariantCanStandBeside) {
  screen_.click("Beside it");
  screen_.click("Beside it: Loop, Warren's weights");
  EXPECT_THAT(screen_.take_actions(),
              ElementsAre(Action(ActionId::kSetSecondScheme, std::string("loop:warren"))));
  screen_.model.display.second = scheme_from_word("loop:warren");
  screen_.click("Beside it");
  screen_.click("Beside it: Nothing");
  EXPECT_THAT(screen_.take_actions(),
              ElementsAre(Action(ActionId::kSetSecondScheme, std::string())));
}

TEST_F(SchemesSection, AListStaysOnTheScreen) {
  Screen small({900, 420});
  PanelLayout layout;
  layout.paint_open = layout.subdivide_open = layout.display_open = layout.numbers_open = false;
  layout.schemes_open = true;
  small.gui().set_layout(layout);
  small.settle();
  small.click("Beside it");
  small.settle();
  for (const SchemeSettings& settings : scheme_variants()) {
    const WindowRect entry = small.rect("Beside it: " + scheme_title(settings));
    EXPECT_GE(entry.origin.y, 0.0) << scheme_title(settings);
    EXPECT_LE(entry.origin.y + entry.size.height, 420.0) << scheme_title(settings);
  }
}

TEST_F(SchemesSection, StepsAreOfferedWhereThereIsAScheme) {
  EXPECT_FALSE(screen_.has("Forward"));
  show({.scheme = Scheme::kCatmullClark}, 0);
  screen_.click("Back");
  EXPECT_THAT(screen_.take_actions(), IsEmpty()) << "level 0 is the first";
  screen_.click("Forward");
  screen_.key(Key::kRightArrow);
  EXPECT_THAT(screen_.take_actions(),
              ElementsAre(Action(ActionId::kSchemeForward), Action(ActionId::kSchemeForward)));
  show({.scheme = Scheme::kCatmullClark}, kMostSchemeLevels);
  screen_.click("Forward");
  EXPECT_THAT(screen_.take_actions(), IsEmpty());
  screen_.click("Back");
  screen_.key(Key::kLeftArrow);
  EXPECT_THAT(screen_.take_actions(),
              ElementsAre(Action(ActionId::kSchemeBack), Action(ActionId::kSchemeBack)));
}

TEST_F(SchemesSection, ALineOfTheTableGoesToItsLevel) {
  show({.scheme = Scheme::kCatmullClark}, 1);
  screen_.click("level 4");
  screen_.click("level 1");  // It is there already.
  EXPECT_THAT(screen_.take_actions(), ElementsAre(Action(ActionId::kSetSchemeLevel, 4)));
  EXPECT_FALSE(screen_.has("level 6"));
  show({.scheme = Scheme::kCatmullClark}, 8);
  EXPECT_TRUE(screen_.has("level 8"));
}

TEST_F(SchemesSection, NothingMovesWhileOneStepsThroughTheFirstLevels) {
  show({.scheme = Scheme::kCatmullClark}, 0);
  const WindowRect before = screen_.rect("Beside it");
  for (int level = 1; level <= 5; ++level) {
    show({.scheme = Scheme::kCatmullClark}, level);
    EXPECT_EQ(screen_.rect("Beside it"), before) << level;
  }
  const WindowRect forward = screen_.rect("Forward");
  screen_.model.refinement.running = RunningRefinement{0.5, "Level 3"};
  screen_.settle();
  EXPECT_EQ(screen_.rect("progress").origin.y, forward.origin.y);
}

TEST_F(SchemesSection, LoopAndLinearHaveTheirChoices) {
  show({.scheme = Scheme::kLoop});
  screen_.click("Warren's weights");
  EXPECT_THAT(screen_.take_actions(), ElementsAre(Action(ActionId::kLoopWarren)));
  show({.scheme = Scheme::kLinear});
  EXPECT_FALSE(screen_.has("Warren's weights"));
  screen_.click("Then average");
  EXPECT_THAT(screen_.take_actions(), ElementsAre(Action(ActionId::kLinearAverages)));
}

TEST_F(SchemesSection, AMisfitIsOfferedItsRemedy) {
  show({.scheme = Scheme::kLoop});
  EXPECT_FALSE(screen_.has("Triangulate"));
  screen_.model.scheme.misfit = SchemeMisfit{"Loop takes triangles.", Fitting::kTriangulate};
  screen_.settle();
  EXPECT_FALSE(screen_.has("Forward"));
  EXPECT_FALSE(screen_.has("level 0"));
  screen_.click("Triangulate");
  EXPECT_THAT(screen_.take_actions(), ElementsAre(Action(ActionId::kMakeFit)));
  screen_.model.scheme.misfit->fitting = Fitting::kOneCatmullClarkStep;
  screen_.settle();
  EXPECT_TRUE(screen_.has("One Catmull-Clark step"));
  screen_.model.scheme.misfit->fitting.reset();
  screen_.settle();
  EXPECT_FALSE(screen_.has("One Catmull-Clark step")) << "what would not help is not offered";
}

TEST_F(SchemesSection, ThePlotHasOneStepForEveryPowerOfTen) {
  show({.scheme = Scheme::kCatmullClark});
  EXPECT_FALSE(screen_.has("sphere plot"));
  SphereSeries series{{.scheme = Scheme::kCatmullClark}, {}};
  for (int level = 0; level <= 4; ++level) {
    SphereComparison row;
    row.level = level;
    row.fit = {{}, 1.0, -std::pow(0.1, level), 0.0, 0.5 * std::pow(0.1, level)};
    series.rows.push_back(row);
  }
  const std::vector<SphereSeries> all{series};
  screen_.model.sphere.series = all;
  screen_.settle();
  const WindowRect plot = screen_.rect("sphere plot");
  const auto point = [&](int level) {
    return screen_.rect("r.m.s. of Catmull-Clark, level " + std::to_string(level)).origin;
  };
  const double decade = point(1).y - point(0).y;
  const double step = point(1).x - point(0).x;
  EXPECT_GT(decade, 10.0);
  EXPECT_GT(step, 20.0);
  for (int level = 0; level <= 4; ++level) {
    EXPECT_TRUE(plot.contains(point(level)));
    EXPECT_NEAR(point(level).y, point(0).y + decade * level, 0.1) << "a tenth of the error";
    EXPECT_NEAR(point(level).x, point(0).x + step * level, 0.1);
  }
}

TEST_F(SchemesSection, ComparesWhereASchemeTakesTheMesh) {
  show({.scheme = Scheme::kCatmullClark});
  screen_.click("Compare with a sphere");
  EXPECT_THAT(screen_.take_actions(), ElementsAre(Action(ActionId::kCompareSphere)));
  screen_.model.sphere.running = 0.25;
  screen_.settle();
  EXPECT_FALSE(screen_.has("Compare with a sphere"));
  screen_.click("Cancel");
  EXPECT_THAT(screen_.take_actions(), ElementsAre(Action(ActionId::kCancel)));
}

TEST(SchemeText, WordsGoThereAndBack) {
  std::set<std::string> words;
  for (const SchemeSettings& settings : scheme_variants()) {
    const std::string word = scheme_word(settings);
    EXPECT_TRUE(words.insert(word).second) << word;
    EXPECT_EQ(scheme_from_word(word), settings);
    EXPECT_THAT(scheme_description(settings), HasSubstr("Takes "));
    EXPECT_THAT(scheme_description(settings),
                HasSubstr(std::string(scheme_info(settings.scheme).source)));
  }
  EXPECT_EQ(words.size(), kSchemeCount + 2);
  for (const char* word : {"", "loop:", "loop:averaged", "Loop", "linear:warren"}) {
    EXPECT_EQ(scheme_from_word(word), std::nullopt) << word;
  }
  EXPECT_THAT(scheme_description({.scheme = Scheme::kLoop}), Not(HasSubstr("any number")));
}

}  // namespace
}  // namespace limn::ui
