// The panel of depths that come about by themselves.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/mesh/bundled.h"
#include "ui/screen.h"

namespace limn::ui {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

class AutoDepthSection : public testing::Test {
 protected:
  AutoDepthSection() {
    screen_.document.control = load_bundled_mesh("cube").value().mesh;
    PanelLayout layout;
    layout.paint_open = false;
    layout.auto_depth_open = true;
    screen_.gui().set_layout(layout);
    screen_.settle();
  }
  AutoDepthSettings& settings() { return screen_.model.auto_depth.settings; }
  void set(const std::string& rule) { settings().rules = {parse_paint_rule(rule).value()}; }

  Screen screen_{{1280, 1000}};
};

TEST_F(AutoDepthSection, ShowsWhatTheSourceCanBeSetTo) {
  const auto shows = [this](std::string_view name) {
    screen_.settle();
    return screen_.has(name);
  };
  set("tolerance=0.001d");
  EXPECT_TRUE(shows("Diagonals") && shows("Depth amount"));
  EXPECT_FALSE(shows("Keep this view"));
  set("tolerance=1px");
  EXPECT_TRUE(shows("Keep this view"));
  set("budget=500");
  EXPECT_TRUE(shows("Triangles") && shows("Worst"));
  EXPECT_FALSE(shows("Diagonals"));
  set("screen=4px");
  EXPECT_TRUE(shows("+2") && shows("Keep this view"));
  set("curve=curvature,5/0,40/3");
  EXPECT_TRUE(shows("depth curve") && shows("curve point 1"));
  EXPECT_FALSE(shows("Depth amount") || shows("Keep this view"));
  set("curve=screen,5/0,40/3");
  EXPECT_TRUE(shows("Keep this view"));
  settings().rules = parse_paint_rules("tolerance=0.1\ngrow\n", "two").value();
  EXPECT_FALSE(shows("Depth amount"));
  EXPECT_TRUE(shows("Choose depths") && shows("Tolerance"));
}

TEST_F(AutoDepthSection, ControlsSayWhatThePersonWants) {
  screen_.click("Budget");
  screen_.click("Live");
  screen_.click("On the limit");
  screen_.click("Choose depths");
  EXPECT_THAT(
      screen_.take_actions(),
      ElementsAre(Action(ActionId::kSetDepthSource, 1), Action(ActionId::kToggleLiveDepths, true),
                  Action(ActionId::kToggleLimitDepths, false), Action(ActionId::kChooseDepths)));
  screen_.click("Tolerance");
  EXPECT_THAT(screen_.take_actions(), IsEmpty()) << "that is chosen already";
  screen_.click("Units");
  set("budget=500");
  screen_.settle();
  screen_.click("Worst");
  set("screen=4px");
  screen_.settle();
  screen_.click("+3");
  EXPECT_THAT(screen_.take_actions(),
              ElementsAre(Action(ActionId::kSetDepthUnit, 1), Action(ActionId::kSetBudgetGoal, 1),
                          Action(ActionId::kSetSilhouettes, 3)));
}

TEST_F(AutoDepthSection, PointsOfTheCurveAreDraggedMadeAndTakenAway) {
  set("curve=curvature,10/0,50/5");
  MeasureHistogram faces{FaceMeasure::kCurvature, 0.0, 100.0, false,
                         std::vector<std::size_t>(10, 3)};
  screen_.model.auto_depth.histogram = &faces;
  screen_.settle();
  const WindowPoint first = screen_.middle("curve point 0");
  const WindowPoint second = screen_.middle("curve point 1");
  const auto points_of = [](const std::vector<Action>& actions) {
    EXPECT_FALSE(actions.empty());
    if (actions.empty()) {
      return std::vector<DepthCurvePoint>();
    }
    EXPECT_EQ(actions.back().id, ActionId::kSetDepthRules);
    const auto rules = parse_paint_rules(std::get<std::string>(actions.back().value), "r").value();
    const auto& choose = std::get<ChooseDepths>(rules.front().action);
    const auto points = std::get<ChooseByCurve>(choose.choice).curve.points();
    return std::vector<DepthCurvePoint>(points.begin(), points.end());
  };

  // Half of the way to the second, which is 20 degrees and two and a half levels.
  screen_.move(first);
  screen_.button(MouseButton::kLeft, true);
  screen_.move({(first.x + second.x) / 2.0, (first.y * 3.0 + second.y * 2.0) / 5.0});
  screen_.settle();
  const std::vector<DepthCurvePoint> dragged = points_of(screen_.take_actions());
  screen_.button(MouseButton::kLeft, false);
  screen_.settle();
  ASSERT_THAT(dragged, SizeIs(2));
  EXPECT_NEAR(dragged[0].value, 30.0, 1.0);
  EXPECT_EQ(dragged[0].depth, 2);
  EXPECT_EQ(dragged[1], (DepthCurvePoint{50.0, 5}));

  // A point does not pass its neighbour.
  static_cast<void>(screen_.take_actions());
  screen_.move(first);
  screen_.button(MouseButton::kLeft, true);
  screen_.move({second.x + 30.0, second.y});
  screen_.settle();
  const std::vector<DepthCurvePoint> held = points_of(screen_.take_actions());
  screen_.button(MouseButton::kLeft, false);
  screen_.settle();
  ASSERT_THAT(held, SizeIs(2));
  EXPECT_LT(held[0].value, 50.0);

  static_cast<void>(screen_.take_actions());
  screen_.click(WindowPoint{(first.x + second.x) / 2.0, first.y - 60.0});
  EXPECT_THAT(points_of(screen_.take_actions()), SizeIs(3));
  screen_.move(second);
  screen_.button(MouseButton::kRight, true);
  screen_.button(MouseButton::kRight, false);
  screen_.settle();
  const std::vector<DepthCurvePoint> left = points_of(screen_.take_actions());
  ASSERT_THAT(left, SizeIs(1));
  EXPECT_EQ(left[0].value, 10.0);
}

TEST_F(AutoDepthSection, NamesAreTypedForPresets) {
  screen_.settle();
  screen_.click("Save");
  EXPECT_THAT(screen_.take_actions(), IsEmpty()) << "there is no name yet";
  screen_.click("preset name");
  screen_.type(U"draft");
  screen_.settle();
  screen_.click("Save");
  EXPECT_THAT(screen_.take_actions(), IsEmpty()) << "that one comes with Limn";
  screen_.click("preset name");
  screen_.type(U"y");
  screen_.settle();
  screen_.click("Save");
  const std::vector<Action> saved = screen_.take_actions();
  ASSERT_THAT(saved, SizeIs(1));
  EXPECT_EQ(saved[0].id, ActionId::kSavePreset);
  const auto& name = std::get<std::string>(saved[0].value);
  const std::vector<RulePreset> own{{name, "", "grow\n"}};
  screen_.model.auto_depth.own_presets = own;
  screen_.click("Delete");
  EXPECT_THAT(screen_.take_actions(), ElementsAre(Action(ActionId::kDeletePreset, name)));
}

}  // namespace
}  // namespace limn::ui
