#include "limn/painting/paint_rule.h"

#include <algorithm>
#include <clocale>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/mesh/bundled.h"

namespace limn {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

PaintRule rule(Selection selection, DepthChange change) {
  return ChangeFaces{std::move(selection), change};
}

std::string complaint(std::string_view text) {
  const Result<PaintRule> parsed = parse_paint_rule(text);
  if (parsed) {
    return "was understood as " + to_string(*parsed);
  }
  EXPECT_EQ(parsed.error().kind, ErrorKind::kUsage);
  return parsed.error().message;
}

TEST(ParsePaintRule, ReadsEverySelection) {
  EXPECT_EQ(parse_paint_rule("all:+1").value(), rule(SelectAll{}, DepthChange::add(1)));
  EXPECT_EQ(parse_paint_rule("visible:-2").value(), rule(SelectVisible{}, DepthChange::add(-2)));
  EXPECT_EQ(parse_paint_rule("dihedral>30:+2").value(),
            rule(SelectDihedral{30.0}, DepthChange::add(2)));
  EXPECT_EQ(parse_paint_rule("faces=0,3-9:=4").value(),
            rule(SelectFaces{{{0, 0}, {3, 9}}}, DepthChange::set(4)));
}

TEST(ParsePaintRule, ReadsRegionsThatGrowFromAFace) {
  EXPECT_EQ(parse_paint_rule("flood=12:=3").value(), rule(SelectFlood{12}, DepthChange::set(3)));
  EXPECT_EQ(parse_paint_rule("smart = 12 , 40.5 : +1").value(),
            rule(SelectSmart{12, 40.5}, DepthChange::add(1)));
  EXPECT_EQ(parse_paint_rule("smart=0,360:+1").value(),
            rule(SelectSmart{0, 360.0}, DepthChange::add(1)));
  EXPECT_EQ(parse_paint_rule("connected=7:-2").value(),
            rule(SelectConnected{7}, DepthChange::add(-2)));
}

TEST(ParsePaintRule, ReadsWhatIsDoneToTheWholePainting) {
  EXPECT_EQ(parse_paint_rule(" grow ").value(), PaintRule(DepthFilter::kGrow));
  EXPECT_EQ(parse_paint_rule("shrink").value(), PaintRule(DepthFilter::kShrink));
  EXPECT_EQ(parse_paint_rule("invert").value(), PaintRule(DepthFilter::kInvert));
  EXPECT_EQ(parse_paint_rule("smooth").value(), PaintRule(DepthFilter::kSmooth));
  EXPECT_EQ(parse_paint_rule("clear").value(), PaintRule(DepthFilter::kClear));
  EXPECT_EQ(parse_paint_rule("mirror=x").value(), PaintRule(MirrorPainting{{.x = true}}));
  EXPECT_EQ(parse_paint_rule("mirror = zx").value(),
            PaintRule(MirrorPainting{{.x = true, .z = true}}));
  EXPECT_EQ(to_string(parse_paint_rule("mirror=zyx").value()), "mirror=xyz");
}

TEST(ParsePaintRule, ReadsDecimals) {
  EXPECT_EQ(parse_paint_rule("dihedral>30.25:+1").value(),
            rule(SelectDihedral{30.25}, DepthChange::add(1)));
  EXPECT_EQ(parse_paint_rule("dihedral>.5:+1").value(),
            rule(SelectDihedral{0.5}, DepthChange::add(1)));
  EXPECT_EQ(parse_paint_rule("dihedral>0:+1").value(),
            rule(SelectDihedral{0.0}, DepthChange::add(1)));
  EXPECT_EQ(parse_paint_rule("dihedral>180:+1").value(),
            rule(SelectDihedral{180.0}, DepthChange::add(1)));
}

TEST(ParsePaintRule, AllowsBlanksAroundTheParts) {
  EXPECT_EQ(parse_paint_rule("  faces = 0 , 3 - 9 : = 4 \r\n").value(),
            parse_paint_rule("faces=0,3-9:=4").value());
  EXPECT_EQ(parse_paint_rule("\tdihedral > 30 :\t+ 2").value(),
            parse_paint_rule("dihedral>30:+2").value());
}

TEST(ParsePaintRule, DoesNotDependOnTheLocale) {
  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8", "C.UTF-8"}) {
    std::setlocale(LC_NUMERIC, locale);  // Where it is not installed this changes nothing.
    EXPECT_EQ(to_string(parse_paint_rule("dihedral>30.5:+1").value()), "dihedral>30.5:+1");
  }
  std::setlocale(LC_NUMERIC, before.c_str());
}

TEST(ParsePaintRule, SaysWhatIsMissing) {
  EXPECT_THAT(complaint(""), HasSubstr("empty"));
  EXPECT_THAT(complaint(" \t "), HasSubstr("empty"));
  EXPECT_THAT(complaint("all"), HasSubstr("no colon"));
  EXPECT_THAT(complaint("all:"), HasSubstr("\"+N\", \"-N\", \"=N\", \"maxN\" or \"minN\""));
  EXPECT_THAT(complaint(":+1"), HasSubstr("which faces"));
  EXPECT_THAT(complaint("faces=:+1"), HasSubstr("names no face"));
  EXPECT_THAT(complaint("faces:+1"), HasSubstr("needs a list"));
  EXPECT_THAT(complaint("dihedral:+1"), HasSubstr("needs a threshold"));
  EXPECT_THAT(complaint("dihedral>:+1"), HasSubstr("Nothing after \"dihedral>\""));
  EXPECT_THAT(complaint("faces=3-:+1"), HasSubstr("\"3-\""));
  EXPECT_THAT(complaint("faces=-3:+1"), HasSubstr("\"-3\""));
  EXPECT_THAT(complaint("faces=1,,2:+1"), HasSubstr("missing beside a comma"));
  EXPECT_THAT(complaint("faces=1,2,:+1"), HasSubstr("missing beside a comma"));
  EXPECT_THAT(complaint("faces=,1:+1"), HasSubstr("missing beside a comma"));
  EXPECT_THAT(complaint("flood:+1"), HasSubstr("as in \"flood=12\""));
  EXPECT_THAT(complaint("connected=:+1"), HasSubstr("as in \"connected=12\""));
  EXPECT_THAT(complaint("smart=,30:+1"), HasSubstr("as in \"smart=12,40\""));
  EXPECT_THAT(complaint("smart=3:+1"), HasSubstr("Nothing after the face of \"smart=\""));
  EXPECT_THAT(complaint("mirror"), HasSubstr("Nothing after \"mirror\""));
  EXPECT_THAT(complaint("mirror="), HasSubstr("\"mirror=xz\""));
}

TEST(ParsePaintRule, NamesWhatItDoesNotKnow) {
  EXPECT_THAT(complaint("some:+1"), HasSubstr("\"some\""));
  EXPECT_THAT(complaint("some:+1"), HasSubstr("\"all\", \"visible\""));
  EXPECT_THAT(complaint("ALL:+1"), HasSubstr("\"ALL\""));
  EXPECT_THAT(complaint("curve>3:+1"), HasSubstr("\"curve>3\""));
  EXPECT_THAT(complaint("all:1"), HasSubstr("\"1\""));
  EXPECT_THAT(complaint("all:+"), HasSubstr("\"+\""));
  EXPECT_THAT(complaint("all:++1"), HasSubstr("\"++1\""));
  EXPECT_THAT(complaint("all:+-1"), HasSubstr("\"+-1\""));
  EXPECT_THAT(complaint("all:=-1"), HasSubstr("\"=-1\""));
  EXPECT_THAT(complaint("all:+1.5"), HasSubstr("\"+1.5\""));
  EXPECT_THAT(complaint("all:+1 2"), HasSubstr("\"+1 2\""));
  EXPECT_THAT(complaint("all:+1:+1"), HasSubstr("\"+1:+1\""));
  EXPECT_THAT(complaint("faces=a:+1"), HasSubstr("\"a\""));
  EXPECT_THAT(complaint("faces=1-2-3:+1"), HasSubstr("\"1-2-3\""));
  EXPECT_THAT(complaint("faces=1.5:+1"), HasSubstr("\"1.5\""));
  EXPECT_THAT(complaint("faces=+1:+1"), HasSubstr("\"+1\""));
  EXPECT_THAT(complaint("dihedral=30:+1"), HasSubstr("needs a threshold"));
  EXPECT_THAT(complaint("dihedral>=30:+1"), HasSubstr("\"=30\""));
  EXPECT_THAT(complaint("dihedral>30rad:+1"), HasSubstr("\"30rad\""));
  EXPECT_THAT(complaint("flood=a:+1"), HasSubstr("\"a\""));
  EXPECT_THAT(complaint("flood=1,2:+1"), HasSubstr("\"1,2\""));
  EXPECT_THAT(complaint("smart=1,x:+1"), HasSubstr("\"x\""));
  EXPECT_THAT(complaint("grow:+1"), HasSubstr("\"grow\""));
  EXPECT_THAT(complaint("groww"), HasSubstr("\"groww\""));
  EXPECT_THAT(complaint("groww"), HasSubstr("\"grow\", \"shrink\""));
  EXPECT_THAT(complaint("mirror=xx"), HasSubstr("\"=xx\""));
  EXPECT_THAT(complaint("mirror=w"), HasSubstr("\"=w\""));
}

TEST(ParsePaintRule, RefusesNumbersOutOfRange) {
  EXPECT_THAT(complaint("all:=11"), HasSubstr("0 to 10"));
  EXPECT_THAT(complaint("all:+11"), HasSubstr("0 to 10"));
  EXPECT_THAT(complaint("all:-99999999999999999999"), HasSubstr("0 to 10"));
  EXPECT_THAT(complaint("faces=4294967296:+1"), HasSubstr("too large"));
  EXPECT_THAT(complaint("faces=99999999999999999999999:+1"), HasSubstr("too large"));
  EXPECT_THAT(complaint("faces=9-3:+1"), HasSubstr("\"3-9\""));
  EXPECT_THAT(complaint("smart=1,360.5:+1"), HasSubstr("0 to 360"));
  EXPECT_THAT(complaint("flood=4294967296:+1"), HasSubstr("\"4294967296\""));
  for (const char* angle : {"-1", "180.01", "1e999", "inf", "nan", "-inf", "--3"}) {
    EXPECT_THAT(complaint(std::string("dihedral>") + angle + ":+1"), HasSubstr("0 to 180"))
        << angle;
  }
}

TEST(ParsePaintRule, QuotesShortlyAndWithoutControlCharacters) {
  const std::string message = complaint(std::string(100000, 'x') + ":+1");
  EXPECT_LT(message.size(), 300U);
  EXPECT_THAT(complaint("\x1B[31m\n:+1"), Not(HasSubstr("\x1B")));
}

TEST(ParsePaintRule, ToStringReadsBackTheSame) {
  std::mt19937 random(30);
  for (int round = 0; round < 2000; ++round) {
    Selection selection;
    switch (random() % 7) {
      case 3:
        selection = SelectFlood{static_cast<std::uint32_t>(random())};
        break;
      case 4:
        selection = SelectConnected{static_cast<std::uint32_t>(random())};
        break;
      case 5:
        selection = SelectSmart{static_cast<std::uint32_t>(random()),
                                std::uniform_real_distribution<>(0.0, 360.0)(random)};
        break;
      case 0:
        selection = SelectAll{};
        break;
      case 1:
        selection = SelectVisible{};
        break;
      case 2:
        selection = SelectDihedral{std::uniform_real_distribution<>(0.0, 180.0)(random)};
        break;
      default: {
        SelectFaces faces;
        for (auto count = 1 + random() % 5; count > 0; --count) {
          const auto first = static_cast<std::uint32_t>(random() % 1000000);
          faces.ranges.push_back({first, first + static_cast<std::uint32_t>(random() % 3)});
        }
        selection = faces;
      }
    }
    const int amount = static_cast<int>(random() % 21) - 10;
    const PaintRule made = rule(selection, random() % 2 == 0 ? DepthChange::add(amount)
                                                             : DepthChange::set(std::abs(amount)));
    EXPECT_EQ(parse_paint_rule(to_string(made)).value(), made) << to_string(made);
  }
}

TEST(ParsePaintRule, AnyTextGivesARuleOrAComplaint) {
  const std::string letters = "alvisbedihrfcgowmtkxyzpnu=>:+-,./@<0123456789 #\n\t";
  std::mt19937 random(7);
  for (int round = 0; round < 20000; ++round) {
    std::string text = std::vector<std::string>{"all:+1",
                                                "dihedral>30:=2",
                                                "faces=1,2-4:-1",
                                                "visible:+3",
                                                "flood=3:+1",
                                                "smart=3,40:=2",
                                                "connected=1:-1",
                                                "mirror=xz",
                                                "grow",
                                                "tolerance=0.01d:max in painted",
                                                "budget=500t,greatest",
                                                "screen=4px,silhouettes=2@a.json",
                                                "curve=curvature,5/0,40/3:add",
                                                "curvature>12deg:max3 in unpainted"}[random() % 14];
    for (auto count = random() % 4; count > 0; --count) {
      const char letter = letters[random() % letters.size()];
      const std::size_t at = random() % (text.size() + 1);
      if (random() % 2 == 0 || at == text.size()) {
        text.insert(at, 1, letter);
      } else {
        text[at] = letter;
      }
    }
    const Result<PaintRule> parsed = parse_paint_rule(text);
    if (parsed) {
      EXPECT_EQ(parse_paint_rule(to_string(*parsed)).value(), *parsed) << text;
    } else {
      EXPECT_EQ(parsed.error().kind, ErrorKind::kUsage);
      EXPECT_FALSE(parsed.error().message.empty());
    }
  }
}

TEST(ParsePaintRules, ReadsOneALineInOrder) {
  const auto rules = parse_paint_rules(
      "\xEF\xBB\xBF# everything, then the edges\n"
      "all:+1\n"
      "\n"
      "   dihedral>30:+2   # sharp ones\r\n"
      "faces=0:=0",
      "rules.txt");
  EXPECT_THAT(rules.value(), ElementsAre(rule(SelectAll{}, DepthChange::add(1)),
                                         rule(SelectDihedral{30.0}, DepthChange::add(2)),
                                         rule(SelectFaces{{{0, 0}}}, DepthChange::set(0))));
}

TEST(ParsePaintRules, ATextWithoutRulesHasNone) {
  EXPECT_THAT(parse_paint_rules("", "r").value(), IsEmpty());
  EXPECT_THAT(parse_paint_rules("\n\n# nothing\n", "r").value(), IsEmpty());
}

TEST(ParsePaintRules, ErrorsNameSourceAndLine) {
  const auto rules = parse_paint_rules("all:+1\n# fine\n\nall+1\nall:-1\n", "rules.txt");
  ASSERT_FALSE(rules);
  EXPECT_EQ(rules.error().path, "rules.txt");
  EXPECT_EQ(rules.error().line, 4U);
  EXPECT_THAT(to_string(rules.error()), HasSubstr("rules.txt:4: "));
  EXPECT_THAT(rules.error().message, HasSubstr("\"all+1\""));
}

class ApplyPaintRule : public ::testing::Test {
 protected:
  Result<void> apply(std::string_view text, const VisibleFaces& visible = {}) {
    PaintContext context;
    context.visible = visible;
    return apply_paint_rule(*cube_, parse_paint_rule(text).value(), context, depths_);
  }

  std::shared_ptr<const ControlMesh> cube_ = load_bundled_mesh("cube").value().mesh;
  FaceDepths depths_{cube_->face_count()};
};

TEST_F(ApplyPaintRule, RulesWorkOneAfterTheOther) {
  ASSERT_TRUE(apply("all:+2"));
  ASSERT_TRUE(apply("faces=1,3-4:-1"));
  ASSERT_TRUE(apply("faces=5:=10"));
  EXPECT_THAT(depths_.values(), ElementsAre(2, 1, 2, 1, 1, 10));
  ASSERT_TRUE(apply("dihedral>30:+1"));
  EXPECT_THAT(depths_.values(), ElementsAre(3, 2, 3, 2, 2, 10));
  ASSERT_TRUE(apply("visible:=0", [] { return std::vector<std::uint32_t>{0, 5}; }));
  EXPECT_THAT(depths_.values(), ElementsAre(0, 2, 3, 2, 2, 0));
}

TEST_F(ApplyPaintRule, RegionsGrowOverThePaintingSoFar) {
  ASSERT_TRUE(apply("faces=0,1:=1"));  // Left and right, far from each other.
  ASSERT_TRUE(apply("flood=0:+1"));
  EXPECT_THAT(depths_.values(), ElementsAre(2, 1, 0, 0, 0, 0));
  ASSERT_TRUE(apply("flood=4:=3"));
  EXPECT_THAT(depths_.values(), ElementsAre(2, 1, 3, 3, 3, 3));
  ASSERT_TRUE(apply("smart=0,90:-1"));
  EXPECT_THAT(depths_.values(), ElementsAre(1, 1, 2, 2, 2, 2));
  ASSERT_TRUE(apply("connected=3:+1"));
  EXPECT_THAT(depths_.values(), ElementsAre(2, 2, 3, 3, 3, 3));
}

TEST_F(ApplyPaintRule, ThePaintingChangesAsAWhole) {
  ASSERT_TRUE(apply("faces=0:=4"));
  ASSERT_TRUE(apply("mirror=x"));
  EXPECT_THAT(depths_.values(), ElementsAre(4, 4, 0, 0, 0, 0));
  ASSERT_TRUE(apply("invert"));
  EXPECT_THAT(depths_.values(), ElementsAre(0, 0, 4, 4, 4, 4));
  ASSERT_TRUE(apply("shrink"));
  EXPECT_THAT(depths_.values(), Each(0));
  ASSERT_TRUE(apply("faces=2:=5"));
  ASSERT_TRUE(apply("smooth"));
  EXPECT_THAT(depths_.values(), ElementsAre(1, 1, 1, 0, 1, 1));
  ASSERT_TRUE(apply("grow"));
  EXPECT_THAT(depths_.values(), Each(1));
  ASSERT_TRUE(apply("clear"));
  EXPECT_THAT(depths_.values(), Each(0));
}

TEST_F(ApplyPaintRule, StaysWithinTheRange) {
  for (int i = 0; i < kMaxDepth + 3; ++i) {
    ASSERT_TRUE(apply("all:+1"));
  }
  EXPECT_THAT(depths_.values(), Each(kMaxDepth));
  for (int i = 0; i < kMaxDepth + 3; ++i) {
    ASSERT_TRUE(apply("all:-1"));
  }
  EXPECT_THAT(depths_.values(), Each(0));
}

TEST_F(ApplyPaintRule, AnErrorLeavesTheDepthsAsTheyWere) {
  ASSERT_TRUE(apply("faces=2:=3"));
  const FaceDepths before = depths_;
  EXPECT_FALSE(apply("faces=0-99:+1"));
  EXPECT_EQ(depths_, before);
  EXPECT_FALSE(apply("visible:+1"));
  for (const char* rule : {"flood=6:+1", "smart=6,40:+1", "connected=6:+1"}) {
    EXPECT_FALSE(apply(rule));
  }
  EXPECT_EQ(depths_, before);
}

}  // namespace
}  // namespace limn
