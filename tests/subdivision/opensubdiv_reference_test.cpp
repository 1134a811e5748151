#include "support/opensubdiv_reference.h"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "support/shapes.h"

// The wrapper asks OpenSubdiv what it says it asks: cases of which the answer is known otherwise.
namespace limn::test {
namespace {

ControlMesh with_texture(const ControlMesh& mesh, TextureCoordinates texture) {
  MeshAttributes attributes = mesh.attributes();
  attributes.texture = std::move(texture);
  return mesh.with_attributes(std::move(attributes));
}

/// The mesh seen along z, in one piece.
TextureCoordinates projected(const ControlMesh& mesh) {
  TextureCoordinates texture;
  for (const glm::dvec3& position : mesh.positions()) {
    texture.values.emplace_back(position.x, position.y);
  }
  texture.corner_values = mesh.topology().corner_vertices;
  return texture;
}

/// The same with every face cut loose.
TextureCoordinates scattered(const ControlMesh& mesh) {
  TextureCoordinates texture;
  for (const std::uint32_t v : mesh.topology().corner_vertices) {
    texture.corner_values.push_back(static_cast<std::uint32_t>(texture.values.size()));
    texture.values.emplace_back(mesh.positions()[v].x, mesh.positions()[v].y);
  }
  return texture;
}

glm::dvec2 middle_of(const std::vector<glm::dvec2>& points) {
  glm::dvec2 sum(0.0);
  for (const glm::dvec2& point : points) {
    sum += point;
  }
  return sum / static_cast<double>(points.size());
}

/// The corners of every child face are a corner, middles of edges, and the middle of its parent.
void expect_linear(const ControlMesh& mesh, TextureRule rule) {
  const UniformHierarchy hierarchy(mesh, 3, CornerRule::kSharp, rule);
  const auto uvs = hierarchy.uvs(mesh.texture().values);
  for (int level = 0; level < hierarchy.levels(); ++level) {
    const auto here = static_cast<std::size_t>(level);
    for (std::uint32_t f = 0; f < hierarchy.face_count(level); ++f) {
      std::vector<glm::dvec2> corners;
      for (const std::uint32_t value : hierarchy.face_uvs(level, f)) {
        corners.push_back(uvs[here][value]);
      }
      const std::size_t n = corners.size();
      const auto children = hierarchy.child_faces(level, f);
      ASSERT_EQ(children.size(), n);
      for (std::size_t i = 0; i < n; ++i) {
        std::vector<glm::dvec2> child;
        for (const std::uint32_t value : hierarchy.face_uvs(level + 1, children[i])) {
          child.push_back(uvs[here + 1][value]);
        }
        // A child of a quad keeps its corner's place, others start at the corner.
        const std::size_t at = n == 4 ? i : 0;
        const std::vector<glm::dvec2> expected{
            corners[i], 0.5 * (corners[i] + corners[(i + 1) % n]), middle_of(corners),
            0.5 * (corners[i] + corners[(i + n - 1) % n])};
        for (std::size_t k = 0; k < 4; ++k) {
          EXPECT_LE(glm::distance(child[(at + k) % 4], expected[k]), 1e-14);
        }
      }
    }
  }
}

}  // namespace

TEST(OpenSubdivReference, LinearTextureIsBilinearInEveryFace) {
  const MeshPointer mesh = mixed_prism();
  expect_linear(with_texture(*mesh, projected(*mesh)), TextureRule::kLinear);
  expect_linear(with_texture(*mesh, scattered(*mesh)), TextureRule::kLinear);
}

TEST(OpenSubdivReference, TextureWithoutSeamsIsSmoothLikeTheSurface) {
  const MeshPointer torus = control_mesh(torus_soup(5, 4));
  const ControlMesh mesh = with_texture(*torus, projected(*torus));
  const UniformHierarchy hierarchy(mesh, 2, CornerRule::kSharp, TextureRule::kSmoothInside);
  const auto positions = hierarchy.positions(mesh.positions());
  const auto uvs = hierarchy.uvs(mesh.texture().values);
  for (std::uint32_t f = 0; f < hierarchy.face_count(2); ++f) {
    const auto vertices = hierarchy.face_vertices(2, f);
    const auto values = hierarchy.face_uvs(2, f);
    for (std::size_t i = 0; i < 4; ++i) {
      const glm::dvec3& position = positions[2][vertices[i]];
      EXPECT_LE(glm::distance(uvs[2][values[i]], glm::dvec2(position.x, position.y)), 1e-14);
    }
  }
}

TEST(OpenSubdivReference, SmoothTextureIsLinearAlongBoundaries) {
  const MeshPointer grid_mesh = grid(3);
  const ControlMesh mesh = with_texture(*grid_mesh, projected(*grid_mesh));
  const UniformHierarchy hierarchy(mesh, 1, CornerRule::kSmooth, TextureRule::kSmoothInside);
  const auto uvs = hierarchy.uvs(mesh.texture().values);
  const auto children = hierarchy.child_faces(0, 0);
  const glm::dvec2 corner = uvs[1][hierarchy.face_uvs(1, children[0])[0]];
  EXPECT_EQ(corner, mesh.texture().values[mesh.texture().corner_values[0]]);
}

TEST(OpenSubdivReference, InfiniteCreasesHoldCornersOfACube) {
  const MeshPointer smooth = cube();
  MeshAttributes attributes;
  attributes.creases.edge_sharpness.assign(smooth->edge_count(), kInfiniteSharpness);
  const ControlMesh mesh = smooth->with_attributes(std::move(attributes));
  const UniformHierarchy hierarchy(mesh, 2, CornerRule::kSharp);
  const auto positions = hierarchy.positions(mesh.positions());
  const ReferenceLimits limits = hierarchy.limits(mesh.positions());
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    const std::uint32_t below = hierarchy.child_of_vertex(1, hierarchy.child_of_vertex(0, v));
    EXPECT_EQ(positions[2][below], mesh.positions()[v]);
    EXPECT_EQ(limits.positions[below], mesh.positions()[v]);
  }
}

}  // namespace limn::test
