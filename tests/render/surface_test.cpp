#include <gmock/gmock.h>
#include <algorithm>

#include <glm/geometric.hpp>

#include "limn/progress.h"
#include "limn/subdivision/label_subdivision.h"
#include "render/surface/face_order.h"
#include "render/surface/surface.h"
#include "support/shapes.h"

namespace limn::render {
namespace {

using testing::ElementsAre;

std::vector<std::uint32_t> corners_of(const Surface& surface, const SurfaceGroup& group,
                                      std::uint32_t face_in_group) {
  const auto first = surface.corners.begin() + group.first_corner + face_in_group * group.sides;
  return {first, first + group.sides};
}

TEST(Surface, GroupsFacesBySides) {
  const Surface surface = make_surface(*test::mixed_prism());
  EXPECT_THAT(surface.groups, ElementsAre(SurfaceGroup{3, 0, 2, 0}, SurfaceGroup{4, 2, 4, 6},
                                          SurfaceGroup{5, 6, 2, 22}));
  EXPECT_EQ(surface.corners.size(), 32U);
  EXPECT_EQ(surface.control_face_count, 8U);
}

TEST(Surface, KeepsTheMeshOrderWithinAGroup) {
  const auto mesh = test::mixed_prism();
  const Surface surface = make_surface(*mesh);
  EXPECT_THAT(surface.face_control_faces, ElementsAre(2, 3, 0, 4, 6, 7, 1, 5));
  for (const SurfaceGroup& group : surface.groups) {
    for (std::uint32_t f = 0; f < group.face_count; ++f) {
      const auto source = mesh->face(surface.face_control_faces[group.first_face + f]);
      EXPECT_EQ(corners_of(surface, group, f),
                std::vector<std::uint32_t>(source.begin(), source.end()));
    }
  }
}

TEST(Surface, PositionsAreRelativeToTheCentre) {
  std::vector<glm::dvec3> positions{{1e7, 0, 0}, {1e7 + 1, 0, 0}, {1e7 + 1, 1, 0}, {1e7, 1, 0}};
  const Surface surface = make_surface(*test::control_mesh(positions, {{0, 1, 2, 3}}));
  EXPECT_EQ(surface.origin, glm::dvec3(1e7 + 0.5, 0.5, 0));
  EXPECT_EQ(surface.positions[0], glm::vec3(-0.5F, -0.5F, 0));
  EXPECT_EQ(surface.positions[2], glm::vec3(0.5F, 0.5F, 0));
}

TEST(Surface, NormalsPointOutwardsAndHaveUnitLength) {
  const Surface surface = make_surface(*test::cube());
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    const glm::vec3 diagonal = glm::normalize(surface.positions[v]);
    EXPECT_NEAR(glm::distance(surface.normals[v], diagonal), 0.0F, 1e-6F) << "vertex " << v;
  }
}

TEST(Surface, NormalsAreWeightedByArea) {
  // Two quads share the edge (0,0,0)-(0,1,0): one of area 3 facing +z, one of area 1 facing -x.
  const Surface surface = make_surface(
      *test::control_mesh({{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 1, -1}},
                          {{0, 1, 2, 3}, {0, 3, 5, 4}}));
  const glm::vec3 expected = glm::normalize(glm::vec3(-1, 0, 3));
  EXPECT_NEAR(glm::distance(surface.normals[0], expected), 0.0F, 1e-6F);
  EXPECT_NEAR(glm::distance(surface.normals[1], glm::vec3(0, 0, 1)), 0.0F, 1e-6F);
}

TEST(Surface, ListsEveryControlEdgeOnce) {
  EXPECT_EQ(make_surface(*test::cube()).edges.size(), 12U);
  EXPECT_EQ(make_surface(*test::grid(3)).edges.size(), 24U);
}

RefinedMesh small_refined() {
  RefinedMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}, {1, 2, 0}};
  mesh.vertex_levels.assign(7, 0);
  mesh.quads = {{0, 1, 2, 3}, {1, 4, 5, 2}};
  mesh.polygon_offsets = {0, 3, 6};
  mesh.polygon_vertices = {3, 2, 6, 2, 5, 6};
  mesh.face_control_faces = {4, 4, 1, 0};
  mesh.face_levels = {2, 1, 0, 0};
  return mesh;
}

TEST(Surface, RefinedFacesKnowTheirControlFaceAndLevel) {
  const Surface surface = make_surface(small_refined(), glm::dvec3(1, 1, 0), 5);
  EXPECT_THAT(surface.groups, ElementsAre(SurfaceGroup{3, 0, 2, 0}, SurfaceGroup{4, 2, 2, 6}));
  EXPECT_THAT(surface.face_control_faces, ElementsAre(1, 0, 4, 4));
  EXPECT_THAT(surface.face_levels, ElementsAre(0, 0, 2, 1));
  EXPECT_EQ(surface.positions[4], glm::vec3(1, -1, 0));
  EXPECT_EQ(surface.control_face_count, 5U);
  EXPECT_TRUE(surface.edges.empty());
}

TEST(Surface, RefinedPositionsLoseNothingFarFromTheWorldsOrigin) {
  RefinedMesh mesh = small_refined();
  mesh.origin = {3e9, -1e9, 7e8};
  mesh.positions[0] = {0.1F, 0.2F, 0.3F};
  const Surface same = make_surface(mesh, mesh.origin, 5);
  EXPECT_TRUE(std::ranges::equal(same.positions, mesh.positions));
  const Surface beside = make_surface(mesh, mesh.origin + glm::dvec3(1, 0, -2), 5);
  EXPECT_EQ(beside.positions[0], glm::vec3(glm::dvec3(mesh.positions[0]) - glm::dvec3(1, 0, -2)));
}

TEST(Surface, RefinedFacesAreFoundBothWays) {
  test::Random random(3);
  const auto control = test::control_mesh(test::with_mixed_faces(test::grid_soup(8, 8), random));
  SubdivisionSettings settings;
  settings.non_quads = NonQuadRule::kWherePainted;
  std::vector<std::uint8_t> depths(control->face_count(), 0);
  depths[0] = 1;
  IgnoreProgress progress;
  const auto labels = legal_labels(*control, depths, settings, progress);
  const RefinedMesh mesh = refine(*control, labels->labels, settings, {}, progress).value();
  ASSERT_GT(mesh.polygon_count(), 1U) << "some faces stay as they are";
  ASSERT_LT(mesh.face_count(), 256U);
  const Surface surface = make_surface(mesh, {}, control->face_count());
  std::vector<std::uint8_t> numbers(mesh.face_count());
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    numbers[f] = static_cast<std::uint8_t>(f);
    const std::vector<std::uint32_t> drawn = drawn_faces(surface, mesh, {&f, 1});
    ASSERT_EQ(drawn.size(), 1U);
    EXPECT_EQ(surface.face_control_faces[drawn[0]], mesh.face_control_faces[f]);
    EXPECT_EQ(surface.face_levels[drawn[0]], mesh.face_levels[f]);
    EXPECT_THAT(refined_faces(surface, mesh, drawn), ElementsAre(f));
  }
  const std::vector<std::uint8_t> in_order = in_drawn_order(surface, mesh, numbers);
  for (std::uint32_t d = 0; d < in_order.size(); ++d) {
    EXPECT_THAT(refined_faces(surface, mesh, {&d, 1}), ElementsAre(in_order[d]));
  }
}

TEST(Surface, EmptyRefinedMeshIsAnEmptySurface) {
  const Surface surface = make_surface(RefinedMesh{}, glm::dvec3(0), 0);
  EXPECT_TRUE(surface.groups.empty());
  EXPECT_EQ(surface.face_count(), 0U);
}

TEST(RefinedSurface, TakesTheLimitsNormals) {
  RefinedMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.quads = {{0, 1, 2, 3}};
  mesh.face_control_faces = {0};
  mesh.face_levels = {0};
  const glm::vec3 up(0, 0, 1);
  const glm::vec3 side(1, 0, 0);
  EXPECT_THAT(make_surface(mesh, glm::dvec3(0), 1).normals, testing::Each(up));
  mesh.normals = {side, side, side, side};
  EXPECT_THAT(make_surface(mesh, glm::dvec3(0), 1).normals, testing::Each(side));
  // Where the limit has no tangent plane the faces around have to do.
  mesh.normals[2] = glm::vec3(0);
  EXPECT_THAT(make_surface(mesh, glm::dvec3(0), 1).normals,
              testing::ElementsAre(side, side, up, side));
}

}  // namespace
}  // namespace limn::render
