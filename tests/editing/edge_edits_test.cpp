#include "limn/editing/edge_edits.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "face_lists.h"
#include "limn/mesh/bundled.h"
#include "limn/mesh/statistics.h"
#include "support/attribute_shapes.h"
#include "support/effort.h"

namespace limn::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Two triangles that share edge 0-1, with 2 on its left and 3 on its right.
PolygonSoup diamond_soup() {
  PolygonSoup soup;
  soup.positions = {{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1, 0}};
  soup.add_face(std::array{0u, 1u, 2u});
  soup.add_face(std::array{0u, 3u, 1u});
  return soup;
}

std::uint32_t edge_between(const ControlMesh& mesh, std::uint32_t a, std::uint32_t b) {
  const auto& edges = mesh.topology().edge_vertices;
  const auto at = std::ranges::find_if(edges, [&](const auto& ends) {
    return std::set{ends[0], ends[1]} == std::set{a, b};
  });
  EXPECT_NE(at, edges.end()) << "no edge between " << a << " and " << b;
  return static_cast<std::uint32_t>(at - edges.begin());
}

float sharpness_between(const ControlMesh& mesh, std::uint32_t a, std::uint32_t b) {
  const auto& sharpness = mesh.creases().edge_sharpness;
  return sharpness.empty() ? 0.0f : sharpness[edge_between(mesh, a, b)];
}

std::optional<std::uint32_t> third_vertex(const Faces& faces, std::uint32_t a, std::uint32_t b) {
  for (const auto& face : faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (face[i] == a && face[(i + 1) % 3] == b) {
        return face[(i + 2) % 3];
      }
    }
  }
  return std::nullopt;
}

/// The faces with one edge split or flipped, whatever comes of it.
struct Expected {
  Faces faces;
  std::size_t vertices = 0;
};

void remove_face(Faces& faces, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const Faces one = sorted_faces({{a, b, c}});
  std::erase_if(faces, [&](const auto& face) { return sorted_faces({face}) == one; });
}

Expected expected_split(const ControlMesh& mesh, std::uint32_t a, std::uint32_t b) {
  const auto m = static_cast<std::uint32_t>(mesh.vertex_count());
  Faces faces = faces_of(mesh);
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
    if (const auto apex = third_vertex(faces, from, to)) {
      remove_face(faces, from, to, *apex);
      faces.push_back({from, m, *apex});
      faces.push_back({m, to, *apex});
    }
  }
  return {faces, mesh.vertex_count() + 1};
}

/// Nothing for a boundary edge.
std::optional<Expected> expected_flip(const ControlMesh& mesh, std::uint32_t a, std::uint32_t b) {
  Faces faces = faces_of(mesh);
  const auto x = third_vertex(faces, a, b);
  const auto y = third_vertex(faces, b, a);
  if (!x || !y) {
    return std::nullopt;
  }
  remove_face(faces, a, b, *x);
  remove_face(faces, b, a, *y);
  faces.push_back({a, *y, *x});
  faces.push_back({b, *x, *y});
  return Expected{faces, mesh.vertex_count()};
}

TEST(SplitEdge, PutsAVertexInTheMiddleAndKeepsTheRest) {
  const MeshPointer mesh = control_mesh(diamond_soup());
  const auto split = split_edge(*mesh, edge_between(*mesh, 0, 1));
  ASSERT_TRUE(split) << split.error().message;
  ASSERT_EQ((*split)->vertex_count(), 5u);
  EXPECT_EQ((*split)->positions()[4], glm::dvec3(1, 0, 0));
  for (std::size_t v = 0; v < 4; ++v) {
    EXPECT_EQ((*split)->positions()[v], mesh->positions()[v]);
  }
  // The halves with vertex 0 keep their numbers, first corners included.
  EXPECT_THAT(faces_of(**split), ElementsAre(ElementsAre(0, 4, 2), ElementsAre(0, 3, 4),
                                             ElementsAre(4, 1, 2), ElementsAre(4, 3, 1)));
}

TEST(SplitEdge, TakesABoundaryEdge) {
  const MeshPointer mesh = control_mesh(diamond_soup());
  const auto split = split_edge(*mesh, edge_between(*mesh, 1, 2));
  ASSERT_TRUE(split) << split.error().message;
  EXPECT_EQ((*split)->positions()[4], glm::dvec3(1.5, 0.5, 0));
  EXPECT_EQ(sorted_faces(faces_of(**split)), sorted_faces({{0, 1, 4}, {0, 4, 2}, {0, 3, 1}}));
}

TEST(SplitEdge, KeepsSharpnessOnBothHalves) {
  const MeshPointer mesh = with_tags(diamond_soup(), {{{0, 1}, 2.5f}, {{1, 2}, 1.0f}}, {{3, 4.0f}},
                                     CreasingMethod::kChaikin);
  const auto split = split_edge(*mesh, edge_between(*mesh, 0, 1));
  ASSERT_TRUE(split) << split.error().message;
  EXPECT_EQ(sharpness_between(**split, 0, 4), 2.5f);
  EXPECT_EQ(sharpness_between(**split, 4, 1), 2.5f);
  EXPECT_EQ(sharpness_between(**split, 4, 2), 0.0f);
  EXPECT_EQ(sharpness_between(**split, 1, 2), 1.0f);
  EXPECT_THAT((*split)->creases().vertex_sharpness, ElementsAre(0, 0, 0, 4, 0));
  EXPECT_EQ((*split)->creases().method, CreasingMethod::kChaikin);
}

TEST(SplitEdge, HalvesTextureOnBothSidesOfASeam) {
  const MeshPointer mesh = with_uvs(
      diamond_soup(), {{0, 0}, {1, 0}, {0.5, 1}, {0, 8}, {1, 8}, {0.5, 9}}, {0, 1, 2, 3, 5, 4});
  const auto split = split_edge(*mesh, edge_between(*mesh, 0, 1));
  ASSERT_TRUE(split) << split.error().message;
  const TextureCoordinates& texture = (*split)->texture();
  const auto at = [&](std::size_t face, std::size_t side) {
    return texture.values[texture.corner_values[3 * face + side]];
  };
  EXPECT_EQ(at(0, 1), glm::dvec2(0.5, 0));
  EXPECT_EQ(at(2, 0), glm::dvec2(0.5, 0));
  EXPECT_EQ(at(1, 2), glm::dvec2(0.5, 8));
  EXPECT_EQ(at(3, 0), glm::dvec2(0.5, 8));
  EXPECT_EQ(texture.values.size(), 8u);
}

TEST(SplitEdge, RefusesTrianglesBackToBack) {
  const MeshPointer mesh = control_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}});
  const auto split = split_edge(*mesh, 0);
  ASSERT_FALSE(split);
  EXPECT_EQ(split.error().kind, ErrorKind::kFailed);
  EXPECT_THAT(split.error().message, HasSubstr("back to back"));
}

TEST(SplitEdge, RefusesAQuad) {
  const auto split = split_edge(*cube(), 3);
  ASSERT_FALSE(split);
  EXPECT_THAT(split.error().message, HasSubstr("a face at it is no triangle"));
}

TEST(SplitEdge, LeavesOtherFacesThatAreNoTriangles) {
  // A quad beside the diamond.
  PolygonSoup soup = diamond_soup();
  soup.positions.emplace_back(3, 1, 0);
  soup.positions.emplace_back(3, 0, 0);
  soup.add_face(std::array{1u, 5u, 4u, 2u});
  const MeshPointer mesh = control_mesh(soup);
  const auto split = split_edge(*mesh, edge_between(*mesh, 0, 1));
  ASSERT_TRUE(split) << split.error().message;
  EXPECT_THAT(faces_of(**split)[2], ElementsAre(1, 5, 4, 2));
}

TEST(FlipEdge, JoinsTheOtherTwoVertices) {
  const MeshPointer mesh = control_mesh(diamond_soup());
  const auto flipped = flip_edge(*mesh, edge_between(*mesh, 0, 1));
  ASSERT_TRUE(flipped) << flipped.error().message;
  // Face 0 keeps vertex 0, where the edge's first corner was.
  EXPECT_THAT(sorted_faces({faces_of(**flipped)[0]}), ElementsAre(ElementsAre(0, 3, 2)));
  EXPECT_THAT(sorted_faces({faces_of(**flipped)[1]}), ElementsAre(ElementsAre(1, 2, 3)));
  const auto back = flip_edge(**flipped, edge_between(**flipped, 2, 3));
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(sorted_faces(faces_of(**back)), sorted_faces(faces_of(*mesh)));
}

TEST(FlipEdge, LosesItsSharpnessAndNoOther) {
  const MeshPointer mesh = with_tags(diamond_soup(), {{{0, 1}, 2.5f}, {{1, 2}, 1.0f}});
  const auto flipped = flip_edge(*mesh, edge_between(*mesh, 0, 1));
  ASSERT_TRUE(flipped) << flipped.error().message;
  EXPECT_EQ(sharpness_between(**flipped, 2, 3), 0.0f);
  EXPECT_EQ(sharpness_between(**flipped, 1, 2), 1.0f);
}

TEST(FlipEdge, CarriesTexture) {
  const MeshPointer mesh =
      with_uvs(diamond_soup(), {{0, 0}, {1, 0}, {0.5, 1}, {0.5, -1}}, {0, 1, 2, 0, 3, 1});
  const auto flipped = flip_edge(*mesh, edge_between(*mesh, 0, 1));
  ASSERT_TRUE(flipped) << flipped.error().message;
  // Every vertex has the one point it had.
  const TextureCoordinates& texture = (*flipped)->texture();
  const auto& vertices = (*flipped)->topology().corner_vertices;
  for (std::size_t c = 0; c < 6; ++c) {
    EXPECT_EQ(texture.values[texture.corner_values[c]], mesh->texture().values[vertices[c]]);
  }
}

TEST(FlipEdge, RefusesABoundaryEdge) {
  const MeshPointer mesh = control_mesh(diamond_soup());
  const auto flipped = flip_edge(*mesh, edge_between(*mesh, 1, 2));
  ASSERT_FALSE(flipped);
  EXPECT_EQ(flipped.error().kind, ErrorKind::kFailed);
  EXPECT_THAT(flipped.error().message, HasSubstr("between vertices 1 and 2"));
  EXPECT_THAT(flipped.error().message, HasSubstr("boundary"));
}

TEST(FlipEdge, RefusesToDoubleAnEdge) {
  const MeshPointer tetrahedron = control_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                               {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  for (std::uint32_t e = 0; e < 6; ++e) {
    const auto flipped = flip_edge(*tetrahedron, e);
    ASSERT_FALSE(flipped);
    EXPECT_THAT(flipped.error().message, HasSubstr("doubled"));
  }
}

TEST(FlipEdge, RefusesTrianglesBackToBack) {
  const MeshPointer mesh = control_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}});
  const auto flipped = flip_edge(*mesh, 0);
  ASSERT_FALSE(flipped);
  EXPECT_THAT(flipped.error().message, HasSubstr("back to back"));
}

TEST(FlipEdge, RefusesAQuadAndASeam) {
  const auto quad = flip_edge(*cube(), 3);
  ASSERT_FALSE(quad);
  EXPECT_THAT(quad.error().message, HasSubstr("no triangle"));
  const MeshPointer mesh = with_uvs(
      diamond_soup(), {{0, 0}, {1, 0}, {0.5, 1}, {0, 8}, {1, 8}, {0.5, 9}}, {0, 1, 2, 3, 5, 4});
  const auto seam = flip_edge(*mesh, edge_between(*mesh, 0, 1));
  ASSERT_FALSE(seam);
  EXPECT_THAT(seam.error().message, HasSubstr("seam"));
}

/// Splits and flips at random. What is accepted gives just the faces that the edit makes, a
/// manifold of the same Euler characteristic; what is refused would not have given one.
TEST(EdgeEdits, AcceptJustWhatGivesAManifold) {
  Random random(20);
  int flips = 0;
  int refusals = 0;
  for (int i = 0; i < std::max(8, static_cast<int>(24 * effort())); ++i) {
    MeshPointer mesh = i % 8 == 7 ? control_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                                 {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
                                  : random_triangles(i, random);
    const long euler = mesh_statistics(*mesh).euler_characteristic;
    for (int step = 0; step < 60; ++step) {
      const std::uint32_t edge = std::uniform_int_distribution<std::uint32_t>(
          0, static_cast<std::uint32_t>(mesh->edge_count() - 1))(random);
      const auto [a, b] = mesh->topology().edge_vertices[edge];
      const bool is_split = random() % 8 == 0;
      const std::optional<Expected> expected =
          is_split ? expected_split(*mesh, a, b) : expected_flip(*mesh, a, b);
      const auto edited = is_split ? split_edge(*mesh, edge) : flip_edge(*mesh, edge);
      const bool is_possible = expected && is_manifold(expected->faces, expected->vertices);
      ASSERT_EQ(edited.has_value(), is_possible) << "mesh " << i << ", step " << step;
      if (!edited) {
        ++refusals;
        continue;
      }
      flips += is_split ? 0 : 1;
      ASSERT_EQ(sorted_faces(faces_of(**edited)), sorted_faces(expected->faces));
      ASSERT_EQ(mesh_statistics(**edited).euler_characteristic, euler);
      mesh = *edited;
    }
  }
  EXPECT_GT(flips, 100);
  EXPECT_GT(refusals, 40);
}

/// Creases and texture stay with what they belong to through any sequence of edits.
TEST(EdgeEdits, KeepWhatTheyDoNotTouch) {
  Random random(21);
  for (int i = 0; i < 6; ++i) {
    MeshPointer mesh = random_triangles(i, random);
    mesh = with_random_creases(*mesh, 0.4, 0.3, random);
    for (int step = 0; step < 30; ++step) {
      const std::uint32_t edge = std::uniform_int_distribution<std::uint32_t>(
          0, static_cast<std::uint32_t>(mesh->edge_count() - 1))(random);
      const bool is_split = step % 3 == 0;
      const auto edited = is_split ? split_edge(*mesh, edge) : flip_edge(*mesh, edge);
      if (!edited) {
        continue;
      }
      for (std::uint32_t e = 0; e < mesh->edge_count(); ++e) {
        if (e != edge) {
          const auto [a, b] = mesh->topology().edge_vertices[e];
          ASSERT_EQ(sharpness_between(**edited, a, b), sharpness_between(*mesh, a, b));
        }
      }
      for (std::uint32_t v = 0; v < mesh->vertex_count(); ++v) {
        ASSERT_EQ((*edited)->positions()[v], mesh->positions()[v]);
        if (!mesh->creases().vertex_sharpness.empty()) {
          ASSERT_EQ((*edited)->creases().vertex_sharpness[v], mesh->creases().vertex_sharpness[v]);
        }
      }
      mesh = *edited;
    }
  }
}

}  // namespace
}  // namespace limn::test
