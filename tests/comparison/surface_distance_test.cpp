#include "limn/comparison/surface_distance.h"

#include <cmath>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "limn/mesh/bundled.h"
#include "limn/mesh/triangulate.h"
#include "support/shapes.h"

namespace limn::test {
namespace {

SurfaceDistance measured(const ControlMesh& mesh, const ControlMesh& other) {
  IgnoreProgress nobody;
  return measure_surface_distance(mesh, other, nobody).value();
}

MeshPointer shifted(const ControlMesh& mesh, const glm::dvec3& by) {
  std::vector<glm::dvec3> positions;
  std::vector<std::vector<std::uint32_t>> faces;
  for (const glm::dvec3& p : mesh.positions()) {
    positions.push_back(p + by);
  }
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    faces.emplace_back(mesh.face(f).begin(), mesh.face(f).end());
  }
  return control_mesh(positions, faces);
}

MeshPointer square(double from, double to, double z) {
  return control_mesh({{from, from, z}, {to, from, z}, {to, to, z}, {from, to, z}}, {{0, 1, 2, 3}});
}

TEST(SurfaceDistance, OfAMeshToItselfIsNothing) {
  for (const char* name : {"creature", "mixed"}) {
    const MeshPointer mesh = load_bundled_mesh(name)->mesh;
    const SurfaceDistance distance = measured(*mesh, *mesh);
    EXPECT_TRUE(distance.is_settled);
    EXPECT_LT(distance.greatest(), 1e-12 * mesh->bounds().diagonal()) << name;
  }
}

TEST(SurfaceDistance, IsToTheTrianglesOfStlFiles) {
  const MeshPointer mesh = load_bundled_mesh("creature")->mesh;
  EXPECT_LT(measured(*mesh, *triangulated(*mesh)).greatest(), 1e-12 * mesh->bounds().diagonal());
}

TEST(SurfaceDistance, OfParallelSquaresIsTheirDistance) {
  const SurfaceDistance distance = measured(*square(0, 1, 0), *square(0, 1, 0.25));
  EXPECT_TRUE(distance.is_settled);
  for (const DirectedDistance* one : {&distance.to_other, &distance.from_other}) {
    EXPECT_NEAR(one->greatest, 0.25, 1e-14);
    EXPECT_NEAR(one->root_mean_square, 0.25, 1e-12);
    EXPECT_NEAR(one->area, 1.0, 1e-14);
    EXPECT_NEAR(glm::distance(one->from, one->to), 0.25, 1e-14);
  }
}

/// From the small square all points of the large one are at hand, but not the other way round.
TEST(SurfaceDistance, IsAnotherInEachDirection) {
  const SurfaceDistance distance = measured(*square(-1, 1, 0), *square(-3, 3, 0));
  EXPECT_NEAR(distance.to_other.greatest, 0.0, 1e-14);
  EXPECT_NEAR(distance.from_other.greatest, 2.0 * std::sqrt(2.0), 1e-14);
  EXPECT_NEAR(glm::distance(distance.from_other.from, distance.from_other.to), 2.0 * std::sqrt(2.0),
              1e-14);
  EXPECT_NEAR(distance.greatest(), 2.0 * std::sqrt(2.0), 1e-14);
  // Beside the square, 4 * 2 * integral of s^2 over 0..2; at its corners, 4 * the integral of
  // x^2 + y^2 over a square of 2 * 2.
  const double squares = 4.0 * 2.0 * (8.0 / 3.0) + 4.0 * 2.0 * 2.0 * (8.0 / 3.0);
  EXPECT_NEAR(distance.from_other.root_mean_square, std::sqrt(squares / 36.0), 1e-3);
  EXPECT_NEAR(distance.root_mean_square(), std::sqrt(squares / 40.0), 1e-3);
}

/// The greatest distance lies within a face: a roof over a square, and the square under it.
TEST(SurfaceDistance, FindsAPeakInsideAFace) {
  const MeshPointer roof = control_mesh({{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {0, 2, 0}, {1.1, 0.7, 1}},
                                        {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  const MeshPointer ground =
      control_mesh({{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {0, 2, 0}}, {{0, 1, 2, 3}});
  const SurfaceDistance distance = measured(*ground, *roof);
  EXPECT_NEAR(distance.from_other.greatest, 1.0, 1e-12);
  // From the ground: the greatest ball under the roof that touches two of its planes and stands on
  // the ground; looked for on a grid of points.
  const auto nearest_plane = [](double x, double y) {
    const double left = x * std::sin(std::atan2(1.0, 1.1));
    const double right = (3 - x) * std::sin(std::atan2(1.0, 1.9));
    const double front = y * std::sin(std::atan2(1.0, 0.7));
    const double back = (2 - y) * std::sin(std::atan2(1.0, 1.3));
    return std::min(std::min(left, right), std::min(front, back));
  };
  double expected = 0.0;
  for (int i = 0; i <= 1500; ++i) {
    for (int j = 0; j <= 1000; ++j) {
      expected = std::max(expected, nearest_plane(0.002 * i, 0.002 * j));
    }
  }
  EXPECT_NEAR(distance.to_other.greatest, expected, 0.005 * expected);
}

TEST(SurfaceDistance, HoldsEverySampleAgainstAllTriangles) {
  Random random(7);
  const MeshPointer mesh = control_mesh(jittered(torus_soup(9, 7), 0.2, random));
  const MeshPointer other =
      control_mesh(with_mixed_faces(jittered(torus_soup(8, 8), 0.3, random), random));
  const SurfaceDistance distance = measured(*mesh, *other);
  EXPECT_TRUE(distance.is_settled);
  // The pair that attains the greatest distance is one of mutual truth: no vertex of the one is
  // farther from any triangle of the other than that.
  const MeshPointer triangles = triangulated(*other);
  const auto to_triangles = [&](const glm::dvec3& p) {
    double least = 1e300;
    for (std::size_t f = 0; f < triangles->face_count(); ++f) {
      const auto face = triangles->face(f);
      for (int i = 0; i <= 60; ++i) {
        for (int j = 0; i + j <= 60; ++j) {
          const double u = i / 60.0;
          const double v = j / 60.0;
          const glm::dvec3 q = u * triangles->positions()[face[0]] +
                               v * triangles->positions()[face[1]] +
                               (1.0 - u - v) * triangles->positions()[face[2]];
          least = std::min(least, glm::distance(p, q));
        }
      }
    }
    return least;
  };
  const DirectedDistance& to = distance.to_other;
  EXPECT_NEAR(to_triangles(to.from), to.greatest, 0.01 * to.greatest);
  EXPECT_NEAR(glm::distance(to.from, to.to), to.greatest, 1e-12);
  for (const glm::dvec3& p : mesh->positions()) {
    EXPECT_LE(to_triangles(p), 1.02 * to.greatest);
  }
}

TEST(SurfaceDistance, MovesAlong) {
  const MeshPointer mesh = load_bundled_mesh("mixed")->mesh;
  const MeshPointer other = shifted(*mesh, {0.1, 0.0, 0.05});
  const SurfaceDistance here = measured(*mesh, *other);
  const glm::dvec3 far(1e4, -2e4, 3e4);
  const SurfaceDistance there = measured(*shifted(*mesh, far), *shifted(*other, far));
  EXPECT_NEAR(here.greatest(), there.greatest(), 1e-9);
  EXPECT_NEAR(here.root_mean_square(), there.root_mean_square(), 1e-9);
}

TEST(SurfaceDistance, StopsWhenAsked) {
  class Cancel final : public Progress {
    bool report(double, std::string_view) override { return false; }
  } cancel;
  const auto cancelled = measure_surface_distance(*cube(), *cube(), cancel);
  ASSERT_FALSE(cancelled);
  EXPECT_EQ(cancelled.error().kind, ErrorKind::kCancelled);
}

/// Where so many samples as it takes are not allowed, it says so.
TEST(SurfaceDistance, SaysWhenItHasNotSettled) {
  IgnoreProgress nobody;
  const auto rough = measure_surface_distance(*square(-1, 1, 0), *square(-3, 3, 0), nobody,
                                              {.change = 1e-9, .samples = 1000});
  ASSERT_TRUE(rough);
  EXPECT_FALSE(rough->is_settled);
  EXPECT_NEAR(rough->greatest(), 2.0 * std::sqrt(2.0), 1e-12);
}

}  // namespace
}  // namespace limn::test
