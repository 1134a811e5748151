// What becomes of a face by its labels alone.
#include "subdivision/label_counts.h"

#include <algorithm>
#include <array>
#include <functional>

#include <gtest/gtest.h>

#include "limn/subdivision/labels.h"

namespace limn {
namespace {

constexpr std::uint8_t kMost = kLabels - 1;

/// Calls `visit` with every quadruple of labels.
void for_each_labels(const std::function<void(const QuadLabels&)>& visit) {
  for (std::size_t i = 0; i < kLabels * kLabels * kLabels * kLabels; ++i) {
    const auto digit = [i](std::size_t unit) {
      return static_cast<std::uint8_t>(i / unit % kLabels);
    };
    visit({digit(kLabels * kLabels * kLabels), digit(kLabels * kLabels), digit(kLabels), digit(1)});
  }
}

FacePattern pattern_of(const QuadLabels& labels) {
  return quad_pattern(labels[0], labels[1], labels[2], labels[3]);
}

TEST(LabelCounts, LegalityIsInherited) {
  int legal = 0;
  for_each_labels([&](const QuadLabels& labels) {
    if (pattern_of(labels) == FacePattern::kIllegal) {
      EXPECT_EQ(LabelCounts::table().face(labels).quads, 0u);
      return;
    }
    ++legal;
    const std::uint8_t centre = face_point_label(labels);
    for (std::size_t i = 0; i < 4; ++i) {
      if (pattern_of(labels) == FacePattern::kSplit ||
          (pattern_of(labels) == FacePattern::kY && labels[i] > 0)) {
        EXPECT_NE(pattern_of(child_labels(labels, i, centre)), FacePattern::kIllegal);
      }
    }
  });
  EXPECT_GT(legal, 18000);
}

TEST(LabelCounts, AnEdgeLooksTheSameFromBothFaces) {
  // A face's sides have as many vertices as its labels say, whoever is beyond: Euler's formula for
  // the piece, V - E + F = 1, with 4 F = 2 E - B.
  for_each_labels([&](const QuadLabels& labels) {
    const FaceCounts& counts = LabelCounts::table().face(labels);
    if (counts.quads == 0) {
      return;
    }
    std::uint64_t boundary = 4;
    for (std::size_t i = 0; i < 4; ++i) {
      boundary += LabelCounts::table().edge(labels[i], labels[(i + 1) % 4]);
    }
    const std::uint64_t edges = (4ull * counts.quads + boundary) / 2;
    ASSERT_EQ((4ull * counts.quads + boundary) % 2, 0u);
    ASSERT_EQ(counts.inside + boundary + counts.quads, edges + 1);
  });
}

TEST(LabelCounts, MatchUniformSubdivision) {
  for (std::uint8_t depth = 1; depth <= kMost; ++depth) {
    const std::uint32_t side = 1u << depth;
    const FaceCounts& counts = LabelCounts::table().face({depth, depth, depth, depth});
    EXPECT_EQ(counts.quads, side * side);
    EXPECT_EQ(counts.inside, (side - 1) * (side - 1));
    EXPECT_EQ(LabelCounts::table().edge(depth, depth), side - 1);
    const std::array<std::uint8_t, 5> pentagon{depth, depth, depth, depth, depth};
    EXPECT_EQ(LabelCounts::table().split(pentagon).quads, 5 * (side / 2) * (side / 2));
  }
}

}  // namespace
}  // namespace limn
