// What becomes of soups that are no manifolds, case by case.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/mesh/build.h"
#include "limn/mesh/statistics.h"
#include "mesh/mesh_checks.h"

namespace limn {
namespace {

using test::faces_of;
using test::faults_of;
using test::soup_of;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Faces = std::vector<std::vector<std::uint32_t>>;

PolygonSoup soup_at(std::vector<glm::dvec3> positions, const Faces& faces) {
  PolygonSoup soup;
  soup.positions = std::move(positions);
  for (const auto& face : faces) {
    soup.add_face(face);
  }
  return soup;
}

ImportedMesh mended(const PolygonSoup& soup) {
  auto built = build_control_mesh(soup);
  EXPECT_TRUE(built.has_value()) << to_string(built.error());
  if (!built) {
    return {};
  }
  EXPECT_THAT(faults_of(*built->mesh), IsEmpty());
  return *std::move(built);
}

const Faces UnitCube = {{0, 1, 3, 2}, {2, 3, 5, 4}, {4, 5, 7, 6},
                        {6, 7, 1, 0}, {1, 7, 5, 3}, {6, 0, 2, 4}};

/// The corners of a unit cube in the order that `UnitCube` names them.
std::vector<glm::dvec3> cube_at(const glm::dvec3& low) {
  std::vector<glm::dvec3> corners;
  for (const glm::dvec3& at : {glm::dvec3(0, 0, 1),
                               {1, 0, 1},
                               {0, 1, 1},
                               {1, 1, 1},
                               {0, 1, 0},
                               {1, 1, 0},
                               {0, 0, 0},
                               {1, 0, 0}}) {
    corners.push_back(low + at);
  }
  return corners;
}

/// Two cubes whose common vertices, by position, have one number.
PolygonSoup two_cubes(const glm::dvec3& second) {
  PolygonSoup soup = soup_at(cube_at(glm::dvec3(0.0)), UnitCube);
  std::vector<std::uint32_t> numbers;
  for (const glm::dvec3& p : cube_at(second)) {
    const auto same = std::find(soup.positions.begin(), soup.positions.end(), p);
    numbers.push_back(static_cast<std::uint32_t>(same - soup.positions.begin()));
    if (same == soup.positions.end()) {
      soup.positions.push_back(p);
    }
  }
  for (auto face : UnitCube) {
    for (std::uint32_t& v : face) {
      v = numbers[v];
    }
    soup.add_face(face);
  }
  return soup;
}

TEST(Manifold, AFlippedFaceOfACubeIsTurnedAndNothingIsTorn) {
  for (std::size_t f = 0; f < UnitCube.size(); ++f) {
    Faces faces = UnitCube;
    std::reverse(faces[f].begin(), faces[f].end());
    const ImportedMesh built = mended(soup_at(cube_at(glm::dvec3(0.0)), faces));
    EXPECT_EQ(built.mesh->vertex_count(), 8U);
    EXPECT_TRUE(built.mesh->is_closed());
    ASSERT_EQ(built.report.mends.size(), 1U);
    EXPECT_EQ(built.report.mends[0].kind, MendKind::kFlippedFace);
    ASSERT_EQ(built.report.mends[0].elements.size(), 1U);
    EXPECT_EQ(built.report.mends[0].elements[0].face, f);
  }
}

TEST(Manifold, CubesThatShareAnEdgeBecomeTwoClosedCubes) {
  const PolygonSoup soup = two_cubes({1.0, 1.0, 0.0});
  ASSERT_EQ(soup.positions.size(), 14U);
  const ImportedMesh built = mended(soup);
  const MeshStatistics counts = mesh_statistics(*built.mesh);
  EXPECT_EQ(counts.vertices, 16U);
  EXPECT_EQ(counts.components, 2U);
  EXPECT_TRUE(built.mesh->is_closed());
  EXPECT_EQ(built.report.count(MendKind::kCrowdedEdge), 1U);
  EXPECT_EQ(built.report.count(MendKind::kSplitVertex), 2U);
  EXPECT_EQ(built.report.mends[0].elements[0].position, glm::dvec3(1.0, 1.0, 0.5));
}

TEST(Manifold, CubesThatShareAVertexBecomeTwo) {
  const ImportedMesh built = mended(two_cubes({1.0, 1.0, 1.0}));
  EXPECT_EQ(mesh_statistics(*built.mesh).components, 2U);
  EXPECT_EQ(built.report.count(MendKind::kCrowdedEdge), 0U);
  EXPECT_EQ(built.report.count(MendKind::kSplitVertex), 1U);
}

TEST(Manifold, CubesWithACommonWallBecomeABox) {
  // The wall is there twice, facing either way; outside, the straight pairs stay joined.
  const ImportedMesh built = mended(two_cubes({1.0, 0.0, 0.0}));
  const MeshStatistics counts = mesh_statistics(*built.mesh);
  EXPECT_EQ(built.report.count(MendKind::kCrowdedEdge), 4U);
  EXPECT_EQ(counts.components, 2U);
  EXPECT_EQ(counts.vertices, 16U);  // The box of ten faces and the wall's two, back to back.
  EXPECT_TRUE(built.mesh->is_closed());
}

TEST(Manifold, AWallOnAFloorEndsThereAndTheFloorStaysWhole) {
  // Two floor quads with a wall of two quads along the middle.
  const PolygonSoup soup = soup_at({{0, 0, 0},
                                    {1, 0, 0},
                                    {2, 0, 0},
                                    {0, 1, 0},
                                    {1, 1, 0},
                                    {2, 1, 0},
                                    {1, 0, 1},
                                    {1, 1, 1},
                                    {1, 0, 2},
                                    {1, 1, 2}},
                                   {{1, 4, 7, 6}, {6, 7, 9, 8}, {0, 1, 4, 3}, {1, 2, 5, 4}});
  const ImportedMesh built = mended(soup);
  EXPECT_EQ(faces_of(*built.mesh),
            (Faces{{1, 4, 7, 6}, {6, 7, 9, 8}, {0, 10, 11, 3}, {10, 2, 5, 11}}));
  EXPECT_EQ(built.report.count(MendKind::kSplitVertex), 2U);
  EXPECT_EQ(mesh_statistics(*built.mesh).boundary_edges, 12U);
}

TEST(Manifold, ABookOfPagesKeepsPairsAndNeverTearsAPage) {
  for (std::uint32_t pages = 3; pages < 80; pages += 7) {
    PolygonSoup soup;
    soup.positions = {{0, 0, 0}, {0, 0, 1}};
    for (std::uint32_t p = 0; p < pages; ++p) {
      const double angle = 0.05 * p;
      for (const double radius : {1.0, 2.0}) {
        for (const double z : {0.0, 1.0}) {
          soup.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
        }
      }
      const std::uint32_t v = 2 + 4 * p;
      soup.add_face(p % 2 == 0 ? std::vector<std::uint32_t>{0, v, v + 1, 1}
                               : std::vector<std::uint32_t>{1, v + 1, v, 0});
      soup.add_face(p % 2 == 0 ? std::vector<std::uint32_t>{v, v + 2, v + 3, v + 1}
                               : std::vector<std::uint32_t>{v + 1, v + 3, v + 2, v});
    }
    const ImportedMesh built = mended(soup);
    EXPECT_EQ(built.report.count(MendKind::kCrowdedEdge), 1U);
    const std::size_t pairs = std::min(pages, 32U) / 2;
    EXPECT_EQ(mesh_statistics(*built.mesh).components, pages - pairs);
  }
}

TEST(Manifold, APinchedTubeIsClosedWhereItsFansAsk) {
  // A six-sided tube, two opposite long edges of which are named as one: that edge has four faces,
  // and every pairing has to leave edges of different ends.
  Faces faces;
  const auto at = [](std::uint32_t ring, std::uint32_t corner) {
    constexpr std::array<std::uint32_t, 7> names{0, 1, 2, 0, 3, 4, 0};
    return ring * 5 + names[corner];
  };
  for (std::uint32_t ring = 0; ring < 3; ++ring) {
    for (std::uint32_t corner = 0; corner < 6; ++corner) {
      faces.push_back(
          {at(ring, corner), at(ring, corner + 1), at(ring + 1, corner + 1), at(ring + 1, corner)});
    }
  }
  const ImportedMesh built = mended(soup_of(20, faces));
  EXPECT_EQ(built.report.count(MendKind::kCrowdedEdge), 3U);
  EXPECT_EQ(mesh_statistics(*built.mesh).boundary_edges, 12U);
  const auto again =
      build_control_mesh(soup_of(built.mesh->vertex_count(), faces_of(*built.mesh)), {true});
  EXPECT_TRUE(again.has_value()) << to_string(again.error());
}

TEST(Manifold, MoebiusBandsAreCutOnce) {
  for (std::uint32_t n = 3; n < 12; ++n) {
    Faces strip;
    for (std::uint32_t i = 0; i + 1 < n; ++i) {
      strip.push_back({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
    }
    Faces annulus = strip;
    annulus.push_back({2 * n - 2, 0, 1, 2 * n - 1});
    EXPECT_FALSE(mended(soup_of(2 * n, annulus)).report.is_mended()) << n;
    strip.push_back({2 * n - 2, 1, 0, 2 * n - 1});
    const ImportedMesh built = mended(soup_of(2 * n, strip));
    EXPECT_EQ(built.report.count(MendKind::kOneSidedEdge), 1U) << n;
    EXPECT_EQ(mesh_statistics(*built.mesh).boundary_edges, 2 * n + 2) << n;
    EXPECT_EQ(mesh_statistics(*built.mesh).boundary_loops, 1U) << n;
  }
}

TEST(Manifold, DegenerateAndRepeatedFacesAreDroppedAndTold) {
  PolygonSoup soup =
      soup_of(5, {{0, 1, 1}, {0, 1, 2}, {2, 2, 2}, {1, 0, 3}, {1, 2, 0}, {3, 1, 0, 0}});
  soup.face_places = {11, 12, 13, 14, 15, 16};
  soup.vertex_places = {1, 2, 3, 4, 5};
  soup.face_depths = {9, 1, 9, 2, 9, 9};
  soup.names.groups = {{"hull", "deck"}, {0, 1, 0, 0, 0, 1}};
  const ImportedMesh built = mended(soup);
  EXPECT_EQ(faces_of(*built.mesh), (Faces{{0, 1, 2}, {1, 0, 3}}));
  EXPECT_THAT(built.depths, ElementsAre(1, 2));
  EXPECT_THAT(built.mesh->attributes().names.groups.of_faces, ElementsAre(1, 0));
  EXPECT_THAT(built.report.sentences(),
              ElementsAre("1 corner of a face repeated the one before and was merged with it.",
                          "2 faces had fewer than three distinct vertices and were dropped.",
                          "2 faces repeated others and were dropped.",
                          "1 vertex is in no face; it is kept aside and written back."));
  const Mend& dropped = built.report.mends[1];
  EXPECT_EQ(dropped.elements[1].place, 13U);
  EXPECT_EQ(dropped.elements[1].face, kNone);
  EXPECT_EQ(place_of(built.report, dropped, dropped.elements[1]), "line 13");
}

TEST(Manifold, AFaceThatMeetsItselfInAPointIsTakenWhereItsFansAreApart) {
  // Two triangles drawn in one stroke.
  const ImportedMesh built = mended(soup_of(5, {{0, 1, 2, 0, 3, 4}}));
  EXPECT_EQ(faces_of(*built.mesh), (Faces{{0, 1, 2, 5, 3, 4}}));
  EXPECT_EQ(built.report.count(MendKind::kSplitVertex), 1U);
}

TEST(Manifold, CutEdgesKeepTheirSharpnessOnBothSides) {
  PolygonSoup soup = two_cubes({1.0, 1.0, 0.0});
  // The shared edge runs between the vertices 3 and 5 of the first cube.
  soup.creases.push_back({{3, 5}, 2.5f});
  const ImportedMesh built = mended(soup);
  EXPECT_EQ(std::ranges::count(built.mesh->creases().edge_sharpness, 2.5f), 2);
}

TEST(Manifold, StrictnessRefusesWithThePlaceOfTheFirst) {
  PolygonSoup soup = soup_of(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  soup.source = "some.obj";
  soup.vertex_places = {10, 11, 12, 13, 14};
  soup.face_places = {20, 30, 40};
  const auto strict = build_control_mesh(soup, {true});
  ASSERT_FALSE(strict.has_value());
  EXPECT_EQ(strict.error().kind, ErrorKind::kBadInput);
  EXPECT_THAT(to_string(strict.error()),
              HasSubstr("some.obj:20: Refused, since nothing may be mended. Else: 1 edge had three "
                        "or more faces"));
  EXPECT_TRUE(build_control_mesh(soup_at(cube_at(glm::dvec3(0.0)), UnitCube), {true}).has_value());
}

TEST(Manifold, LooseVerticesAreKeptAndTold) {
  const ImportedMesh built = mended(soup_of(4, {{0, 1, 3}}));
  ASSERT_EQ(built.mesh->attributes().loose_vertices.size(), 1U);
  EXPECT_EQ(built.report.mends[0].elements[0].place, 2U);
  EXPECT_EQ(place_of(built.report, built.report.mends[0], built.report.mends[0].elements[0]),
            "vertex 2");
}

}  // namespace
}  // namespace limn
