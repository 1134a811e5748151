#include "limn/document/painting_transfer.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/document/commands.h"
#include "limn/document/document.h"
#include "support/attribute_shapes.h"
#include "support/shapes.h"

namespace limn {
namespace {

using test::MeshPointer;
using testing::ElementsAre;
using testing::IsEmpty;

enum class Rounding { kNone, kFloat, kSixDecimals };

double rounded(double value, Rounding rounding) {
  switch (rounding) {
    case Rounding::kFloat:
      return static_cast<double>(static_cast<float>(value));
    case Rounding::kSixDecimals:
      return std::round(value * 1e6) / 1e6;
    default:
      return value;
  }
}

/// What another program made of a mesh, and which face each of its faces was.
struct Shuffled {
  MeshPointer mesh;
  std::vector<std::uint32_t> faces;
  std::vector<std::uint32_t> vertices;  ///< The new number of each old one.
};

Shuffled shuffled(const ControlMesh& mesh, Rounding rounding, test::Random& random) {
  Shuffled result;
  result.vertices.resize(mesh.vertex_count());
  std::iota(result.vertices.begin(), result.vertices.end(), 0U);
  std::ranges::shuffle(result.vertices, random);
  result.faces.resize(mesh.face_count());
  std::iota(result.faces.begin(), result.faces.end(), 0U);
  std::ranges::shuffle(result.faces, random);
  PolygonSoup soup;
  soup.positions.resize(mesh.vertex_count());
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    for (int axis = 0; axis < 3; ++axis) {
      soup.positions[result.vertices[v]][axis] = rounded(mesh.positions()[v][axis], rounding);
    }
  }
  for (const std::uint32_t f : result.faces) {
    std::vector<std::uint32_t> corners(mesh.face(f).begin(), mesh.face(f).end());
    for (std::uint32_t& corner : corners) {
      corner = result.vertices[corner];
    }
    const auto first = static_cast<long>(random() % corners.size());
    std::rotate(corners.begin(), corners.begin() + first, corners.end());
    soup.add_face(corners);
  }
  result.mesh = test::control_mesh(soup);
  return result;
}

std::vector<MeshPointer> meshes(test::Random& random) {
  return {test::cube(),
          test::mixed_prism(),
          test::grid(7),
          test::control_mesh(test::torus_soup(9, 6)),
          test::control_mesh(test::trapezohedron_soup(11)),
          test::control_mesh(
              test::with_mixed_faces(test::jittered(test::grid_soup(12, 9), 0.2, random), random)),
          test::control_mesh(
              test::jittered(test::random_quads(test::torus_soup(6, 5), random), 1e-3, random))};
}

TEST(PaintingTransfer, EveryDepthFindsItsFaceInAnyOrder) {
  test::Random random(2718);
  for (int round = 0; round < 4; ++round) {
    for (const MeshPointer& mesh : meshes(random)) {
      const auto depths = test::random_depths(*mesh, 0.5, 5, random);
      for (const Rounding rounding : {Rounding::kNone, Rounding::kFloat, Rounding::kSixDecimals}) {
        const Shuffled other = shuffled(*mesh, rounding, random);
        const PaintingTransfer transfer = transfer_painting(*mesh, depths, other.mesh);
        EXPECT_EQ(transfer.matching, FaceMatching::kVertices);
        EXPECT_THAT(transfer.new_faces, IsEmpty());
        EXPECT_THAT(transfer.lost_faces, IsEmpty());
        ASSERT_EQ(transfer.depths.size(), mesh->face_count());
        for (std::size_t f = 0; f < mesh->face_count(); ++f) {
          ASSERT_EQ(transfer.depths[f], depths[other.faces[f]]) << f;
        }
      }
    }
  }
}

TEST(PaintingTransfer, CreasesFindTheirEdgesAndVertices) {
  test::Random random(31);
  for (const MeshPointer& smooth : meshes(random)) {
    const MeshPointer mesh = test::with_random_creases(*smooth, 0.3, 0.3, random);
    const Shuffled other = shuffled(*mesh, Rounding::kFloat, random);
    ASSERT_EQ(other.mesh->creases(), Creases{});
    const std::vector<std::uint8_t> depths(mesh->face_count());
    const PaintingTransfer transfer = transfer_painting(*mesh, depths, other.mesh);
    EXPECT_EQ(transfer.lost_creases, 0U);
    const auto& before = mesh->creases();
    const auto& after = transfer.mesh->creases();
    std::size_t sharp = 0;
    for (std::size_t v = 0; v < before.vertex_sharpness.size(); ++v) {
      ASSERT_EQ(after.vertex_sharpness.at(other.vertices[v]), before.vertex_sharpness[v]);
      sharp += before.vertex_sharpness[v] > 0.0F ? 1 : 0;
    }
    for (std::size_t e = 0; e < before.edge_sharpness.size(); ++e) {
      std::array<std::uint32_t, 2> ends = mesh->topology().edge_vertices[e];
      ends = {other.vertices[ends[0]], other.vertices[ends[1]]};
      const auto& edges = transfer.mesh->topology().edge_vertices;
      const auto at = std::ranges::find_if(edges, [&](const auto& edge) {
        return edge == ends || (edge[0] == ends[1] && edge[1] == ends[0]);
      });
      ASSERT_NE(at, edges.end());
      ASSERT_EQ(after.edge_sharpness.at(static_cast<std::size_t>(at - edges.begin())),
                before.edge_sharpness[e]);
      sharp += before.edge_sharpness[e] > 0.0F ? 1 : 0;
    }
    EXPECT_EQ(transfer.kept_creases, sharp);
  }
}

TEST(PaintingTransfer, WhatTheFileItselfCreasesStays) {
  const MeshPointer painted = test::with_tags(test::cube_soup(), {{{0, 1}, 3.0F}}, {{7, 2.0F}});
  const MeshPointer file = test::with_tags(test::cube_soup(), {{{0, 1}, 1.0F}});
  const PaintingTransfer transfer = transfer_painting(*painted, std::vector<std::uint8_t>(6), file);
  EXPECT_EQ(transfer.mesh->creases().edge_sharpness, file->creases().edge_sharpness);
  EXPECT_EQ(transfer.mesh->creases().vertex_sharpness, painted->creases().vertex_sharpness);
}

TEST(PaintingTransfer, FacesOfOneSetOfVerticesAreToldApartByTheirTurn) {
  // A pillow: two squares back to back.
  const std::vector<glm::dvec3> corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const MeshPointer pillow = test::control_mesh(corners, {{0, 1, 2, 3}, {3, 2, 1, 0}});
  const MeshPointer other = test::control_mesh(corners, {{1, 0, 3, 2}, {2, 3, 0, 1}});
  const PaintingTransfer transfer =
      transfer_painting(*pillow, std::vector<std::uint8_t>{1, 4}, other);
  EXPECT_EQ(transfer.depths[0], 4);
  EXPECT_EQ(transfer.depths[1], 1);
}

TEST(PaintingTransfer, MovedVerticesKeepThePaintingByTheFacesOrder) {
  test::Random random(5);
  const PolygonSoup soup = test::grid_soup(6, 4);
  const MeshPointer mesh = test::control_mesh(soup);
  const MeshPointer sculpted = test::control_mesh(test::jittered(soup, 0.2, random));
  const auto depths = test::random_depths(*mesh, 0.5, 3, random);
  const PaintingTransfer transfer = transfer_painting(*mesh, depths, sculpted);
  EXPECT_EQ(transfer.matching, FaceMatching::kOrder);
  EXPECT_TRUE(std::ranges::equal(transfer.depths.values(), depths));
  EXPECT_EQ(topology_hash(*mesh), topology_hash(*sculpted));
}

TEST(PaintingTransfer, WhatIsMovedAndReorderedIsReported) {
  // Another program took one face of the cube apart and put the rest in another order.
  const PolygonSoup cube = test::cube_soup();
  PolygonSoup other;
  other.positions = cube.positions;
  for (const std::size_t f : {5U, 4U, 2U, 1U, 0U}) {
    other.add_face(cube.face(f));
  }
  const auto opened = cube.face(3);
  other.add_face(std::vector<std::uint32_t>{opened[0], opened[1], opened[2]});
  other.add_face(std::vector<std::uint32_t>{opened[0], opened[2], opened[3]});
  const PaintingTransfer transfer = transfer_painting(
      *test::cube(), std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6}, test::control_mesh(other));
  EXPECT_THAT(transfer.depths.values(), ElementsAre(6, 5, 3, 2, 1, 0, 0));
  EXPECT_THAT(transfer.new_faces, ElementsAre(5, 6));
  EXPECT_THAT(transfer.lost_faces, ElementsAre(3));
}

TEST(PaintingTransfer, DoesNotTakeNeighboursForOneAnotherInATinyMesh) {
  test::Random random(9);
  PolygonSoup soup = test::grid_soup(5, 5);
  for (glm::dvec3& position : soup.positions) {
    position *= 1e-7;  // All of it within the tolerance.
  }
  const MeshPointer mesh = test::control_mesh(soup);
  const auto depths = test::random_depths(*mesh, 0.5, 5, random);
  const Shuffled other = shuffled(*mesh, Rounding::kFloat, random);
  const PaintingTransfer transfer = transfer_painting(*mesh, depths, other.mesh);
  EXPECT_THAT(transfer.new_faces, IsEmpty());
  for (std::size_t f = 0; f < mesh->face_count(); ++f) {
    EXPECT_EQ(transfer.depths[f], depths[other.faces[f]]) << f;
  }
}

TEST(PaintingTransfer, IsOneCommand) {
  Document document = make_document({test::cube(), {}}, "cube");
  document.depths.set(2, 3);
  test::Random random(1);
  const Shuffled other = shuffled(*test::cube(), Rounding::kNone, random);
  const MeshPointer before = document.control;
  const auto command =
      reattach_command(transfer_painting(*document.control, document.depths.values(), other.mesh));
  command->apply(document);
  EXPECT_EQ(&document.control->topology(), &other.mesh->topology());
  EXPECT_EQ(document.depths.deepest(), 3);
  command->revert(document);
  EXPECT_EQ(document.control, before);
  EXPECT_EQ(document.depths[2], 3);
}

}  // namespace
}  // namespace limn
