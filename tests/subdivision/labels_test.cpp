#include "limn/subdivision/labels.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/subdivision/label_subdivision.h"
#include "support/shapes.h"

namespace limn {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(QuadPattern, FollowsFromWhichLabelsArePositive) {
  for (int bits = 0; bits < 16; ++bits) {
    const int a = bits & 1;
    const int b = (bits >> 1 & 1) * 3;
    const int c = (bits >> 2 & 1) * 2;
    const int d = (bits >> 3 & 1) * 5;
    const int positive = (a > 0) + (b > 0) + (c > 0) + (d > 0);
    FacePattern expected = FacePattern::kSplit;
    if (positive == 0) {
      expected = FacePattern::kStays;
    } else if (positive == 1) {
      expected = FacePattern::kY;
    } else if (bits == 3 || bits == 6 || bits == 12 || bits == 9) {
      expected = FacePattern::kIllegal;
    }
    EXPECT_EQ(quad_pattern(a, b, c, d), expected) << bits;
  }
}

TEST(VertexLabels, AreTheGreatestDepthAround) {
  const auto mesh = test::control_mesh(test::grid_soup(3, 1));
  EXPECT_THAT(vertex_labels(*mesh, std::vector<std::uint8_t>{1, 0, 4}),
              ElementsAre(1, 1, 4, 4, 1, 1, 4, 4));
}

TEST(VertexLabels, FallWhenTheOnlyDeepFaceIsLowered) {
  const auto mesh = test::cube();
  std::vector<std::uint8_t> depths(6, 0);
  depths[2] = 3;
  EXPECT_EQ(std::ranges::count(vertex_labels(*mesh, depths), 3), 4);
  depths[2] = 2;
  const VertexLabels lowered = vertex_labels(*mesh, depths);
  EXPECT_EQ(std::ranges::count(lowered, 3), 0);
  EXPECT_EQ(std::ranges::count(lowered, 2), 4);
}

TEST(NonQuadRule, LeavesQuadMeshesAlone) {
  const auto mesh = test::cube();
  const VertexLabels labels = vertex_labels(*mesh, std::vector<std::uint8_t>{0, 0, 2, 0, 0, 0});
  EXPECT_EQ(apply_non_quad_rule(*mesh, labels, NonQuadRule::kUniformFirstStep), labels);
  EXPECT_EQ(apply_non_quad_rule(*mesh, labels, NonQuadRule::kWherePainted), labels);
}

TEST(NonQuadRule, UniformFirstStepAddsOneEverywhere) {
  const auto mesh = test::control_mesh(test::prism_soup(5));
  std::vector<std::uint8_t> depths(mesh->face_count(), 0);
  EXPECT_THAT(
      apply_non_quad_rule(*mesh, vertex_labels(*mesh, depths), NonQuadRule::kUniformFirstStep),
      Each(0));
  depths[0] = 2;
  const VertexLabels plain = vertex_labels(*mesh, depths);
  VertexLabels expected = plain;
  std::ranges::for_each(expected, [](std::uint8_t& label) { ++label; });
  EXPECT_EQ(apply_non_quad_rule(*mesh, plain, NonQuadRule::kUniformFirstStep), expected);
}

TEST(NonQuadRule, PaintingTwiceAddsTheFirstStepOnce) {
  const auto mesh = test::control_mesh(test::prism_soup(5));
  IgnoreProgress progress;
  for (std::uint8_t depth = 1; depth <= 3; ++depth) {  // What "+1 all" makes of the depths.
    const std::vector<std::uint8_t> depths(mesh->face_count(), depth);
    const auto legal = legal_labels(*mesh, depths, {}, progress);
    ASSERT_TRUE(legal);
    EXPECT_THAT(legal->labels, Each(depth + 1));
  }
}

TEST(NonQuadRule, WherePaintedRaisesWholePolygonsAndSpreads) {
  // Two pentagonal prisms' caps share no vertex; painting one quad of the ring touches both.
  const auto mesh = test::control_mesh(test::prism_soup(5));
  VertexLabels labels(10, 0);
  labels[0] = 3;
  labels = apply_non_quad_rule(*mesh, labels, NonQuadRule::kWherePainted);
  EXPECT_THAT(labels, ElementsAre(3, 1, 1, 1, 1, 0, 0, 0, 0, 0));
  labels[7] = 2;
  labels = apply_non_quad_rule(*mesh, labels, NonQuadRule::kWherePainted);
  EXPECT_THAT(labels, ElementsAre(3, 1, 1, 1, 1, 1, 1, 2, 1, 1));
  EXPECT_THAT(apply_non_quad_rule(*mesh, VertexLabels(10, 0), NonQuadRule::kWherePainted), Each(0));
}

TEST(IllegalFaces, AreQuadsWithTwoZerosInEitherArrangement) {
  const auto mesh = test::control_mesh(test::grid_soup(3, 1));
  //  1 1 0 1
  //  1 1 0 0   faces: three, no, opposite... lower row first.
  EXPECT_THAT(illegal_faces(*mesh, {1, 1, 0, 0, 1, 1, 0, 1}), ElementsAre(1));
  EXPECT_THAT(illegal_vertices(*mesh, {1, 1, 0, 0, 1, 1, 0, 1}), ElementsAre(2, 6));
  EXPECT_THAT(illegal_faces(*mesh, {1, 0, 1, 0, 0, 1, 0, 1}), ElementsAre(0, 1, 2));
  EXPECT_THAT(illegal_faces(*mesh, {1, 0, 0, 0, 0, 0, 0, 1}), IsEmpty());
  const auto prism = test::control_mesh(test::polygon_in_ring_soup(3));
  EXPECT_THAT(illegal_faces(*prism, {1, 0, 0, 0, 0, 0}), IsEmpty());
}

}  // namespace
}  // namespace limn
