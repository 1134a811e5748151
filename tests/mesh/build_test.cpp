#include "limn/mesh/build.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/mesh/statistics.h"
#include "mesh/halfedge_assembly.h"
#include "mesh/mesh_checks.h"

namespace limn {
namespace {

using test::faces_of;
using test::faults_of;
using test::soup_of;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Faces = std::vector<std::vector<std::uint32_t>>;

const Faces Cube = {{0, 1, 3, 2}, {2, 3, 5, 4}, {4, 5, 7, 6},
                    {6, 7, 1, 0}, {1, 7, 5, 3}, {6, 0, 2, 4}};

Result<ImportedMesh> build(std::size_t vertex_count, const Faces& faces) {
  return build_control_mesh(soup_of(vertex_count, faces));
}

/// The message of a soup that must be refused.
std::string refusal(const PolygonSoup& soup) {
  const auto built = build_control_mesh(soup);
  if (built.has_value()) {
    return "accepted";
  }
  EXPECT_EQ(built.error().kind, ErrorKind::kBadInput);
  return built.error().message;
}

TEST(BuildControlMesh, CubeKeepsFacesVerticesAndFirstCorners) {
  const PolygonSoup soup = soup_of(8, Cube);
  const auto built = build_control_mesh(soup);
  ASSERT_TRUE(built.has_value()) << to_string(built.error());
  const ControlMesh& mesh = *built->mesh;
  EXPECT_THAT(faults_of(mesh), IsEmpty());
  EXPECT_EQ(faces_of(mesh), Cube);
  EXPECT_EQ(mesh.edge_count(), 12U);
  EXPECT_TRUE(mesh.is_closed());
  EXPECT_TRUE(mesh.is_all_quads());
  EXPECT_FALSE(built->report.is_mended());
  EXPECT_THAT(built->report.sentences(), IsEmpty());
  for (std::size_t v = 0; v < 8; ++v) {
    EXPECT_EQ(mesh.positions()[v], soup.positions[v]);
  }
  EXPECT_EQ(mesh.bounds().low, glm::dvec3(0.0));
  EXPECT_EQ(mesh.bounds().high, glm::dvec3(7.0, 49.0, 343.0));
  EXPECT_EQ(mesh.bounds().centre(), glm::dvec3(3.5, 24.5, 171.5));
  EXPECT_DOUBLE_EQ(mesh.bounds().diagonal(), std::sqrt(7.0 * 7 + 49.0 * 49 + 343.0 * 343));
}

TEST(BuildControlMesh, EdgesAreNumberedAsTheCornersMeetThem) {
  const auto built = build(5, {{0, 1, 2}, {2, 1, 3, 4}});
  ASSERT_TRUE(built.has_value());
  const FlatTopology& t = built->mesh->topology();
  EXPECT_THAT(t.corner_edges, ElementsAre(0, 1, 2, 1, 3, 4, 5));
  EXPECT_THAT(t.edge_corners[1], ElementsAre(1, 3));
  EXPECT_THAT(t.edge_corners[5], ElementsAre(6, kNone));
  EXPECT_FALSE(built->mesh->is_closed());
  EXPECT_FALSE(built->mesh->is_all_quads());
}

TEST(BuildControlMesh, FlipsTheSmallerSideAboutItsFirstCorner) {
  Faces faces = Cube;
  faces[2] = {4, 6, 7, 5};
  const auto built = build(8, faces);
  ASSERT_TRUE(built.has_value());
  EXPECT_EQ(faces_of(*built->mesh), Cube);
  EXPECT_EQ(built->report.count(MendKind::kFlippedFace), 1U);
  EXPECT_TRUE(built->report.is_mended());
  EXPECT_THAT(built->report.sentences(),
              ElementsAre("1 face was turned over to agree with the neighbours."));
}

TEST(BuildControlMesh, OfTwoEqualSidesTheFirstFaceStays) {
  const auto built = build(4, {{0, 1, 2}, {1, 2, 3}});
  ASSERT_TRUE(built.has_value());
  EXPECT_EQ(faces_of(*built->mesh), (Faces{{0, 1, 2}, {1, 3, 2}}));
}

TEST(BuildControlMesh, FlipsEachComponentByItself) {
  // In the first strip two of three faces agree, in the second strip the last two.
  const auto built = build(10, {{0, 1, 2}, {2, 1, 3}, {2, 4, 3}, {5, 7, 6}, {7, 6, 8}, {7, 8, 9}});
  ASSERT_TRUE(built.has_value());
  EXPECT_THAT(faults_of(*built->mesh), IsEmpty());
  EXPECT_EQ(built->report.count(MendKind::kFlippedFace), 2U);
  EXPECT_EQ(faces_of(*built->mesh)[2], (std::vector<std::uint32_t>{2, 3, 4}));
  EXPECT_EQ(faces_of(*built->mesh)[3], (std::vector<std::uint32_t>{5, 6, 7}));
}

TEST(BuildControlMesh, SplitsABowTieAndPutsTheCopyLast) {
  const PolygonSoup soup = soup_of(7, {{0, 1, 2}, {2, 3, 4}, {2, 5, 6}});
  const auto built = build_control_mesh(soup);
  ASSERT_TRUE(built.has_value());
  EXPECT_THAT(faults_of(*built->mesh), IsEmpty());
  EXPECT_EQ(faces_of(*built->mesh), (Faces{{0, 1, 2}, {7, 3, 4}, {8, 5, 6}}));
  EXPECT_EQ(built->report.count(MendKind::kSplitVertex), 2U);
  EXPECT_EQ(built->mesh->positions()[7], soup.positions[2]);
  EXPECT_EQ(built->mesh->positions()[8], soup.positions[2]);
}

TEST(BuildControlMesh, SetsIsolatedVerticesAsideInOrder) {
  const PolygonSoup soup = soup_of(6, {{1, 3, 5}});
  const auto built = build_control_mesh(soup);
  ASSERT_TRUE(built.has_value());
  EXPECT_EQ(faces_of(*built->mesh), (Faces{{0, 1, 2}}));
  EXPECT_EQ(built->report.count(MendKind::kLooseVertex), 3U);
  EXPECT_EQ(built->mesh->positions()[2], soup.positions[5]);
  EXPECT_EQ(built->mesh->bounds().low, soup.positions[1]);
  EXPECT_THAT(built->mesh->attributes().loose_vertices,
              ElementsAre(soup.positions[0], soup.positions[2], soup.positions[4]));
}

TEST(BuildControlMesh, MergesRepeatedCornersKeepingTheFirst) {
  const auto built = build(5, {{0, 0, 1, 2, 2, 2, 0}, {2, 1, 3, 4}});
  ASSERT_TRUE(built.has_value());
  EXPECT_EQ(faces_of(*built->mesh), (Faces{{0, 1, 2}, {2, 1, 3, 4}}));
  EXPECT_EQ(built->report.count(MendKind::kRepeatedCorner), 4U);
}

TEST(BuildControlMesh, BackToBackFacesAreAClosedPillow) {
  for (const Faces& faces : {Faces{{0, 1, 2, 3}, {3, 2, 1, 0}}, Faces{{0, 1, 2}, {2, 1, 0}},
                             Faces{{0, 1, 2, 3, 4}, {2, 1, 0, 4, 3}}}) {
    const auto built = build(faces[0].size(), faces);
    ASSERT_TRUE(built.has_value()) << to_string(built.error());
    EXPECT_THAT(faults_of(*built->mesh), IsEmpty());
    EXPECT_TRUE(built->mesh->is_closed());
    EXPECT_EQ(mesh_statistics(*built->mesh).euler_characteristic, 2);
    EXPECT_EQ(mesh_statistics(*built->mesh).highest_valence, 2U);
  }
}

TEST(BuildControlMesh, ValenceTwoInsideASurface) {
  // A quad glued by two of its edges into the corner of another.
  const auto built = build(6, {{0, 1, 2, 3}, {0, 3, 2, 4}, {0, 4, 2, 5}});
  ASSERT_TRUE(built.has_value());
  EXPECT_THAT(faults_of(*built->mesh), IsEmpty());
  EXPECT_EQ(mesh_statistics(*built->mesh).boundary_edges, 4U);
}

TEST(BuildControlMesh, RefusesWithTheReason) {
  EXPECT_THAT(refusal(PolygonSoup{}), HasSubstr("no faces"));
  EXPECT_THAT(refusal(soup_of(3, {{0, 1, 3}})), HasSubstr("names vertex 3"));
  EXPECT_THAT(refusal(soup_of(3, {{0, 1, kNone}})), HasSubstr("names vertex 4294967295"));
  EXPECT_THAT(refusal(soup_of(3, {{1, 1, 1}, {}, {0, 1, 0, 1}})),
              HasSubstr("no faces to paint on: 3 faces had fewer than three distinct vertices"));
  PolygonSoup soup = soup_of(3, {{0, 1, 2}});
  soup.positions[1].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal(soup), HasSubstr("Vertex 1 has a coordinate that is not a finite number"));
  soup.positions[1].y = -std::numeric_limits<double>::infinity();
  EXPECT_THAT(refusal(soup), HasSubstr("not a finite number"));
  soup.positions[1].y = -1.1e18;
  EXPECT_THAT(refusal(soup), HasSubstr("too far out"));
}

TEST(BuildControlMesh, ErrorsNameTheirPlaces) {
  PolygonSoup soup = soup_of(5, {{0, 1, 2}, {1, 0, 3}});
  soup.source = "some.obj";
  soup.vertex_places = {10, 11, 12, 13, 14};
  soup.face_places = {20, 30};
  soup.positions[3].z = std::numeric_limits<double>::infinity();
  const auto infinite = build_control_mesh(soup);
  ASSERT_FALSE(infinite.has_value());
  EXPECT_THAT(to_string(infinite.error()), HasSubstr("some.obj:13: This vertex has a coordinate"));
  soup.place_unit = PlaceUnit::kByte;
  const auto binary = build_control_mesh(soup);
  ASSERT_FALSE(binary.has_value());
  EXPECT_THAT(to_string(binary.error()), HasSubstr("some.obj: byte 13: This vertex has"));
}

TEST(BuildControlMesh, LimitsOfTheHandles) {
  constexpr std::size_t most = std::numeric_limits<int>::max();
  EXPECT_TRUE(detail::check_halfedge_limits(most, most / 2, most).has_value());
  EXPECT_FALSE(detail::check_halfedge_limits(most + 1, 0, 0).has_value());
  EXPECT_FALSE(detail::check_halfedge_limits(0, most / 2 + 1, 0).has_value());
  const auto faces = detail::check_halfedge_limits(0, 0, most + 1);
  ASSERT_FALSE(faces.has_value());
  EXPECT_EQ(faces.error().kind, ErrorKind::kBadInput);
  EXPECT_THAT(faces.error().message, HasSubstr("2147483647 faces"));
}

TEST(BuildControlMesh, HugePolygonAndHugeFan) {
  constexpr std::uint32_t sides = 50000;
  Faces faces(1);
  for (std::uint32_t v = 0; v < sides; ++v) {
    faces[0].push_back(v);
    faces.push_back({(v + 1) % sides, v, sides});
  }
  std::shuffle(faces.begin() + 1, faces.end(), std::mt19937(7));
  PolygonSoup soup = soup_of(sides + 1, faces);
  for (auto& p : soup.positions) {
    p.z = 0.0;
  }
  const auto built = build_control_mesh(soup);
  ASSERT_TRUE(built.has_value()) << to_string(built.error());
  EXPECT_THAT(faults_of(*built->mesh), IsEmpty());
  const MeshStatistics statistics = mesh_statistics(*built->mesh);
  EXPECT_EQ(statistics.highest_valence, sides);
  EXPECT_EQ(statistics.euler_characteristic, 2);
  EXPECT_THAT(statistics.faces_by_sides,
              ElementsAre(testing::Pair(3U, sides), testing::Pair(sides, 1U)));
}

TEST(BuildControlMesh, FacesInEveryOrderMakeTheSameSurface) {
  // A face-by-face construction meets vertices of several fans on the way to most of these.
  Faces faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4},         {0, 4, 5},
                 {0, 5, 6}, {0, 6, 1}, {1, 6, 5, 4, 3, 2}};
  std::vector<std::size_t> order(faces.size());
  std::iota(order.begin(), order.end(), 0U);
  do {
    Faces shuffled;
    for (const std::size_t f : order) {
      shuffled.push_back(faces[f]);
    }
    const auto built = build(7, shuffled);
    ASSERT_TRUE(built.has_value());
    ASSERT_EQ(faces_of(*built->mesh), shuffled);
    ASSERT_TRUE(built->mesh->is_closed());
    ASSERT_THAT(test::link_faults_of(built->mesh->halfedges()), IsEmpty());
  } while (std::next_permutation(order.begin(), order.end()));
}

}  // namespace
}  // namespace limn
