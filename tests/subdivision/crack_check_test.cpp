#include "limn/subdivision/crack_check.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/subdivision/label_subdivision.h"
#include "support/shapes.h"

namespace limn {
namespace {

using test::MeshPointer;

RefinedMesh refined_by_depths(const ControlMesh& mesh, const std::vector<std::uint8_t>& depths) {
  IgnoreProgress progress;
  const auto legal = legal_labels(mesh, depths, {}, progress);
  return refine(mesh, legal.value().labels, {}, {}, progress).value();
}

void remove_quad(RefinedMesh& mesh, std::size_t f) {
  const auto at = static_cast<std::ptrdiff_t>(f);
  mesh.quads.erase(mesh.quads.begin() + at);
  mesh.face_control_faces.erase(mesh.face_control_faces.begin() + at);
  mesh.face_levels.erase(mesh.face_levels.begin() + at);
}

TEST(CrackCheck, PassesWholeMeshes) {
  for (const MeshPointer& mesh : {test::cube(), test::control_mesh(test::grid_soup(4, 3)),
                                  test::control_mesh(test::polygon_in_ring_soup(5))}) {
    std::vector<std::uint8_t> depths(mesh->face_count(), 0);
    depths[0] = 3;
    const RefinedMesh whole = refined_by_depths(*mesh, depths);
    const CrackCheck check = check_cracks(*mesh, whole);
    EXPECT_TRUE(check.is_watertight());
    EXPECT_TRUE(check.crack_faces.empty());
    EXPECT_EQ(check.boundary_edges == 0, mesh->is_closed());
  }
}

TEST(CrackCheck, CountsTheWholeBoundaryOfAnOpenMesh) {
  const MeshPointer mesh = test::control_mesh(test::grid_soup(4, 3));
  const CrackCheck check =
      check_cracks(*mesh, refined_by_depths(*mesh, std::vector<std::uint8_t>(12, 2)));
  EXPECT_EQ(check.boundary_edges, 14u * 4u);
  EXPECT_EQ(check.control_boundary_edges, 14u * 4u);
}

TEST(CrackCheck, FindsEveryMissingQuad) {
  test::Random random(21);
  const std::vector<MeshPointer> meshes{test::cube(), test::control_mesh(test::grid_soup(3, 3)),
                                        test::control_mesh(test::grid_soup(1, 1)),
                                        test::control_mesh(test::polygon_in_ring_soup(3))};
  for (const MeshPointer& mesh : meshes) {
    for (int painting = 0; painting < 6; ++painting) {
      const RefinedMesh whole =
          refined_by_depths(*mesh, test::random_depths(*mesh, 0.3, 4, random));
      for (std::size_t f = 0; f < whole.quads.size(); ++f) {
        RefinedMesh holed = whole;
        remove_quad(holed, f);
        ASSERT_FALSE(check_cracks(*mesh, holed).is_watertight())
            << "quad " << f << " of " << whole.quads.size();
      }
    }
  }
}

TEST(CrackCheck, FindsAVertexTornInTwo) {
  // One quad gets a vertex of its own in place of a shared one: its two edges there open.
  const MeshPointer mesh = test::cube();
  RefinedMesh torn = refined_by_depths(*mesh, {3, 0, 0, 0, 0, 0});
  const std::size_t f = torn.quads.size() / 2;
  torn.positions.push_back(torn.positions[torn.quads[f][0]]);
  torn.vertex_levels.push_back(torn.vertex_levels[torn.quads[f][0]]);
  torn.quads[f][0] = static_cast<std::uint32_t>(torn.positions.size() - 1);
  const CrackCheck check = check_cracks(*mesh, torn);
  EXPECT_EQ(check.boundary_edges, 4u);
  EXPECT_EQ(check.control_boundary_edges, 0u);
  EXPECT_THAT(check.crack_faces, ::testing::Contains(f));
  EXPECT_EQ(check.crack_faces.size(), 3u);
}

TEST(CrackCheck, FindsATJunction) {
  // A neighbour's label is forgotten: the split face meets a face that kept its edge whole.
  const MeshPointer mesh = test::control_mesh(test::grid_soup(2, 1));
  RefinedMesh junction;
  junction.positions.resize(11);
  junction.vertex_levels.assign(11, 1);
  junction.vertex_levels[2] = junction.vertex_levels[5] = 0;
  // Left face into four (6 below, 7 right, 8 above, 9 left, 10 centre), right face as it was.
  junction.quads = {{0, 6, 10, 9}, {6, 1, 7, 10}, {10, 7, 4, 8}, {9, 10, 8, 3}, {1, 2, 5, 4}};
  junction.face_control_faces = {0, 0, 0, 0, 1};
  junction.face_levels = {1, 1, 1, 1, 0};
  const CrackCheck check = check_cracks(*mesh, junction);
  EXPECT_FALSE(check.is_watertight());
  EXPECT_THAT(check.crack_faces, ::testing::ElementsAre(1, 2, 4));
}

TEST(CrackCheck, FindsDoubledEdgesAndFlippedFaces) {
  const MeshPointer mesh = test::cube();
  const RefinedMesh whole = refined_by_depths(*mesh, {2, 0, 0, 0, 0, 0});
  RefinedMesh doubled = whole;
  doubled.quads.push_back(whole.quads[3]);
  doubled.face_control_faces.push_back(whole.face_control_faces[3]);
  doubled.face_levels.push_back(whole.face_levels[3]);
  EXPECT_EQ(check_cracks(*mesh, doubled).nonmanifold_edges, 4u);
  RefinedMesh flipped = whole;
  std::ranges::reverse(flipped.quads[3]);
  EXPECT_EQ(check_cracks(*mesh, flipped).nonmanifold_edges, 4u);
}

}  // namespace
}  // namespace limn
