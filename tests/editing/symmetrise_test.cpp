// Symmetry is counted, not looked at: of the 48 signed permutations of the axes those that map a
// mesh to itself, vertices and faces.
#include "limn/editing/symmetrise.h"

#include <algorithm>
#include <array>
#include <ostream>
#include <set>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "face_lists.h"
#include "limn/editing/edge_edits.h"
#include "limn/mesh/bundled.h"
#include "support/attribute_shapes.h"

namespace limn::test {
namespace {

using testing::HasSubstr;

std::vector<glm::dmat3> cube_symmetries() {
  std::vector<glm::dmat3> all;
  std::array<int, 3> order{0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      glm::dmat3 matrix(0.0);
      for (int i = 0; i < 3; ++i) {
        matrix[i][order[static_cast<std::size_t>(i)]] = (signs >> i & 1) == 0 ? 1.0 : -1.0;
      }
      all.push_back(matrix);
    }
  } while (std::ranges::next_permutation(order).found);
  return all;
}

/// The number of the vertex at a place, to 1e-9; kNone where there is none.
std::uint32_t vertex_at(const ControlMesh& mesh, const glm::dvec3& place) {
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (glm::distance(mesh.positions()[v], place) < 1e-9) {
      return v;
    }
  }
  return kNone;
}

bool maps_to_itself(const ControlMesh& mesh, const glm::dmat3& matrix) {
  std::vector<std::uint32_t> image;
  for (const glm::dvec3& p : mesh.positions()) {
    image.push_back(vertex_at(mesh, matrix * p));
    if (image.back() == kNone) {
      return false;
    }
  }
  Faces mapped = faces_of(mesh);
  for (auto& face : mapped) {
    for (std::uint32_t& v : face) {
      v = image[v];
    }
    if (glm::determinant(matrix) < 0.0) {
      std::ranges::reverse(face);
    }
  }
  return sorted_faces(mapped) == sorted_faces(faces_of(mesh));
}

struct Group {
  int order = 0;
  int threefold_axes = 0;

  bool operator==(const Group&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Group& group) {
  return out << group.order << " symmetries, " << group.threefold_axes << " three-fold axes";
}

Group group_of(const ControlMesh& mesh) {
  Group group;
  for (const glm::dmat3& matrix : cube_symmetries()) {
    if (maps_to_itself(mesh, matrix)) {
      ++group.order;
      // A rotation by a third of a turn has trace 0; the axis has two of them.
      const double trace = matrix[0][0] + matrix[1][1] + matrix[2][2];
      group.threefold_axes += trace == 0.0 && glm::determinant(matrix) > 0.0 ? 1 : 0;
    }
  }
  group.threefold_axes /= 2;
  return group;
}

MeshPointer triangulated_cube() {
  return load_bundled_mesh("cube_triangulated")->mesh;
}

/// The group of the mesh, which its refinements all have too.
Group group_of_refinements(MeshPointer mesh) {
  const Group group = group_of(*mesh);
  for (int level = 1; level <= 3; ++level) {
    mesh = *upsample_by_split_and_flip(*mesh);
    EXPECT_EQ(group_of(*mesh), group) << "level " << level;
  }
  return group;
}

TEST(Symmetrise, TheTestCountsTheSymmetriesOfACube) {
  EXPECT_EQ(group_of(*cube()), (Group{48, 4}));
}

TEST(Symmetrise, TheTriangulatedCubeIsNotSymmetric) {
  EXPECT_EQ(group_of_refinements(triangulated_cube()), (Group{2, 0}));
}

TEST(Symmetrise, SplitGivesAllSymmetriesOfTheCube) {
  const auto split = symmetrise(*triangulated_cube(), SymmetriseBy::kSplit);
  ASSERT_TRUE(split) << split.error().message;
  EXPECT_EQ(split->pairs, 6u);
  EXPECT_EQ(split->changed, 6u);
  EXPECT_EQ(split->mesh->face_count(), 24u);
  EXPECT_EQ(group_of_refinements(split->mesh), (Group{48, 4}));
}

TEST(Symmetrise, FlipToAxisGivesOneThreefoldAxis) {
  const auto flipped = symmetrise(*triangulated_cube(), SymmetriseBy::kFlipToAxis);
  ASSERT_TRUE(flipped) << flipped.error().message;
  EXPECT_EQ(flipped->pairs, 6u);
  EXPECT_EQ(flipped->mesh->face_count(), 12u);
  EXPECT_EQ(group_of_refinements(flipped->mesh), (Group{12, 1}));
}

TEST(Symmetrise, FlipAlternatelyGivesTheSymmetriesOfATetrahedron) {
  const auto flipped = symmetrise(*triangulated_cube(), SymmetriseBy::kFlipAlternately);
  ASSERT_TRUE(flipped) << flipped.error().message;
  EXPECT_EQ(flipped->pairs, 6u);
  EXPECT_LE(flipped->changed, 3u);
  EXPECT_EQ(flipped->mesh->face_count(), 12u);
  EXPECT_EQ(group_of_refinements(flipped->mesh), (Group{24, 4}));
}

/// However the cube was cut: the way it comes in decides nothing but which tetrahedron.
TEST(Symmetrise, EveryCutOfACubeBecomesSymmetric) {
  const PolygonSoup quads = cube_soup();
  for (unsigned cut = 0; cut < 64; ++cut) {
    PolygonSoup soup;
    soup.positions = quads.positions;
    for (std::size_t f = 0; f < 6; ++f) {
      const auto face = quads.face(f);
      const std::size_t i = cut >> f & 1u;
      soup.add_face(std::array{face[i], face[i + 1], face[i + 2]});
      soup.add_face(std::array{face[i], face[i + 2], face[(i + 3) % 4]});
    }
    const MeshPointer mesh = control_mesh(soup);
    EXPECT_EQ(group_of(*symmetrise(*mesh, SymmetriseBy::kSplit)->mesh), (Group{48, 4}));
    EXPECT_EQ(group_of(*symmetrise(*mesh, SymmetriseBy::kFlipToAxis)->mesh), (Group{12, 1}));
    const auto alternately = symmetrise(*mesh, SymmetriseBy::kFlipAlternately);
    EXPECT_EQ(group_of(*alternately->mesh), (Group{24, 4}));
    EXPECT_LE(alternately->changed, 3u);
  }
}

/// A cube of 3 x 3 quads a side: which of the edges in a flat face are diagonals is found.
TEST(Symmetrise, FindsTheDiagonalsOfAFinerCube) {
  // Two levels of linear splitting by quads: positions on the cube, cut at random.
  Random random(30);
  PolygonSoup quads;
  std::vector<glm::dvec3> places;
  const auto at = [&](const glm::dvec3& p) {
    const auto found = std::ranges::find_if(
        places, [&](const glm::dvec3& q) { return glm::distance(p, q) < 1e-9; });
    if (found == places.end()) {
      places.push_back(p);
      return static_cast<std::uint32_t>(places.size() - 1);
    }
    return static_cast<std::uint32_t>(found - places.begin());
  };
  const PolygonSoup coarse = cube_soup();
  for (std::size_t f = 0; f < 6; ++f) {
    const auto face = coarse.face(f);
    const glm::dvec3 origin = coarse.positions[face[0]];
    const glm::dvec3 u = (coarse.positions[face[1]] - origin) / 3.0;
    const glm::dvec3 v = (coarse.positions[face[3]] - origin) / 3.0;
    for (int i = 0; i < 9; ++i) {
      const int row = i / 3;
      const glm::dvec3 p = origin + double(i - 3 * row) * u + double(row) * v;
      const std::array corners{at(p), at(p + u), at(p + u + v), at(p + v)};
      const std::size_t start = random() % 2;
      quads.add_face(std::array{corners[start], corners[start + 1], corners[start + 2]});
      quads.add_face(std::array{corners[start], corners[start + 2], corners[(start + 3) % 4]});
    }
  }
  quads.positions = places;
  const MeshPointer mesh = control_mesh(quads);
  const auto split = symmetrise(*mesh, SymmetriseBy::kSplit);
  ASSERT_TRUE(split) << split.error().message;
  EXPECT_EQ(split->pairs, 54u);
  EXPECT_EQ(group_of(*split->mesh), (Group{48, 4}));
  EXPECT_EQ(group_of(*symmetrise(*mesh, SymmetriseBy::kFlipToAxis)->mesh), (Group{12, 1}));
  EXPECT_EQ(group_of(*symmetrise(*mesh, SymmetriseBy::kFlipAlternately)->mesh), (Group{24, 4}));
}

TEST(Symmetrise, RefusesToDoubleADiagonal) {
  // A flat pillow of two squares back to back, one cut either way: both would take one diagonal.
  const MeshPointer pillow = control_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                                          {{0, 1, 2}, {0, 2, 3}, {1, 0, 3}, {1, 3, 2}});
  const auto refused = symmetrise(*pillow, SymmetriseBy::kFlipToAxis);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("doubled"));
  EXPECT_TRUE(symmetrise(*pillow, SymmetriseBy::kSplit));
}

/// Flat meshes with vertices of many valences: what comes of them is a manifold of the same kind,
/// with as many faces as pairs were split, or none more.
TEST(Symmetrise, KeepsManifolds) {
  Random random(31);
  for (int i = 0; i < 30; ++i) {
    PolygonSoup soup = triangulated(grid_soup(5, 4));
    for (glm::dvec3& p : soup.positions) {
      p.z = 0.0;
    }
    MeshPointer mesh = control_mesh(soup);
    for (int flips = 0; flips < i; ++flips) {
      const auto flipped =
          flip_edge(*mesh, static_cast<std::uint32_t>(random() % mesh->edge_count()));
      mesh = flipped ? *flipped : mesh;
    }
    for (const SymmetriseBy by :
         {SymmetriseBy::kSplit, SymmetriseBy::kFlipToAxis, SymmetriseBy::kFlipAlternately}) {
      const auto result = symmetrise(*mesh, by);
      if (!result) {
        EXPECT_EQ(by, SymmetriseBy::kFlipAlternately) << result.error().message;
        continue;
      }
      EXPECT_TRUE(is_manifold(faces_of(*result->mesh), result->mesh->vertex_count()));
      EXPECT_EQ(result->mesh->face_count(),
                mesh->face_count() + (by == SymmetriseBy::kSplit ? 2 * result->pairs : 0));
    }
  }
}

TEST(Symmetrise, RefusesQuads) {
  const auto refused = symmetrise(*cube(), SymmetriseBy::kSplit);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kFailed);
  EXPECT_THAT(refused.error().message, HasSubstr("Face 0 has 4 sides"));
}

TEST(Symmetrise, RefusesAMeshWithoutFlatPairs) {
  const auto refused = symmetrise(*load_bundled_mesh("icosahedron")->mesh, SymmetriseBy::kSplit);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("nothing to make symmetric"));
}

TEST(Symmetrise, RefusesToAlternateAroundAnOddVertex) {
  // Three quads around one vertex, with sides in loops of four: fine. A pentagonal prism's wall of
  // five quads: an odd loop.
  PolygonSoup soup;
  const PolygonSoup prism = prism_soup(5);
  soup.positions = prism.positions;
  for (glm::dvec3& p : soup.positions) {
    p.z = 2.0 * p.z;
  }
  for (std::size_t f = 0; f < prism.face_count(); ++f) {
    if (prism.face(f).size() == 4) {
      soup.add_face(prism.face(f));
    }
  }
  const MeshPointer mesh = control_mesh(triangulated(soup));
  const auto refused = symmetrise(*mesh, SymmetriseBy::kFlipAlternately);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("odd length"));
  EXPECT_TRUE(symmetrise(*mesh, SymmetriseBy::kFlipToAxis));
}

TEST(Symmetrise, TakesAPairAsFlatWithinTheAngleAsked) {
  // Two triangles folded by about 5.7 degrees along their diagonal.
  const MeshPointer mesh =
      control_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.0707}, {0, 1, 0}}, {{0, 1, 3}, {1, 2, 3}});
  EXPECT_FALSE(symmetrise(*mesh, SymmetriseBy::kSplit));
  EXPECT_TRUE(symmetrise(*mesh, SymmetriseBy::kSplit, 10.0));
}

TEST(Symmetrise, LeavesADiagonalOnASeam) {
  PolygonSoup soup;
  soup.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  soup.add_face(std::array{0u, 1u, 2u});
  soup.add_face(std::array{0u, 2u, 3u});
  const std::vector<glm::dvec2> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {5, 5}, {6, 6}};
  EXPECT_TRUE(symmetrise(*with_uvs(soup, points, {0, 1, 2, 0, 2, 3}), SymmetriseBy::kSplit));
  EXPECT_FALSE(symmetrise(*with_uvs(soup, points, {0, 1, 2, 4, 5, 3}), SymmetriseBy::kSplit));
}

}  // namespace
}  // namespace limn::test
