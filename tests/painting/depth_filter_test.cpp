#include "limn/painting/depth_filter.h"

#include <algorithm>
#include <set>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/shapes.h"

namespace limn {
namespace {

using enum DepthFilter;
using test::MeshPointer;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::ElementsAreArray;

FaceDepths depths_of(const std::vector<int>& values) {
  FaceDepths depths(values.size());
  for (std::size_t f = 0; f < values.size(); ++f) {
    depths.set(f, values[f]);
  }
  return depths;
}

std::vector<int> filtered(const ControlMesh& mesh, const std::vector<int>& values,
                          DepthFilter filter) {
  const FaceDepths result = filter_depths(mesh, depths_of(values), filter);
  return {result.values().begin(), result.values().end()};
}

/// The face and all that share a vertex with it.
std::set<std::uint32_t> around(const ControlMesh& mesh, std::uint32_t face) {
  std::set<std::uint32_t> found;
  for (std::uint32_t other = 0; other < mesh.face_count(); ++other) {
    for (const std::uint32_t vertex : mesh.face(face)) {
      if (std::ranges::count(mesh.face(other), vertex) > 0) {
        found.insert(other);
      }
    }
  }
  return found;
}

struct Painted {
  MeshPointer mesh;
  FaceDepths depths;
};
std::vector<Painted> random_paintings() {
  test::Random random(5);
  std::vector<Painted> all;
  for (int round = 0; round < 12; ++round) {
    auto soup = round % 2 == 0 ? test::grid_soup(9, 8) : test::torus_soup(9, 6);
    soup = test::with_mixed_faces(soup, random);
    if (round % 3 == 0) {
      soup = test::with_holes(soup, 4, random);
    }
    const MeshPointer mesh = test::control_mesh(soup);
    const auto values = test::random_depths(*mesh, 0.5, 6, random);
    all.push_back({mesh, depths_of({values.begin(), values.end()})});
  }
  return all;
}

TEST(DepthFilter, GrowAndShrinkTakeTheExtremesAround) {
  for (const auto& [mesh, depths] : random_paintings()) {
    const FaceDepths grown = filter_depths(*mesh, depths, kGrow);
    const FaceDepths shrunk = filter_depths(*mesh, depths, kShrink);
    for (std::uint32_t f = 0; f < mesh->face_count(); ++f) {
      int most = 0;
      int least = kMaxDepth;
      for (const std::uint32_t other : around(*mesh, f)) {
        most = std::max(most, depths[other]);
        least = std::min(least, depths[other]);
      }
      EXPECT_EQ(grown[f], most);
      EXPECT_EQ(shrunk[f], least);
    }
  }
}

TEST(DepthFilter, ShrinkingWhatWasGrownLosesNothing) {
  for (const auto& [mesh, depths] : random_paintings()) {
    const FaceDepths closed = filter_depths(*mesh, filter_depths(*mesh, depths, kGrow), kShrink);
    const FaceDepths opened = filter_depths(*mesh, filter_depths(*mesh, depths, kShrink), kGrow);
    for (std::size_t f = 0; f < depths.size(); ++f) {
      EXPECT_GE(closed[f], depths[f]);
      EXPECT_LE(opened[f], depths[f]);
    }
    EXPECT_EQ(filter_depths(*mesh, filter_depths(*mesh, closed, kGrow), kShrink), closed);
  }
}

TEST(DepthFilter, GrowWidensByOneRing) {
  const MeshPointer grid = test::grid(5);
  std::vector<int> spot(25, 0);
  spot[12] = 4;
  EXPECT_THAT(filtered(*grid, spot, kGrow), ElementsAre(0, 0, 0, 0, 0,  //
                                                        0, 4, 4, 4, 0,  //
                                                        0, 4, 4, 4, 0,  //
                                                        0, 4, 4, 4, 0,  //
                                                        0, 0, 0, 0, 0));
}

TEST(DepthFilter, ABoundaryDoesNotShrinkAPainting) {
  const MeshPointer grid = test::grid(3);
  EXPECT_THAT(filtered(*grid, std::vector<int>(9, 2), kShrink), Each(2));
}

TEST(DepthFilter, InvertTurnsTheDeepestToTheShallowest) {
  const MeshPointer grid = test::grid(2);
  EXPECT_THAT(filtered(*grid, {0, 1, 3, 2}, kInvert), ElementsAre(3, 2, 0, 1));
  EXPECT_THAT(filtered(*grid, {3, 2, 0, 1}, kInvert), ElementsAre(0, 1, 3, 2));
  EXPECT_THAT(filtered(*grid, {0, 0, 0, 0}, kInvert), Each(0));
  EXPECT_THAT(filtered(*grid, {2, 2, 2, 2}, kInvert), Each(0));
}

TEST(DepthFilter, SmoothIsTheRoundedMeanAround) {
  for (const auto& [mesh, depths] : random_paintings()) {
    const FaceDepths smoothed = filter_depths(*mesh, depths, kSmooth);
    for (std::uint32_t f = 0; f < mesh->face_count(); ++f) {
      double sum = 0.0;
      const auto near = around(*mesh, f);
      for (const std::uint32_t other : near) {
        sum += depths[other];
      }
      const double mean = sum / static_cast<double>(near.size());
      EXPECT_LE(std::abs(smoothed[f] - mean), 0.5 + 1e-12) << f;
      if (std::abs(std::abs(smoothed[f] - mean) - 0.5) < 1e-12) {
        // A half: the one of the two numbers that is nearer to the face's own.
        const double other = 2.0 * mean - smoothed[f];
        EXPECT_LT(std::abs(smoothed[f] - depths[f]), std::abs(other - depths[f]));
      }
    }
  }
}

TEST(DepthFilter, SmoothMakesStairsOfAStepAndTakesAwayALoneFace) {
  const MeshPointer grid = test::grid(6);
  std::vector<int> step;
  std::vector<int> stairs;
  for (int row = 0; row < 6; ++row) {
    step.insert(step.end(), {3, 3, 3, 0, 0, 0});
    stairs.insert(stairs.end(), {3, 3, 2, 1, 0, 0});
  }
  EXPECT_THAT(filtered(*grid, step, kSmooth), ElementsAreArray(stairs));
  EXPECT_THAT(filtered(*grid, stairs, kSmooth), ElementsAreArray(stairs)) << "at rest";
  std::vector<int> spot(36, 0);
  spot[14] = 4;
  EXPECT_THAT(filtered(*grid, spot, kSmooth), Each(0));
  EXPECT_THAT(filtered(*grid, std::vector<int>(36, 5), kSmooth), Each(5));
}

TEST(DepthFilter, SmoothingComesToRestOrTakesTurns) {
  for (const auto& [mesh, start] : random_paintings()) {
    FaceDepths before = start;
    FaceDepths now = filter_depths(*mesh, before, kSmooth);
    bool is_settled = false;
    for (int round = 0; round < 200 && !is_settled; ++round) {
      const FaceDepths next = filter_depths(*mesh, now, kSmooth);
      is_settled = next == before || next == now;
      before = std::exchange(now, next);
    }
    EXPECT_TRUE(is_settled);
  }
}

TEST(DepthFilter, ClearLeavesNothing) {
  EXPECT_THAT(filtered(*test::cube(), {1, 2, 3, 4, 5, 6}, kClear), Each(0));
}

}  // namespace
}  // namespace limn
