#include "limn/painting/crease_rule.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/painting/selection.h"
#include "support/shapes.h"

namespace limn {
namespace {

using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Kind = SharpenEdges::Kind;

std::string crease_complaint(std::string_view text) {
  const Result<CreaseRule> parsed = parse_crease_rule(text);
  if (parsed) {
    return "was understood as " + to_string(*parsed);
  }
  EXPECT_EQ(parsed.error().kind, ErrorKind::kUsage);
  return parsed.error().message;
}

Creases creased(const ControlMesh& mesh, std::string_view rule) {
  return apply_crease_rule(mesh, parse_crease_rule(rule).value());
}

/// The mesh after the rules, one after the other.
ControlMesh after(const ControlMesh& mesh, const std::vector<std::string>& rules) {
  ControlMesh result = mesh;
  for (const std::string& rule : rules) {
    MeshAttributes attributes = result.attributes();
    attributes.creases = creased(result, rule);
    result = result.with_attributes(std::move(attributes));
  }
  return result;
}

/// A house: a cube with a roof of two slopes of 45 degrees on it.
test::MeshPointer house() {
  return test::control_mesh({{0, 0, 0},
                             {2, 0, 0},
                             {2, 2, 0},
                             {0, 2, 0},
                             {0, 0, 2},
                             {2, 0, 2},
                             {2, 2, 2},
                             {0, 2, 2},
                             {0, 1, 3},
                             {2, 1, 3}},
                            {{3, 2, 1, 0},
                             {0, 1, 5, 4},
                             {1, 2, 6, 9, 5},
                             {2, 3, 7, 6},
                             {3, 0, 4, 8, 7},
                             {4, 5, 9, 8},
                             {6, 7, 8, 9}});
}

TEST(ParseCreaseRule, ReadsEveryForm) {
  EXPECT_EQ(parse_crease_rule("angle>30:=2").value(),
            CreaseRule(SharpenEdges{SelectEdgesOverAngle{30.0}, Kind::kSet, 2.0f}));
  EXPECT_EQ(parse_crease_rule("all:+0.5").value(),
            CreaseRule(SharpenEdges{SelectAllEdges{}, Kind::kAdd, 0.5f}));
  EXPECT_EQ(parse_crease_rule("creased:-1").value(),
            CreaseRule(SharpenEdges{SelectCreases{}, Kind::kAdd, -1.0f}));
  EXPECT_EQ(parse_crease_rule(" angle > 80.5 : = inf ").value(),
            CreaseRule(SharpenEdges{SelectEdgesOverAngle{80.5}, Kind::kSet, kInfiniteSharpness}));
  EXPECT_EQ(parse_crease_rule(" clear\n").value(), CreaseRule(ClearCreases{}));
}

TEST(ParseCreaseRule, SaysWhatIsWrong) {
  EXPECT_THAT(crease_complaint(""), HasSubstr("is empty"));
  EXPECT_THAT(crease_complaint("angle>30"), HasSubstr("has no colon"));
  EXPECT_THAT(crease_complaint(":=2"), HasSubstr("Nothing before the colon"));
  EXPECT_THAT(crease_complaint("edges:=2"), HasSubstr("\"edges\" does not say which edges"));
  for (const char* angle : {"angle", "angle>", "angle>x", "angle>181", "angle>-1", "angle>nan"}) {
    EXPECT_THAT(crease_complaint(std::string(angle) + ":=2"), HasSubstr("is not an angle"));
  }
  for (const char* change :
       {"", "2", "=", "=-1", "=11", "=nan", "=infinite", "+ -1", "*2", "=2x"}) {
    EXPECT_THAT(crease_complaint("all:" + std::string(change)), HasSubstr("how sharp")) << change;
  }
}

TEST(ParseCreaseRule, TextComesBack) {
  for (const char* text :
       {"angle>30:=2", "angle>0.25:=inf", "all:+0.5", "creased:-1.25", "all:=0", "clear"}) {
    EXPECT_EQ(to_string(parse_crease_rule(text).value()), text);
  }
}

TEST(ApplyCreaseRule, TakesEdgesOverTheAngle) {
  const test::MeshPointer mesh = house();
  const std::vector<double> angles = edge_dihedral_angles(*mesh);
  const Creases creases = creased(*mesh, "angle>45:=2.5");
  int sharp = 0;
  int eaves = 0;
  ASSERT_EQ(creases.edge_sharpness.size(), mesh->edge_count());
  for (std::size_t e = 0; e < mesh->edge_count(); ++e) {
    EXPECT_TRUE(angles[e] > 89.0 || std::abs(angles[e] - 45.0) < 1e-9) << angles[e];
    EXPECT_EQ(creases.edge_sharpness[e], angles[e] > 89.0 ? 2.5f : 0.0f);
    sharp += creases.edge_sharpness[e] > 0.0f ? 1 : 0;
    eaves += angles[e] < 46.0 ? 1 : 0;
  }
  EXPECT_EQ(eaves, 2);  // Where the walls meet the roof: exactly 45 degrees, and not over it.
  EXPECT_EQ(sharp, 13);
  EXPECT_THAT(creased(*mesh, "angle>44:=inf").edge_sharpness, Each(kInfiniteSharpness));
}

TEST(ApplyCreaseRule, BoundaryEdgesAreLeftAlone) {
  const test::MeshPointer mesh = test::grid(3);
  for (const char* rule : {"all:=3", "angle>0:=3"}) {
    const Creases creases = creased(*mesh, rule);
    for (std::size_t e = 0; e < mesh->edge_count(); ++e) {
      const bool is_boundary = mesh->topology().edge_corners[e][1] == kNone;
      EXPECT_EQ(creases.edge_sharpness[e], is_boundary ? 0.0f : 3.0f) << rule;
    }
  }
}

TEST(ApplyCreaseRule, RulesBuildUponEachOther) {
  const test::MeshPointer cube = test::cube();
  EXPECT_THAT(after(*cube, {"all:+1.5", "all:+1"}).creases().edge_sharpness, Each(2.5f));
  EXPECT_THAT(after(*cube, {"all:+9", "all:+9"}).creases().edge_sharpness,
              Each(kInfiniteSharpness));
  EXPECT_THAT(after(*cube, {"all:+1", "creased:-3"}).creases().edge_sharpness, IsEmpty());
  EXPECT_THAT(after(*cube, {"creased:+3"}).creases().edge_sharpness, IsEmpty());
  const Creases roof = after(*house(), {"angle>60:=1", "creased:+1"}).creases();
  EXPECT_EQ(std::ranges::count(roof.edge_sharpness, 2.0f), 13);
  EXPECT_EQ(std::ranges::count(roof.edge_sharpness, 0.0f), 2);
}

TEST(ApplyCreaseRule, ClearTakesCornersToo) {
  MeshAttributes attributes;
  attributes.creases.edge_sharpness.assign(12, 1.0f);
  attributes.creases.vertex_sharpness.assign(8, 2.0f);
  attributes.creases.method = CreasingMethod::kChaikin;
  const ControlMesh mesh = test::cube()->with_attributes(attributes);
  EXPECT_EQ(creased(mesh, "clear"), (Creases{{}, {}, CreasingMethod::kChaikin}));
  EXPECT_EQ(creased(mesh, "all:=0"),
            (Creases{{}, std::vector<float>(8, 2.0f), CreasingMethod::kChaikin}));
}

}  // namespace
}  // namespace limn
