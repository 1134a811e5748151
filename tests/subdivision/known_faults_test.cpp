// Faults that an earlier program for the same paper had, each as a case of its own.
#include <algorithm>
#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "exactness_check.h"
#include "limn/subdivision/crack_check.h"
#include "subdivision/label_counts.h"
#include "support/shapes.h"

namespace limn {
namespace {

using test::MeshPointer;

/// As that program legalised.
constexpr SubdivisionSettings kGreedy{.legalisation = LegalisationMethod::kGreedy};

VertexLabels labels_of(const ControlMesh& mesh, const std::vector<std::uint8_t>& depths,
                       const SubdivisionSettings& settings = kGreedy) {
  IgnoreProgress progress;
  return legal_labels(mesh, depths, settings, progress).value().labels;
}

RefinedMesh refined_from_labels(const ControlMesh& mesh, const VertexLabels& labels) {
  IgnoreProgress progress;
  return refine(mesh, labels, {}, {}, progress).value();
}

TEST(KnownFault, IllegalFacesLeftBehind) {
  // A cube with one painted face kept one; now none is left, at any level.
  const MeshPointer cube = test::cube();
  for (std::uint8_t depth = 1; depth <= 5; ++depth) {
    const VertexLabels labels = labels_of(*cube, {0, 0, depth, 0, 0, 0});
    EXPECT_THAT(illegal_faces(*cube, labels), ::testing::IsEmpty());
    EXPECT_EQ(test::first_breach(*cube, labels, kGreedy, kAllLevels), "");
  }
}

TEST(KnownFault, TJunctionsWhereOnlyOneEndOfAnEdgeIsPositive) {
  // The four edges at the one positive vertex are split although their other ends are zero.
  const MeshPointer grid = test::control_mesh(test::grid_soup(4, 4));
  VertexLabels labels(25, 0);
  labels[12] = 1;
  const RefinedMesh mesh = refined_from_labels(*grid, labels);
  EXPECT_EQ(mesh.polygon_count(), 0u);
  EXPECT_EQ(mesh.vertex_count(), 25u + 4u + 4u);
  EXPECT_EQ(mesh.face_count(), 12u + 4u * 3u);
  const CrackCheck cracks = check_cracks(*grid, mesh);
  EXPECT_TRUE(cracks.is_watertight());
  EXPECT_EQ(cracks.boundary_edges, 16u);
}

TEST(KnownFault, OffTheUniformSurfaceFromTheSecondStepOn) {
  const MeshPointer cube = test::cube();
  const test::UniformReference reference(*cube, 5, CornerRule::kSharp);
  const VertexLabels labels = labels_of(*cube, {5, 0, 0, 0, 0, 0});
  for (int levels = 1; levels <= 5; ++levels) {
    const test::Exactness exactness = reference.compare(labels, {}, levels);
    EXPECT_EQ(exactness.difference, "");
    EXPECT_EQ(exactness.off, 0u);
  }
}

TEST(KnownFault, LoweringADepthLeftTheOldLabels) {
  const MeshPointer mesh = test::control_mesh(test::torus_soup(6, 5));
  std::vector<std::uint8_t> depths(30, 0);
  depths[7] = depths[8] = 3;
  ASSERT_EQ(std::ranges::max(labels_of(*mesh, depths)), 3);
  depths[7] = depths[8] = 2;
  const VertexLabels labels = labels_of(*mesh, depths);
  EXPECT_EQ(std::ranges::max(labels), 2);
  EXPECT_EQ(std::ranges::max(refined_from_labels(*mesh, labels).face_levels), 2);
}

TEST(KnownFault, PaintingAMixedMeshTwiceAddedTheFirstStepTwice) {
  const MeshPointer mesh = test::control_mesh(test::prism_soup(5));  // 30 corners.
  for (std::uint8_t depth = 1; depth <= 3; ++depth) {
    const std::vector<std::uint8_t> depths(mesh->face_count(), depth);
    const RefinedMesh uniform = refined_from_labels(*mesh, labels_of(*mesh, depths));
    EXPECT_EQ(uniform.face_count(), std::size_t{30} << (2 * depth));
    EXPECT_THAT(uniform.face_levels, ::testing::Each(depth + 1));
  }
}

TEST(KnownFault, PentagonLeavesOppositeZerosAfterTheFirstStep) {
  // (2, 2, 0, 2, 0) + 1: the quad at the fourth corner has labels (2, 0, 2, 0) after one step.
  test::Random random(51);
  const MeshPointer mesh =
      test::control_mesh(test::jittered(test::polygon_in_ring_soup(5), 0.2, random));
  VertexLabels labels(10, 1);
  labels[0] = labels[1] = labels[3] = 3;
  const std::array<std::uint8_t, 5> pentagon{3, 3, 1, 3, 1};
  EXPECT_THAT(child_labels(pentagon, 3, face_point_label(pentagon)),
              ::testing::ElementsAre(2, 0, 2, 0));
  EXPECT_EQ(test::first_breach(*mesh, labels, {}, kAllLevels), "");
  const test::UniformReference reference(*mesh, 3, CornerRule::kSharp);
  const test::Exactness exactness = reference.compare(labels, {}, kAllLevels);
  EXPECT_EQ(exactness.difference, "");
  EXPECT_EQ(exactness.off, 0u);
}

TEST(KnownFault, PolygonHalfRaisedByLegalisation) {
  // Where painted: legalising the ring of a prism raises a vertex of the far cap, so all of it.
  test::Random random(52);
  const MeshPointer mesh = test::control_mesh(test::jittered(test::prism_soup(5), 0.1, random));
  SubdivisionSettings settings = kGreedy;
  settings.non_quads = NonQuadRule::kWherePainted;
  std::vector<std::uint8_t> depths(mesh->face_count(), 0);
  depths[0] = 3;
  const VertexLabels labels = labels_of(*mesh, depths, settings);
  EXPECT_THAT(labels, ::testing::ElementsAre(3, 3, 3, 3, 3, 1, 1, 1, 1, 1));
  EXPECT_EQ(test::first_breach(*mesh, labels, settings, kAllLevels), "");
  const test::UniformReference reference(*mesh, 3, CornerRule::kSharp);
  EXPECT_EQ(reference.compare(labels, settings, kAllLevels).off, 0u);
  EXPECT_EQ(reference.compare(labels, settings, kAllLevels).difference, "");
}

}  // namespace
}  // namespace limn
