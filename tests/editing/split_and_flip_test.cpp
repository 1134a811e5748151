#include <algorithm>
#include <cstdint>
#include <memory>
#include <numeric>
#include <span>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "face_lists.h"
#include "limn/editing/edge_edits.h"
#include "limn/mesh/bundled.h"
#include "limn/mesh/statistics.h"
#include "limn/progress.h"
#include "limn/subdivision/schemes/uniform.h"
#include "support/attribute_shapes.h"
#include "support/effort.h"

namespace limn::test {
namespace {

using testing::HasSubstr;

/// For every vertex of one mesh the one of the other at the same place, to `most`; fails where two
/// share one or one has none.
std::vector<std::uint32_t> matched(std::span<const glm::dvec3> one,
                                   const std::vector<glm::dvec3>& other, double most) {
  std::vector<std::uint32_t> by_x(other.size());
  std::iota(by_x.begin(), by_x.end(), 0u);
  std::ranges::sort(by_x, {}, [&](std::uint32_t v) { return other[v].x; });
  std::vector<std::uint32_t> image;
  std::vector<bool> is_taken(other.size(), false);
  for (const glm::dvec3& p : one) {
    std::uint32_t nearest = kNone;
    auto at =
        std::ranges::lower_bound(by_x, p.x - most, {}, [&](std::uint32_t v) { return other[v].x; });
    for (; at != by_x.end() && other[*at].x <= p.x + most; ++at) {
      if (!is_taken[*at] &&
          (nearest == kNone || glm::distance(other[*at], p) < glm::distance(other[nearest], p))) {
        nearest = *at;
      }
    }
    if (nearest == kNone || glm::distance(other[nearest], p) > most) {
      ADD_FAILURE() << "no vertex at " << p.x << " " << p.y << " " << p.z;
      return {};
    }
    is_taken[nearest] = true;
    image.push_back(nearest);
  }
  return image;
}

/// Up to so many levels by hand and by `subdivide`: the same positions and the same set of faces.
void expect_loop(const MeshPointer& mesh, int levels, CornerRule corners) {
  const double most = 1e-6 * mesh->bounds().diagonal();
  MeshPointer by_hand = mesh;
  IgnoreProgress nobody;
  for (int level = 1; level <= levels; ++level) {
    const auto finer = upsample_by_split_and_flip(*by_hand, corners);
    ASSERT_TRUE(finer) << finer.error().message;
    by_hand = *finer;
    const auto direct =
        subdivide(*mesh, {.scheme = Scheme::kLoop, .corners = corners}, {.levels = level}, nobody);
    ASSERT_TRUE(direct) << direct.error().message;
    ASSERT_EQ(by_hand->vertex_count(), direct->vertex_count());
    std::vector<glm::dvec3> positions;
    for (std::size_t v = 0; v < direct->vertex_count(); ++v) {
      positions.push_back(direct->position(v));
    }
    const std::vector<std::uint32_t> image = matched(by_hand->positions(), positions, most);
    ASSERT_EQ(image.size(), positions.size());
    Faces expected;
    for (std::size_t f = 0; f < direct->face_count(); ++f) {
      expected.emplace_back(direct->face(f).begin(), direct->face(f).end());
    }
    Faces faces = faces_of(*by_hand);
    for (auto& face : faces) {
      for (std::uint32_t& v : face) {
        v = image[v];
      }
    }
    ASSERT_EQ(sorted_faces(faces), sorted_faces(expected)) << "level " << level;
  }
}

TEST(SplitAndFlip, EqualsLoopOnBundledMeshes) {
  for (const char* name : {"icosahedron", "cube_triangulated", "sphere"}) {
    SCOPED_TRACE(name);
    expect_loop(load_bundled_mesh(name)->mesh, 3, CornerRule::kSharp);
  }
  for (const char* name : {"creature", "torus_open", "teapot", "mixed"}) {
    SCOPED_TRACE(name);
    expect_loop(make_fit(*load_bundled_mesh(name)->mesh, Fitting::kTriangulate), 1,
                CornerRule::kSmooth);
  }
}

TEST(SplitAndFlip, EqualsLoopOnRandomMeshes) {
  Random random(6);
  for (int i = 0; i < std::max(8, static_cast<int>(24 * effort())); ++i) {
    SCOPED_TRACE(i);
    const MeshPointer mesh = random_triangles(i, random);
    expect_loop(mesh, 2, i % 2 == 0 ? CornerRule::kSharp : CornerRule::kSmooth);
  }
}

TEST(SplitAndFlip, EqualsLoopWithCreases) {
  Random random(7);
  for (int i = 0; i < std::max(8, static_cast<int>(24 * effort())); ++i) {
    SCOPED_TRACE(i);
    const MeshPointer mesh = with_random_creases(*random_triangles(i, random), 0.3, 0.1, random);
    MeshAttributes attributes = mesh->attributes();
    attributes.creases.method = i % 2 == 0 ? CreasingMethod::kUniform : CreasingMethod::kChaikin;
    expect_loop(std::make_shared<const ControlMesh>(mesh->with_attributes(attributes)), 3,
                CornerRule::kSharp);
  }
}

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
