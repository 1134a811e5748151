// Texture coordinates of refinements against OpenSubdiv's face-varying channels.
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "exactness_check.h"
#include "hierarchy_labels.h"
#include "support/attribute_shapes.h"
#include "support/shapes.h"

namespace limn {
namespace {

using test::MeshPointer;

constexpr int kLevels = 3;
constexpr double kTolerance = 1e-6;

/// Which points of the texture each vertex of each level has.
using PointsOfVertices = std::vector<std::map<std::uint32_t, std::vector<glm::dvec2>>>;

PointsOfVertices points_of_vertices(const test::UniformHierarchy& hierarchy,
                                    const ControlMesh& mesh) {
  const auto uvs = hierarchy.uvs(mesh.texture().values);
  PointsOfVertices points(kLevels + 1);
  for (int level = 0; level <= kLevels; ++level) {
    const auto at = static_cast<std::size_t>(level);
    for (std::uint32_t f = 0; f < hierarchy.face_count(level); ++f) {
      const auto vertices = hierarchy.face_vertices(level, f);
      const auto corners = hierarchy.face_uvs(level, f);
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        points[at][vertices[i]].push_back(uvs[at][corners[i]]);
      }
    }
  }
  return points;
}

RefinedMesh refined(const ControlMesh& mesh, const VertexLabels& labels,
                    const SubdivisionSettings& settings, const FineLabels* fine = nullptr) {
  IgnoreProgress progress;
  RefineLimits limits;
  limits.fine = fine;
  return refine(mesh, labels, settings, limits, progress).value();
}

/// Every corner of every face has one of the points that uniform subdivision gives its vertex.
void expect_points_of_vertices(const ControlMesh& mesh, const SubdivisionSettings& settings,
                               const test::UniformReference& reference,
                               const PointsOfVertices& points, const test::FinePainting& painting) {
  const auto& [painted, given] = painting;
  const VertexLabels& labels = painted.legal.labels;
  const FineLabels* fine = painted.fine.get();
  const RefinedMesh result = refined(mesh, labels, settings, fine);
  ASSERT_EQ(result.quad_uvs.size(), result.quads.size());
  ASSERT_EQ(result.polygon_uvs.size(), result.polygon_vertices.size());
  EXPECT_EQ(test::first_breach(mesh, labels, settings, kAllLevels, fine), "");
  const auto references =
      reference.references_fine(labels, fine, given.labels, settings, kAllLevels);
  ASSERT_EQ(references.size(), result.vertex_count());
  std::size_t off = 0;
  const auto check = [&](std::uint32_t vertex, std::uint32_t uv) {
    const test::ReferenceMesh::Vertex& at = references[vertex];
    const auto& candidates = points[static_cast<std::size_t>(at.level)].at(at.index);
    const bool is_found = std::ranges::any_of(candidates, [&](const glm::dvec2& point) {
      return glm::distance(point, glm::dvec2(result.uvs[uv])) < kTolerance;
    });
    off += is_found ? 0 : 1;
  };
  for (std::size_t f = 0; f < result.quads.size(); ++f) {
    for (std::size_t i = 0; i < 4; ++i) {
      check(result.quads[f][i], result.quad_uvs[f][i]);
    }
  }
  for (std::size_t i = 0; i < result.polygon_vertices.size(); ++i) {
    check(result.polygon_vertices[i], result.polygon_uvs[i]);
  }
  EXPECT_EQ(off, 0u);
}

/// After uniform subdivision every face has its very own points, corner by corner.
void expect_points_of_faces(const ControlMesh& mesh, const SubdivisionSettings& settings,
                            const test::UniformReference& reference,
                            const test::UniformHierarchy& hierarchy) {
  constexpr int kDepth = 2;
  const VertexLabels labels(mesh.vertex_count(), kDepth);
  const RefinedMesh result = refined(mesh, labels, settings);
  const auto references = reference.references(labels, settings, kAllLevels);
  ASSERT_EQ(references.size(), result.vertex_count());
  std::map<std::vector<std::uint32_t>, std::uint32_t> faces;
  for (std::uint32_t f = 0; f < hierarchy.face_count(kDepth); ++f) {
    auto vertices = hierarchy.face_vertices(kDepth, f);
    std::ranges::sort(vertices);
    faces[vertices] = f;
  }
  const auto uvs = hierarchy.uvs(mesh.texture().values)[kDepth];
  std::size_t off = 0;
  for (std::size_t q = 0; q < result.quads.size(); ++q) {
    std::vector<std::uint32_t> key;
    for (const std::uint32_t v : result.quads[q]) {
      key.push_back(references[v].index);
    }
    std::vector<std::uint32_t> sorted = key;
    std::ranges::sort(sorted);
    const std::uint32_t face = faces.at(sorted);
    const auto vertices = hierarchy.face_vertices(kDepth, face);
    const auto corners = hierarchy.face_uvs(kDepth, face);
    for (std::size_t i = 0; i < 4; ++i) {
      const auto at =
          static_cast<std::size_t>(std::ranges::find(vertices, key[i]) - vertices.begin());
      off += glm::distance(uvs[corners[at]], glm::dvec2(result.uvs[result.quad_uvs[q][i]])) <
                     kTolerance
                 ? 0
                 : 1;
    }
  }
  EXPECT_EQ(off, 0u);
}

void expect_texture(const std::string& name, const ControlMesh& mesh, test::Random& random) {
  const test::UniformReference reference(mesh, kLevels, CornerRule::kSharp);
  for (const TextureRule rule : {TextureRule::kLinear, TextureRule::kSmoothInside}) {
    SubdivisionSettings settings;
    settings.texture = rule;
    settings.non_quads = NonQuadRule::kWherePainted;
    SCOPED_TRACE(fmt::format("{}, {}", name, rule == TextureRule::kLinear ? "linear" : "smooth"));
    const test::UniformHierarchy hierarchy(mesh, kLevels, CornerRule::kSharp, rule);
    expect_points_of_faces(mesh, settings, reference, hierarchy);
    const PointsOfVertices points = points_of_vertices(hierarchy, mesh);
    for (int painting = 0; painting < 4; ++painting) {
      const auto depths =
          test::random_depths(mesh, painting % 2 == 0 ? 0.15 : 0.4, kLevels, random);
      expect_points_of_vertices(mesh, settings, reference, points,
                                test::random_fine_painting(hierarchy, mesh, depths,
                                                           painting < 2 ? 0 : 6, settings, random));
    }
  }
}

TEST(Texture, IsOpenSubdivsOnTexturedShapes) {
  test::Random random(61);
  for (const auto& [name, mesh] : test::textured_shapes()) {
    expect_texture(name, *mesh, random);
  }
}

TEST(Texture, IsOpenSubdivsOnRandomChartsAndCreases) {
  test::Random random(62);
  for (std::uint32_t charts : {1u, 3u, 12u}) {
    const MeshPointer torus =
        test::control_mesh(test::jittered(test::torus_soup(8, 6), 0.1, random));
    const MeshPointer mixed = test::control_mesh(
        test::jittered(test::with_mixed_faces(test::grid_soup(6, 5), random), 0.1, random));
    expect_texture("torus", *test::with_random_charts(*torus, charts, random), random);
    expect_texture("mixed", *test::with_random_charts(*mixed, charts, random), random);
    const MeshPointer creased = test::with_random_creases(*torus, 0.2, 0.05, random);
    expect_texture("creased", *test::with_random_charts(*creased, charts, random), random);
  }
}

TEST(Texture, IsAbsentWhereTheControlMeshHasNone) {
  const RefinedMesh result = refined(*test::cube(), VertexLabels(8, 2), {});
  EXPECT_TRUE(result.uvs.empty());
  EXPECT_TRUE(result.quad_uvs.empty());
  EXPECT_TRUE(result.polygon_uvs.empty());
}

}  // namespace
}  // namespace limn
