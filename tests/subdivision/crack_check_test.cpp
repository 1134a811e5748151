#include "limn/subdivision/crack_check.h"

#include <algorithm>
#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/subdivision/label_subdivision.h"
#include "support/effort.h"
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
  const auto stride = static_cast<std::size_t>(1.0 / test::effort());
  const std::vector<MeshPointer> meshes{test::cube(), test::control_mesh(test::grid_soup(3, 3)),
                                        test::control_mesh(test::grid_soup(1, 1)),
                                        test::control_mesh(test::polygon_in_ring_soup(3))};
  for (const MeshPointer& mesh : meshes) {
    for (int painting = 0; painting < 6; ++painting) {
      const RefinedMesh whole =
          refined_by_depths(*mesh, test::random_depths(*mesh, 0.3, 4, random));
      for (std::size_t f = 0; f < whole.quads.size(); f += stride) {
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

TEST(CrackCheck, FindsAPieceMissingAtTheBoundaryThatLeavesAsManyEdges) {
  // Of a quad refined twice, the two quads in the middle of side 0 -> 1 become triangles: the
  // boundary passes beside what was its middle, on as many edges.
  const MeshPointer mesh = test::control_mesh(test::grid_soup(1, 1));
  RefinedMesh bitten = refined_by_depths(*mesh, {2});
  ASSERT_EQ(bitten.quads.size(), 16u);
  const auto side_from = [&](std::uint32_t v) {
    for (const auto& quad : bitten.quads) {
      for (std::size_t i = 0; i < 4; ++i) {
        const std::uint32_t to = quad[(i + 1) % 4];
        const bool is_boundary = std::ranges::none_of(bitten.quads, [&](const auto& other) {
          return std::ranges::any_of(std::array{0, 1, 2, 3}, [&](int j) {
            return other[static_cast<std::size_t>(j)] == to &&
                   other[static_cast<std::size_t>((j + 1) % 4)] == v;
          });
        });
        if (quad[i] == v && is_boundary) {
          return to;
        }
      }
    }
    return kNone;
  };
  const std::uint32_t first = side_from(0);
  const std::uint32_t middle = side_from(first);
  const std::uint32_t last = side_from(middle);
  ASSERT_EQ(side_from(last), 1u);
  for (std::size_t f = bitten.quads.size(); f-- > 0;) {
    std::array<std::uint32_t, 4> quad = bitten.quads[f];
    const auto at = std::ranges::find(quad, middle);
    if (at == quad.end()) {
      continue;
    }
    std::rotate(quad.begin(), at, quad.end());
    remove_quad(bitten, f);
    bitten.polygon_vertices.insert(bitten.polygon_vertices.end(), quad.begin() + 1, quad.end());
    bitten.polygon_offsets.push_back(static_cast<std::uint32_t>(bitten.polygon_vertices.size()));
    bitten.face_control_faces.push_back(0);
    bitten.face_levels.push_back(2);
  }
  ASSERT_EQ(bitten.polygon_count(), 2u);
  const CrackCheck check = check_cracks(*mesh, bitten);
  EXPECT_EQ(check.boundary_edges, 16u);
  EXPECT_EQ(check.control_boundary_edges, 16u);
  EXPECT_EQ(check.unused_vertices, 1u);
  EXPECT_FALSE(check.is_watertight());
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

/// The control mesh itself as the result, as if all its vertices had moved so often.
RefinedMesh unrefined(const ControlMesh& mesh, std::uint8_t level) {
  RefinedMesh same;
  same.positions.resize(mesh.vertex_count());
  same.vertex_levels.assign(mesh.vertex_count(), level);
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    same.polygon_vertices.insert(same.polygon_vertices.end(), face.begin(), face.end());
    same.polygon_offsets.push_back(static_cast<std::uint32_t>(same.polygon_vertices.size()));
    same.face_control_faces.push_back(f);
    same.face_levels.push_back(0);
  }
  return same;
}

TEST(CrackCheck, WantsAsManyBoundaryEdgesAsTheLabelsMake) {
  const MeshPointer mesh = test::control_mesh(test::grid_soup(1, 1));
  EXPECT_TRUE(check_cracks(*mesh, unrefined(*mesh, 0)).is_watertight());
  EXPECT_TRUE(check_cracks(*mesh, unrefined(*mesh, 1)).is_watertight());
  const CrackCheck check = check_cracks(*mesh, unrefined(*mesh, 2));
  EXPECT_EQ(check.boundary_edges, 4u);
  EXPECT_EQ(check.control_boundary_edges, 0u);
  EXPECT_THAT(check.crack_faces, ::testing::ElementsAre(0));
}

TEST(CrackCheck, FindsASplitBoundaryEdgeOfAnUnsplitFace) {
  const MeshPointer mesh = test::control_mesh(test::grid_soup(1, 1));
  RefinedMesh split = unrefined(*mesh, 1);
  split.positions.resize(5);
  split.vertex_levels.push_back(1);
  split.polygon_vertices = {0, 4, 1, 3, 2};
  split.polygon_offsets = {0, 5};
  const CrackCheck check = check_cracks(*mesh, split);
  EXPECT_EQ(check.boundary_edges, 5u);
  EXPECT_EQ(check.control_boundary_edges, 3u);
  EXPECT_THAT(check.crack_faces, ::testing::ElementsAre(0));
}

TEST(CrackCheck, FindsASideFromAVertexToItself) {
  // All edges at the vertex are met twice; that side is the only one without a partner.
  const MeshPointer mesh = test::control_mesh(test::prism_soup(3));
  const RefinedMesh whole = unrefined(*mesh, 0);
  EXPECT_TRUE(check_cracks(*mesh, whole).is_watertight());
  for (std::uint32_t f = 0; f < whole.face_count(); ++f) {
    RefinedMesh broken = whole;
    const std::uint32_t at = whole.polygon_offsets[f];
    broken.polygon_vertices.insert(broken.polygon_vertices.begin() + at,
                                   std::uint32_t{whole.polygon_vertices[at]});
    for (std::size_t later = f + 1; later < broken.polygon_offsets.size(); ++later) {
      ++broken.polygon_offsets[later];
    }
    const CrackCheck check = check_cracks(*mesh, broken);
    EXPECT_EQ(check.boundary_edges, 1u);
    EXPECT_EQ(check.nonmanifold_edges, 0u);
    EXPECT_THAT(check.crack_faces, ::testing::ElementsAre(f));
  }
}

TEST(CrackCheck, CountsAnEdgeOfThousandsOfFacesOnce) {
  const MeshPointer mesh = test::cube();
  RefinedMesh crowded = refined_by_depths(*mesh, {1, 1, 1, 1, 1, 1});
  std::array<std::uint32_t, 4> quad = crowded.quads[5];
  for (int i = 0; i < 20000; ++i) {
    std::ranges::reverse(quad);
    crowded.quads.push_back(quad);
    crowded.face_control_faces.push_back(std::uint32_t{crowded.face_control_faces[5]});
    crowded.face_levels.push_back(1);
  }
  const CrackCheck check = check_cracks(*mesh, crowded);
  EXPECT_EQ(check.nonmanifold_edges, 4u);
  EXPECT_EQ(check.boundary_edges, 0u);
}

}  // namespace
}  // namespace limn
