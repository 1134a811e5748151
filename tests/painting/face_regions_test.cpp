// Regions against brute force: Floyd's shortest paths and a flood by repeated sweeps, both over
// neighbours found from the faces' vertices alone.
#include "limn/painting/face_regions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "limn/mesh/bundled.h"
#include "limn/painting/selection.h"
#include "support/shapes.h"

namespace limn {
namespace {

using test::MeshPointer;
using ::testing::ElementsAre;
using ::testing::IsSupersetOf;

struct Neighbours {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  double angle = 0.0;
};

glm::dvec3 normal_of(const ControlMesh& mesh, std::uint32_t face) {
  const auto corners = mesh.face(face);
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sum += glm::cross(mesh.positions()[corners[i]],
                      mesh.positions()[corners[(i + 1) % corners.size()]]);
  }
  return glm::normalize(sum);
}

/// Every pair of faces with a common edge.
std::vector<Neighbours> neighbours_of(const ControlMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> by_edge;
  std::vector<Neighbours> pairs;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    const auto corners = mesh.face(f);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto from = corners[i];
      const auto to = corners[(i + 1) % corners.size()];
      if (const auto other = by_edge.find({to, from}); other != by_edge.end()) {
        const double cosine = glm::dot(normal_of(mesh, f), normal_of(mesh, other->second));
        pairs.push_back(
            {f, other->second, std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / std::acos(-1.0)});
      }
      by_edge[{from, to}] = f;
    }
  }
  return pairs;
}

/// Floyd's algorithm: the least sum of angles between any two faces.
std::vector<std::vector<double>> all_distances(const ControlMesh& mesh) {
  const std::size_t n = mesh.face_count();
  std::vector distance(n, std::vector(n, std::numeric_limits<double>::infinity()));
  for (std::size_t f = 0; f < n; ++f) {
    distance[f][f] = 0.0;
  }
  for (const auto& [a, b, angle] : neighbours_of(mesh)) {
    distance[a][b] = distance[b][a] = std::min(distance[a][b], angle);
  }
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        distance[i][j] = std::min(distance[i][j], distance[i][k] + distance[k][j]);
      }
    }
  }
  return distance;
}

/// Sweeps over all pairs until nothing is added.
std::vector<std::uint32_t> swept(const ControlMesh& mesh, std::span<const std::uint8_t> depths,
                                 std::uint32_t seed) {
  std::vector<bool> is_in(mesh.face_count());
  is_in[seed] = true;
  const auto pairs = neighbours_of(mesh);
  for (bool grows = true; grows;) {
    grows = false;
    for (const auto& [a, b, angle] : pairs) {
      if (is_in[a] != is_in[b] && depths[a] == depths[seed] && depths[b] == depths[seed]) {
        is_in[a] = is_in[b] = grows = true;
      }
    }
  }
  std::vector<std::uint32_t> faces;
  for (std::uint32_t f = 0; f < is_in.size(); ++f) {
    if (is_in[f]) {
      faces.push_back(f);
    }
  }
  return faces;
}

std::vector<MeshPointer> random_meshes() {
  test::Random random(11);
  std::vector<MeshPointer> meshes;
  for (std::uint32_t round = 0; round < 6; ++round) {
    meshes.push_back(test::control_mesh(test::jittered(
        test::with_holes(test::with_mixed_faces(test::grid_soup(7, 6), random), 5, random), 0.3,
        random)));
    meshes.push_back(test::control_mesh(
        test::jittered(test::with_mixed_faces(test::torus_soup(8, 5), random), 0.1, random)));
  }
  return meshes;
}

TEST(FloodRegion, IsWhatSweepingFinds) {
  test::Random random(3);
  for (const MeshPointer& mesh : random_meshes()) {
    const auto depths = test::random_depths(*mesh, 0.4, 2, random);
    for (std::uint32_t seed = 0; seed < mesh->face_count(); seed += 3) {
      EXPECT_EQ(flood_region(*mesh, depths, seed), swept(*mesh, depths, seed)) << seed;
    }
  }
}

TEST(FloodRegion, DoesNotPassThroughAVertexAlone) {
  const MeshPointer grid = test::grid(2);
  const std::vector<std::uint8_t> diagonal{3, 0, 0, 3};
  EXPECT_THAT(flood_region(*grid, diagonal, 0), ElementsAre(0));
  EXPECT_THAT(flood_region(*grid, diagonal, 3), ElementsAre(3));
}

TEST(ConnectedRegion, StopsAtTheBoundary) {
  const MeshPointer two = test::control_mesh({{0, 0, 0},
                                              {1, 0, 0},
                                              {1, 1, 0},
                                              {0, 1, 0},
                                              {2, 0, 0},
                                              {2, 1, 0},
                                              {5, 0, 0},
                                              {6, 0, 0},
                                              {6, 1, 0}},
                                             {{0, 1, 2, 3}, {6, 7, 8}, {1, 4, 5, 2}});
  EXPECT_THAT(connected_region(*two, 0), ElementsAre(0, 2));
  EXPECT_THAT(connected_region(*two, 1), ElementsAre(1));
}

TEST(SmartRegion, IsWhatFloydFinds) {
  for (const MeshPointer& mesh : random_meshes()) {
    const auto distance = all_distances(*mesh);
    const auto angles = edge_dihedral_angles(*mesh);
    for (std::uint32_t seed = 0; seed < mesh->face_count(); seed += 5) {
      for (const double degrees : {0.0, 10.0, 35.0, 90.0, 200.0, kMostFillAngle}) {
        std::vector<std::uint32_t> sure;
        std::vector<std::uint32_t> possible;
        for (std::uint32_t f = 0; f < mesh->face_count(); ++f) {
          // The two ways of adding up differ by rounding.
          if (distance[seed][f] <= degrees - 1e-6 || f == seed) {
            sure.push_back(f);
          }
          if (distance[seed][f] <= degrees + 2.0 * kDihedralTolerance) {
            possible.push_back(f);
          }
        }
        const auto region = smart_region(*mesh, angles, seed, degrees);
        EXPECT_THAT(region, IsSupersetOf(sure));
        EXPECT_THAT(possible, IsSupersetOf(region));
        EXPECT_TRUE(std::ranges::is_sorted(region));
      }
    }
  }
}

TEST(SmartRegion, AddsUpAnglesAlongTheWay) {
  // A strip that bends by 30 degrees at every edge.
  std::vector<glm::dvec3> points;
  std::vector<std::vector<std::uint32_t>> faces;
  glm::dvec3 at(0.0);
  for (std::uint32_t i = 0; i < 7; ++i) {
    points.push_back(at);
    points.push_back(at + glm::dvec3(0, 1, 0));
    const double angle = i * std::acos(-1.0) / 6.0;
    at += glm::dvec3(std::cos(angle), 0.0, std::sin(angle));
    if (i > 0) {
      faces.push_back({2 * i - 2, 2 * i, 2 * i + 1, 2 * i - 1});
    }
  }
  const MeshPointer strip = test::control_mesh(points, faces);
  const auto angles = edge_dihedral_angles(*strip);
  EXPECT_THAT(smart_region(*strip, angles, 0, 29.9), ElementsAre(0));
  EXPECT_THAT(smart_region(*strip, angles, 0, 30.0), ElementsAre(0, 1));
  EXPECT_THAT(smart_region(*strip, angles, 0, 89.0), ElementsAre(0, 1, 2));
  EXPECT_THAT(smart_region(*strip, angles, 2, 60.0), ElementsAre(0, 1, 2, 3, 4));
}

TEST(SmartRegion, AFlatPatchOfACubeIsOneFace) {
  const MeshPointer cube = test::cube();
  const auto angles = edge_dihedral_angles(*cube);
  EXPECT_THAT(smart_region(*cube, angles, 0, 89.0), ElementsAre(0));
  EXPECT_THAT(smart_region(*cube, angles, 0, 90.0), ElementsAre(0, 2, 3, 4, 5));
  EXPECT_THAT(smart_region(*cube, angles, 0, 180.0), ElementsAre(0, 1, 2, 3, 4, 5));
}

}  // namespace
}  // namespace limn
