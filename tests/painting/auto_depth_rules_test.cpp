// Rules that choose depths: what they are called, and what they do to a painting.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/mesh/bundled.h"
#include "limn/painting/paint_rule.h"

namespace limn {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;

std::string refusal(const std::string& text) {
  const Result<PaintRule> rule = parse_paint_rule(text);
  return rule ? "was understood as " + to_string(*rule) : rule.error().message;
}

/// What a rule is written as once it was read.
std::string read(const std::string& text) {
  const Result<PaintRule> rule = parse_paint_rule(text);
  return rule ? to_string(*rule) : rule.error().message;
}

TEST(ParseDepthChoice, ReadsEveryKind) {
  EXPECT_EQ(
      parse_paint_rule("tolerance=0.001d").value(),
      PaintRule(ChooseDepths{ChooseByTolerance{0.001, ChooseByTolerance::Unit::kDiagonals, {}}}));
  EXPECT_EQ(parse_paint_rule("tolerance = 0.5").value(),
            PaintRule(ChooseDepths{ChooseByTolerance{0.5, ChooseByTolerance::Unit::kLength, {}}}));
  EXPECT_EQ(parse_paint_rule("tolerance=0.5px@a.json@b.json:max").value(),
            PaintRule(ChooseDepths{
                ChooseByTolerance{0.5, ChooseByTolerance::Unit::kPixels, {"a.json", "b.json"}},
                DepthMerge::kMax}));
  EXPECT_EQ(
      parse_paint_rule("tolerance=0.5,measured").value(),
      PaintRule(ChooseDepths{ChooseByTolerance{0.5, ChooseByTolerance::Unit::kLength, {}, true}}));
  EXPECT_EQ(parse_paint_rule("budget=50000").value(), PaintRule(ChooseDepths{FaceBudget{}}));
  EXPECT_EQ(parse_paint_rule("budget=7t,greatest:add").value(),
            PaintRule(ChooseDepths{
                FaceBudget{7, FaceBudget::Unit::kTriangles, FaceBudget::Goal::kGreatest},
                DepthMerge::kAdd}));
  EXPECT_EQ(
      parse_paint_rule("screen=4px@camera.json").value(),
      PaintRule(ChooseDepths{ChooseByScreen{{ScreenSize::Of::kEdge, 4.0, 1}, {"camera.json"}}}));
  EXPECT_EQ(parse_paint_rule("screen=16px2,silhouettes=0:min").value(),
            PaintRule(ChooseDepths{ChooseByScreen{{ScreenSize::Of::kArea, 16.0, 0}, {}},
                                   DepthMerge::kMin}));
  EXPECT_EQ(parse_paint_rule("curve=edge,0.01d/0,0.1/4").value(),
            PaintRule(ChooseDepths{ChooseByCurve{
                FaceMeasure::kEdge, DepthCurve::through({{0.01, 0}, {0.1, 4}}).value(), {}}}));
}

TEST(ParseDepthChoice, ReadsSelectionsByMeasure) {
  EXPECT_EQ(parse_paint_rule("curvature>12deg:+1").value(),
            PaintRule(ChangeFaces{SelectMeasured{FaceMeasure::kCurvature, true, 12.0},
                                  DepthChange::add(1)}));
  EXPECT_EQ(parse_paint_rule("distance<0.01d:max2 in unpainted").value(),
            PaintRule(ChangeFaces{SelectMeasured{FaceMeasure::kDistance, false, 0.01},
                                  DepthChange::at_least(2)},
                      SelectPainted{false}));
  EXPECT_EQ(parse_paint_rule("dihedral>30deg:+1").value(),
            parse_paint_rule("dihedral>30:+1").value());
  EXPECT_EQ(parse_paint_rule("painted:min3").value(),
            PaintRule(ChangeFaces{SelectPainted{true}, DepthChange::at_most(3)}));
}

TEST(ParseDepthChoice, IsWrittenAsItIsRead) {
  for (const char* text :
       {"tolerance=0.001d", "tolerance=2:max", "tolerance=0.5px@a.json@b.json:add", "budget=50000",
        "budget=9t,greatest:min in painted", "budget=80,random", "screen=4px",
        "tolerance=0.25px,measured@a.json:max", "screen=16px2,silhouettes=3@c.json",
        "curve=curvature,5/0,20/2,60/4", "curve=screen,4/0,400/5@c.json", "curvature>12deg:+1",
        "screen<3px:=0", "edge>0.1d:max4 in faces=0,2-3", "unpainted:=1", "grow in visible"}) {
    EXPECT_EQ(read(text), text);
  }
}

TEST(ParseDepthChoice, SaysWhatIsWrong) {
  EXPECT_THAT(refusal("tolerance="), HasSubstr("Nothing after \"tolerance=\""));
  EXPECT_THAT(refusal("tolerance=0d"), HasSubstr("above 0"));
  EXPECT_THAT(refusal("tolerance=-1"), HasSubstr("\"-1\""));
  EXPECT_THAT(refusal("tolerance=1mm"), HasSubstr("\"1mm\""));
  EXPECT_THAT(refusal("tolerance=nan"), HasSubstr("\"nan\""));
  EXPECT_THAT(refusal("tolerance=1,2"), HasSubstr("\"2\""));
  EXPECT_THAT(refusal("tolerance=1d@a.json"), HasSubstr("does not look through a camera"));
  EXPECT_THAT(refusal("budget=0"), HasSubstr("from 1 on"));
  EXPECT_THAT(refusal("budget=1e5"), HasSubstr("\"1e5\""));
  EXPECT_THAT(refusal("budget=99999999999999999999"), HasSubstr("no number of faces"));
  EXPECT_THAT(refusal("budget=10,best"), HasSubstr("\"best\""));
  EXPECT_THAT(refusal("screen=4"), HasSubstr("\"screen=4px\""));
  EXPECT_THAT(refusal("screen=4px@"), HasSubstr("name of a camera file"));
  EXPECT_THAT(refusal("screen=4px,silhouettes=9"), HasSubstr("0 to 3"));
  EXPECT_THAT(refusal("curve=height,1/2"),
              HasSubstr("curvature, dihedral, distance, edge or screen"));
  EXPECT_THAT(refusal("tolerance=1d,guessed"), HasSubstr("measured"));
  EXPECT_THAT(refusal("curve=curvature"), HasSubstr("at least one point"));
  EXPECT_THAT(refusal("curve=curvature,5"), HasSubstr("VALUE/DEPTH"));
  EXPECT_THAT(refusal("curve=curvature,5/11"), HasSubstr("\"5/11\""));
  EXPECT_THAT(refusal("curve=curvature,5/1,5/2"), HasSubstr("have to grow"));
  EXPECT_THAT(refusal("tolerance=1d:more"), HasSubstr("\":max\""));
  EXPECT_THAT(refusal("all:+1 in"), HasSubstr("how to paint"));
  EXPECT_THAT(refusal("all:+1 in somewhere"), HasSubstr("\"somewhere\""));
  EXPECT_THAT(refusal("curvature:+1"), HasSubstr("\"curvature>12deg\""));
  EXPECT_THAT(refusal("edge>3deg:+1"), HasSubstr("\"edge>0.01d\""));
}

class ApplyChoice : public testing::Test {
 protected:
  Result<void> apply(const std::string& text) {
    return apply_paint_rule(*mesh_, parse_paint_rule(text).value(), context_, depths_);
  }

  std::shared_ptr<const ControlMesh> mesh_ = load_bundled_mesh("cube").value().mesh;
  PaintContext context_;
  FaceDepths depths_{mesh_->face_count()};
};

TEST_F(ApplyChoice, DepthsGoTogetherAsAsked) {
  // All faces of a cube bend alike, by more than 60 degrees.
  ASSERT_TRUE(apply("faces=0:=1"));
  ASSERT_TRUE(apply("faces=1:=5"));
  const FaceDepths before = depths_;
  ASSERT_TRUE(apply("curve=curvature,60/3"));
  EXPECT_THAT(depths_.values(), Each(3));
  depths_ = before;
  ASSERT_TRUE(apply("curve=curvature,60/3:max"));
  EXPECT_THAT(depths_.values(), ElementsAre(3, 5, 3, 3, 3, 3));
  depths_ = before;
  ASSERT_TRUE(apply("curve=curvature,60/3:min"));
  EXPECT_THAT(depths_.values(), ElementsAre(1, 3, 0, 0, 0, 0));
  depths_ = before;
  ASSERT_TRUE(apply("curve=curvature,60/7:add"));
  EXPECT_THAT(depths_.values(), ElementsAre(8, 10, 7, 7, 7, 7));
}

TEST_F(ApplyChoice, OnlyTheFacesOfTheSelectionChange) {
  ASSERT_TRUE(apply("faces=0,1:=1"));
  ASSERT_TRUE(apply("all:+2 in painted"));
  EXPECT_THAT(depths_.values(), ElementsAre(3, 3, 0, 0, 0, 0));
  ASSERT_TRUE(apply("curve=curvature,60/2 in unpainted"));
  EXPECT_THAT(depths_.values(), ElementsAre(3, 3, 2, 2, 2, 2));
  ASSERT_TRUE(apply("clear in faces=0,5"));
  EXPECT_THAT(depths_.values(), ElementsAre(0, 3, 2, 2, 2, 0));
  ASSERT_TRUE(apply("curvature>60deg:max3 in faces=4-5"));
  EXPECT_THAT(depths_.values(), ElementsAre(0, 3, 2, 2, 3, 3));
  ASSERT_TRUE(apply("curvature<60deg:=9"));
  EXPECT_THAT(depths_.values(), ElementsAre(0, 3, 2, 2, 3, 3));
}

TEST_F(ApplyChoice, WithoutACameraThereAreNoSizesOnTheScreen) {
  const Result<void> applied = apply("screen=4px");
  ASSERT_FALSE(applied);
  EXPECT_THAT(applied.error().message, HasSubstr("camera"));
  EXPECT_FALSE(apply("screen>4px:+1"));
  EXPECT_FALSE(apply("tolerance=1px"));
  EXPECT_THAT(depths_.values(), Each(0));
}

TEST_F(ApplyChoice, TheDistanceToTheLimitIsCatmullClarks) {
  context_.settings.scheme = RefinementScheme::kLoop;
  const Result<void> applied = apply("tolerance=0.01d");
  ASSERT_FALSE(applied);
  EXPECT_THAT(applied.error().message, HasSubstr("Loop"));
  EXPECT_FALSE(apply("budget=1000"));
}

}  // namespace
}  // namespace limn
