// What stays sharp in a refined mesh. Positions beside creases are exactness_test's.
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "exactness_check.h"
#include "support/attribute_shapes.h"
#include "support/shapes.h"

namespace limn {
namespace {

RefinedMesh refined(const ControlMesh& mesh, const VertexLabels& labels) {
  IgnoreProgress progress;
  return refine(mesh, labels, {}, {}, progress).value();
}

TEST(RefinedCreases, AreOpenSubdivsAtEveryDepth) {
  test::Random random(71);
  std::vector<test::NamedShape> shapes = test::creased_shapes();
  const auto torus = test::control_mesh(test::jittered(test::torus_soup(7, 5), 0.1, random));
  shapes.push_back({"random creases", test::with_random_creases(*torus, 0.3, 0.05, random)});
  for (const auto& [name, mesh] : shapes) {
    constexpr int kLevels = 3;
    const test::UniformReference reference(*mesh, kLevels, CornerRule::kSharp);
    const test::UniformHierarchy& hierarchy = reference.hierarchy();
    for (std::uint8_t depth = 1; depth <= kLevels; ++depth) {
      SCOPED_TRACE(name + ", depth " + std::to_string(depth));
      const VertexLabels labels(mesh->vertex_count(), depth);
      const RefinedMesh result = refined(*mesh, labels);
      const auto references = reference.references(labels, {}, kAllLevels);
      ASSERT_EQ(references.size(), result.vertex_count());
      std::map<std::pair<std::uint32_t, std::uint32_t>, float> found;
      for (const RefinedCrease& crease : result.creases) {
        const std::uint32_t a = references[crease.vertices[0]].index;
        const std::uint32_t b = references[crease.vertices[1]].index;
        EXPECT_TRUE(found.emplace(std::minmax(a, b), crease.sharpness).second);
      }
      std::map<std::pair<std::uint32_t, std::uint32_t>, float> expected;
      std::map<std::uint32_t, int> faces_of_edge;
      for (std::uint32_t f = 0; f < hierarchy.face_count(depth); ++f) {
        for (const std::uint32_t e : hierarchy.face_edges(depth, f)) {
          ++faces_of_edge[e];
        }
      }
      for (const auto& [edge, faces] : faces_of_edge) {
        if (faces == 2 && hierarchy.edge_sharpness(depth, edge) > 0.0f) {
          const auto [a, b] = hierarchy.edge_vertices(depth, edge);
          expected[std::minmax(a, b)] = hierarchy.edge_sharpness(depth, edge);
        }
      }
      EXPECT_EQ(found, expected);
    }
  }
}

TEST(RefinedCreases, FollowAPaintedEdgeFromEndToEnd) {
  // A cube with one crease that never wears off and one face beside it painted.
  test::Random random(72);
  const auto cube = test::cube();
  Creases creases;
  creases.edge_sharpness.assign(cube->edge_count(), 0.0f);
  creases.edge_sharpness[0] = kInfiniteSharpness;
  creases.vertex_sharpness.assign(cube->vertex_count(), 0.0f);
  creases.vertex_sharpness[7] = 2.5f;
  MeshAttributes attributes;
  attributes.creases = creases;
  const ControlMesh mesh = cube->with_attributes(attributes);
  const FlatTopology& topology = mesh.topology();
  std::vector<std::uint8_t> depths(6, 0);
  depths[topology.corner_faces[topology.edge_corners[0][0]]] = 4;
  IgnoreProgress progress;
  const VertexLabels labels = legal_labels(mesh, depths, {}, progress).value().labels;
  const RefinedMesh result = refined(mesh, labels);
  ASSERT_EQ(result.creases.size(), 16u);
  std::uint32_t at = topology.edge_vertices[0][0];
  for (const RefinedCrease& crease : result.creases) {
    EXPECT_EQ(crease.vertices[0], at);
    EXPECT_EQ(crease.sharpness, kInfiniteSharpness);
    at = crease.vertices[1];
  }
  EXPECT_EQ(at, topology.edge_vertices[0][1]);
  const float left = 2.5f - static_cast<float>(result.vertex_levels[7]);
  if (left > 0.0f) {
    ASSERT_EQ(result.corners.size(), 1u);
    EXPECT_EQ(result.corners[0].vertex, 7u);
    EXPECT_EQ(result.corners[0].sharpness, left);
  } else {
    EXPECT_TRUE(result.corners.empty());
  }
}

}  // namespace
}  // namespace limn
