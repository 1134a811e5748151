#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/mesh/bundled.h"
#include "limn/painting/rule_presets.h"
#include "limn/subdivision/fine_demands.h"

namespace limn {
namespace {

using testing::Each;
using testing::HasSubstr;

TEST(RulePresets, BundledOnesCanBeRead) {
  std::set<std::string> names;
  for (const RulePreset& preset : bundled_presets()) {
    EXPECT_TRUE(names.insert(preset.name).second) << preset.name << " is there twice";
    EXPECT_FALSE(preset.description.empty());
    const auto rules = rules_of_preset({}, preset.name);
    ASSERT_TRUE(rules) << to_string(rules.error());
    EXPECT_FALSE(rules->empty());
    EXPECT_FALSE(check_preset_name(preset.name)) << "bundled ones cannot be replaced";
  }
}

TEST(RulePresets, OwnOnesAreFoundAndMissingOnesNamed) {
  const std::vector<RulePreset> own{{"mine", "", "all:+1\n# then\ngrow\n"},
                                    {"bad", "", "all:+x\n"}};
  EXPECT_EQ(rules_of_preset(own, "mine").value().size(), 2U);
  const auto bad = rules_of_preset(own, "bad");
  ASSERT_FALSE(bad);
  EXPECT_THAT(to_string(bad.error()), HasSubstr("preset bad"));
  const auto missing = rules_of_preset(own, "yours");
  ASSERT_FALSE(missing);
  EXPECT_THAT(missing.error().message, testing::AllOf(HasSubstr("mine"), HasSubstr("draft")));
}

TEST(RulePresets, NamesAreWordsThatCanBeTyped) {
  for (const char* good : {"a", "Print 0.2 mm", "x-1_b.c"}) {
    EXPECT_TRUE(check_preset_name(good)) << good;
  }
  for (const std::string& bad :
       {std::string(), std::string(" a"), std::string("a "), std::string("a\nb"),
        std::string("a/b"), std::string("\xC3\xA4"), std::string(41, 'a')}) {
    EXPECT_FALSE(check_preset_name(bad)) << bad;
  }
}

TEST(PlanPaintRules, IsWhatTheRulesDoOneAfterTheOther) {
  const auto mesh = load_bundled_mesh("mixed").value().mesh;
  const auto rules =
      parse_paint_rules("faces=0-9:=2\ngrow\ntolerance=0.01d:max in painted\n", "r").value();
  const FaceDepths before(mesh->face_count());
  FaceDepths one_by_one = before;
  for (const PaintRule& rule : rules) {
    ASSERT_TRUE(apply_paint_rule(*mesh, rule, {}, one_by_one));
  }
  const auto plan = plan_paint_rules(*mesh, rules, {}, before);
  ASSERT_TRUE(plan);
  FaceDepths at_once = before;
  apply_edits(at_once, plan->edits);
  EXPECT_EQ(at_once, one_by_one);
  EXPECT_TRUE(plan->expected_error);
  EXPECT_FALSE(plan->drops_demands);
}

TEST(PlanPaintRules, EndsAtTheFirstThatFails) {
  const auto mesh = load_bundled_mesh("cube").value().mesh;
  const auto plan = plan_paint_rules(*mesh, parse_paint_rules("all:+1\nvisible:+1\n", "r").value(),
                                     {}, FaceDepths(6));
  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().kind, ErrorKind::kUsage);
}

TEST(PlanPaintRules, ClearingDropsWhatIsPaintedOnFinerFaces) {
  const auto mesh = load_bundled_mesh("cube").value().mesh;
  const auto plan = [&](const char* text) {
    return plan_paint_rules(*mesh, parse_paint_rules(text, "r").value(), {}, FaceDepths(6)).value();
  };
  EXPECT_TRUE(plan("clear\nall:+1\n").drops_demands);
  EXPECT_FALSE(plan("all:=0\n").drops_demands);
}

TEST(PaintRule, SaysWhetherItAsksWhatIsVisible) {
  const auto asks = [](const char* text) {
    return asks_what_is_visible(parse_paint_rule(text).value());
  };
  EXPECT_TRUE(asks("visible:+1"));
  EXPECT_TRUE(asks("budget=50 in visible"));
  EXPECT_FALSE(asks("all:+1 in painted"));
  EXPECT_FALSE(asks("screen=4px"));
}

}  // namespace
}  // namespace limn
