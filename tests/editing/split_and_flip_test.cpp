#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "face_lists.h"
#include "limn/editing/edge_edits.h"
#include "limn/mesh/bundled.h"
#include "limn/mesh/statistics.h"
#include "support/attribute_shapes.h"
#include "support/effort.h"

namespace limn::test {
namespace {

using testing::HasSubstr;

TEST(SplitAndFlip, MakesFourTrianglesOfEach) {
  const MeshPointer mesh = control_mesh({{0, 0, 0}, {8, 0, 0}, {0, 8, 0}}, {{0, 1, 2}});
  const auto finer = upsample_by_split_and_flip(*mesh, CornerRule::kSmooth);
  ASSERT_TRUE(finer) << finer.error().message;
  ASSERT_EQ((*finer)->vertex_count(), 6u);
  // The boundary rules: 1/8 6/8 1/8 and midpoints.
  EXPECT_EQ((*finer)->positions()[0], glm::dvec3(1, 1, 0));
  EXPECT_EQ((*finer)->positions()[1], glm::dvec3(6, 1, 0));
  EXPECT_EQ((*finer)->positions()[2], glm::dvec3(1, 6, 0));
  const auto& edges = mesh->topology().edge_vertices;
  for (std::size_t e = 0; e < 3; ++e) {
    EXPECT_EQ((*finer)->positions()[3 + e],
              0.5 * (mesh->positions()[edges[e][0]] + mesh->positions()[edges[e][1]]));
  }
  const auto sharp = upsample_by_split_and_flip(*mesh);
  EXPECT_EQ((*sharp)->positions()[1], glm::dvec3(8, 0, 0));
}

TEST(SplitAndFlip, SpreadsTextureLinearly) {
  const MeshPointer mesh = control_mesh(triangulated(grid_soup(3, 2)));
  // Every vertex has a texture point at its x and y.
  MeshAttributes attributes = mesh->attributes();
  for (const glm::dvec3& p : mesh->positions()) {
    attributes.texture.values.emplace_back(p.x, p.y);
  }
  attributes.texture.corner_values = mesh->topology().corner_vertices;
  const auto finer = upsample_by_split_and_flip(mesh->with_attributes(attributes));
  ASSERT_TRUE(finer) << finer.error().message;
  const TextureCoordinates& texture = (*finer)->texture();
  for (std::size_t c = 0; c < texture.corner_values.size(); ++c) {
    const std::uint32_t v = (*finer)->topology().corner_vertices[c];
    glm::dvec2 place(0.0);
    if (v < mesh->vertex_count()) {
      place = attributes.texture.values[v];
    } else {
      const auto [a, b] = mesh->topology().edge_vertices[v - mesh->vertex_count()];
      place = 0.5 * (attributes.texture.values[a] + attributes.texture.values[b]);
    }
    EXPECT_EQ(texture.values[texture.corner_values[c]], place);
  }
}

TEST(SplitAndFlip, RefusesWhatIsNoTriangle) {
  const auto refused = upsample_by_split_and_flip(*cube());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kFailed);
  EXPECT_THAT(refused.error().message, HasSubstr("Face 0 has 4 sides"));
  EXPECT_THAT(refused.error().message, HasSubstr("Triangulate"));
}

TEST(SplitAndFlip, RefusesTrianglesBackToBack) {
  const MeshPointer mesh = control_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}});
  const auto refused = upsample_by_split_and_flip(*mesh);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("back to back"));
}

TEST(SplitAndFlip, KeepsTheEulerCharacteristicAndTheManifold) {
  Random random(5);
  for (int i = 0; i < 12; ++i) {
    const MeshPointer mesh = random_triangles(i, random);
    const auto finer = upsample_by_split_and_flip(*mesh);
    ASSERT_TRUE(finer) << finer.error().message;
    EXPECT_EQ((*finer)->face_count(), 4 * mesh->face_count());
    EXPECT_EQ(mesh_statistics(**finer).euler_characteristic,
              mesh_statistics(*mesh).euler_characteristic);
    EXPECT_TRUE(is_manifold(faces_of(**finer), (*finer)->vertex_count()));
  }
}

}  // namespace
}  // namespace limn::test
