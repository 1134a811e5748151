// Errors against brute force: limit points of a much finer level, each with its distance from the
// triangles of a uniform level.
#include "limn/subdivision/face_errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "limn/subdivision/label_subdivision.h"
#include "support/attribute_shapes.h"
#include "support/effort.h"
#include "support/shapes.h"

namespace limn {
namespace {

using test::MeshPointer;

RefinedMesh uniform(const ControlMesh& mesh, int levels, SurfacePoints points) {
  SubdivisionSettings settings;
  settings.points = points;
  IgnoreProgress progress;
  return refine(mesh, VertexLabels(mesh.vertex_count(), static_cast<std::uint8_t>(levels)),
                settings, {}, progress)
      .value();
}

double distance_to_segment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 along = b - a;
  const double square = glm::dot(along, along);
  const double t = square > 0.0 ? std::clamp(glm::dot(p - a, along) / square, 0.0, 1.0) : 0.0;
  return glm::distance(p, a + t * along);
}

double distance_to_triangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                            const glm::dvec3& c) {
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const bool is_above = glm::dot(glm::cross(b - a, p - a), normal) >= 0.0 &&
                        glm::dot(glm::cross(c - b, p - b), normal) >= 0.0 &&
                        glm::dot(glm::cross(a - c, p - c), normal) >= 0.0;
  if (is_above && glm::length(normal) > 0.0) {
    return std::abs(glm::dot(p - a, glm::normalize(normal)));
  }
  return std::min(
      {distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

/// The corners of a face, such that triangles around the first of them cut a quad along its shorter
/// diagonal.
std::vector<glm::dvec3> fan_corners(const RefinedMesh& mesh, std::size_t f) {
  std::vector<glm::dvec3> corners;
  for (const std::uint32_t v : mesh.face(f)) {
    corners.push_back(mesh.position(v));
  }
  if (corners.size() == 4 &&
      glm::distance(corners[1], corners[3]) < glm::distance(corners[0], corners[2])) {
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
  }
  return corners;
}

/// The greatest distance of each control face's limit points from the mesh.
std::vector<double> measured_errors(const ControlMesh& control, const RefinedMesh& mesh,
                                    const RefinedMesh& fine) {
  std::vector<std::vector<glm::dvec3>> fans;
  for (std::size_t g = 0; g < mesh.face_count(); ++g) {
    fans.push_back(fan_corners(mesh, g));
  }
  std::vector<double> errors(control.face_count(), 0.0);
  for (std::size_t f = 0; f < fine.face_count(); ++f) {
    for (const std::uint32_t v : fine.face(f)) {
      const glm::dvec3 p = fine.position(v);
      double nearest = 1e300;
      for (const std::vector<glm::dvec3>& fan : fans) {
        for (std::size_t i = 1; i + 1 < fan.size(); ++i) {
          nearest = std::min(nearest, distance_to_triangle(p, fan[0], fan[i], fan[i + 1]));
        }
      }
      double& error = errors[fine.face_control_faces[f]];
      error = std::max(error, nearest);
    }
  }
  return errors;
}

struct Extremes {
  double least = 1e300;
  double greatest = 0.0;
};

/// Measured over foretold, of all faces at some levels.
Extremes ratios(const ControlMesh& mesh, SurfacePoints points, int levels) {
  IgnoreProgress progress;
  FaceErrorOptions options;
  options.points = points;
  const auto errors = face_errors(mesh, options, progress).value();
  const RefinedMesh fine = uniform(mesh, levels + 2, SurfacePoints::kLimit);
  const double trifle = 1e-6 * mesh.bounds().diagonal();
  Extremes extremes;
  for (int level = 0; level <= levels; ++level) {
    const RefinedMesh coarse = uniform(mesh, level, points);
    const std::vector<double> measured = measured_errors(mesh, coarse, fine);
    for (std::size_t f = 0; f < measured.size(); ++f) {
      const double ratio =
          (measured[f] + trifle) / (errors[f][static_cast<std::size_t>(level)] + trifle);
      extremes.least = std::min(extremes.least, ratio);
      extremes.greatest = std::max(extremes.greatest, ratio);
    }
  }
  return extremes;
}

std::vector<test::NamedShape> shapes() {
  test::Random random(3);
  std::vector<test::NamedShape> shapes{
      {"cube", test::cube()},
      {"torus", test::control_mesh(test::jittered(test::torus_soup(5, 4), 0.2, random))},
      {"grid", test::control_mesh(test::jittered(test::grid_soup(4, 3), 0.3, random))},
      {"kites", test::control_mesh(test::trapezohedron_soup(5))},
      {"prism", test::control_mesh(test::prism_soup(5))},
      {"mixed", test::mixed_prism()}};
  for (const test::NamedShape& shape : test::creased_shapes()) {
    if (shape.mesh->face_count() < 16) {
      shapes.push_back(shape);
    }
  }
  return shapes;
}

class FaceErrors : public testing::TestWithParam<SurfacePoints> {};

TEST_P(FaceErrors, AreNeverMuchBelowWhatIsMeasured) {
  std::vector<test::NamedShape> all = shapes();
  const std::size_t most = std::max<std::size_t>(
      3, static_cast<std::size_t>(test::effort() * static_cast<double>(all.size())));
  for (const test::NamedShape& shape : std::span(all).first(most)) {
    const bool goes_deep = shape.mesh->is_all_quads() && test::effort() == 1.0;
    const Extremes extremes = ratios(*shape.mesh, GetParam(), goes_deep ? 2 : 1);
    EXPECT_LE(extremes.greatest, 1.05) << shape.name;
  }
}

TEST_P(FaceErrors, AreTightOnAJitteredTorus) {
  test::Random random(5);
  const MeshPointer torus = test::control_mesh(test::jittered(test::torus_soup(5, 4), 0.1, random));
  const Extremes extremes = ratios(*torus, GetParam(), test::effort() < 1.0 ? 1 : 2);
  EXPECT_GE(extremes.least, 0.2);
}

TEST_P(FaceErrors, AreNothingInAPlane) {
  // However uneven the points: a distance is to the surface, not to a point of it.
  test::Random random(9);
  PolygonSoup soup = test::jittered(test::grid_soup(6, 6), 0.2, random);
  for (glm::dvec3& p : soup.positions) {
    p.z = 0.0;
  }
  const MeshPointer plane = test::control_mesh(soup);
  FaceErrorOptions options;
  options.points = GetParam();
  IgnoreProgress progress;
  const auto errors = face_errors(*plane, options, progress).value();
  EXPECT_LT(errors[14][0], 1e-6F);  // Inside.
  EXPECT_GT(errors[0][0], 1e-3F);   // Its boundary is a curve.
}

TEST_P(FaceErrors, AreNothingAroundIrregularVerticesInAPlane) {
  // Three quads around a vertex, refined so that the boundary is far, then made uneven: what moves
  // within the plane is no distance.
  PolygonSoup three;
  three.positions = {{0.0, 0.0, 0.0}};
  for (int i = 0; i < 6; ++i) {
    const double angle = glm::radians(60.0 * i);
    three.positions.emplace_back(std::cos(angle), std::sin(angle), 0.0);
  }
  three.add_face(std::array{0U, 1U, 2U, 3U});
  three.add_face(std::array{0U, 3U, 4U, 5U});
  three.add_face(std::array{0U, 5U, 6U, 1U});
  const RefinedMesh finer = uniform(*test::control_mesh(three), 3, SurfacePoints::kLevel);
  test::Random random(4);
  PolygonSoup soup;
  for (std::size_t v = 0; v < finer.vertex_count(); ++v) {
    soup.positions.push_back(finer.position(static_cast<std::uint32_t>(v)));
  }
  for (std::size_t f = 0; f < finer.face_count(); ++f) {
    soup.add_face(finer.face(f));
  }
  soup = test::jittered(soup, 0.02, random);
  for (glm::dvec3& p : soup.positions) {
    p.z = 0.0;
  }
  const MeshPointer plane = test::control_mesh(soup);
  FaceErrorOptions options;
  options.points = GetParam();
  IgnoreProgress progress;
  const auto errors = face_errors(*plane, options, progress).value();
  std::size_t irregular = 0;
  for (std::size_t f = 0; f < errors.size(); ++f) {
    double farthest = 0.0;
    for (const std::uint32_t v : plane->face(f)) {
      farthest = std::max(farthest, glm::length(plane->positions()[v]));
    }
    if (farthest < 0.3) {
      EXPECT_LT(errors[f][0], 1e-6F) << f;
      ++irregular;
    }
  }
  EXPECT_GE(irregular, 3U);
}

TEST(FaceErrorsOptions, NothingIsOffOnAFlatCapBesideACrease) {
  // The top of a box, unevenly divided, with walls and a crease around it. Faces beside the middle
  // of a side lie in the plane; the crease is straight there, and the walls are others' business.
  constexpr std::uint32_t kSide = 8;
  constexpr std::array kPlaces{0.0, 1.0, 2.3, 3.1, 4.4, 5.2, 6.5, 7.2, 8.4};
  PolygonSoup soup = test::grid_soup(kSide, kSide);
  for (std::uint32_t v = 0; v < soup.positions.size(); ++v) {
    soup.positions[v] = {kPlaces[v % (kSide + 1)], kPlaces[v / (kSide + 1)], 0.0};
  }
  std::vector<std::uint32_t> rim;
  for (std::uint32_t i = 0; i < 4 * kSide; ++i) {
    const std::uint32_t at = i % kSide;
    const std::array<std::uint32_t, 4> columns{at, kSide, kSide - at, 0};
    const std::array<std::uint32_t, 4> rows{0, at, kSide, kSide - at};
    rim.push_back(rows[i / kSide] * (kSide + 1) + columns[i / kSide]);
  }
  const auto first_low = static_cast<std::uint32_t>(soup.positions.size());
  for (const std::uint32_t v : rim) {
    soup.positions.push_back(soup.positions[v] - glm::dvec3(0.0, 0.0, 2.0));
  }
  for (std::uint32_t i = 0; i < rim.size(); ++i) {
    const auto next = static_cast<std::uint32_t>((i + 1) % rim.size());
    soup.add_face(std::array{rim[next], rim[i], first_low + i, first_low + next});
  }
  const MeshPointer smooth = test::control_mesh(soup);
  MeshAttributes attributes;
  for (const auto& [a, b] : smooth->topology().edge_vertices) {
    const bool is_rim = std::ranges::count(rim, a) + std::ranges::count(rim, b) == 2;
    attributes.creases.edge_sharpness.push_back(is_rim ? kInfiniteSharpness : 0.0F);
  }
  const ControlMesh box = smooth->with_attributes(attributes);
  IgnoreProgress progress;
  const auto errors = face_errors(box, {}, progress).value();
  for (const std::size_t f : {3U, 4U}) {
    EXPECT_LT(errors[f][1], 1e-6F) << f;
  }
}

INSTANTIATE_TEST_SUITE_P(Points, FaceErrors,
                         testing::Values(SurfacePoints::kLimit, SurfacePoints::kLevel),
                         [](const auto& points) {
                           return points.param == SurfacePoints::kLimit ? "Limit" : "Level";
                         });

TEST(FaceErrorsOptions, EnoughLeavesWhatIsAboveItAsItIs) {
  const MeshPointer mesh = test::control_mesh(test::trapezohedron_soup(7));
  IgnoreProgress progress;
  const auto all = face_errors(*mesh, {}, progress).value();
  const double enough = 0.01 * mesh->bounds().diagonal();
  FaceErrorOptions options;
  options.enough = enough;
  const auto some = face_errors(*mesh, options, progress).value();
  std::size_t above = 0;
  for (std::size_t f = 0; f < all.size(); ++f) {
    for (std::size_t level = 0; level < kErrorLevels; ++level) {
      if (std::max(all[f][level], some[f][level]) > enough) {
        EXPECT_EQ(all[f][level], some[f][level]) << f << " " << level;
        ++above;
      }
    }
  }
  EXPECT_EQ(above, 2 * all.size());
}

TEST(FaceBends, AreTheAnglesOfACylinder) {
  // Eight quads around and long ones along: rings far from the ends turn by 45 degrees each.
  PolygonSoup soup;
  for (int ring = 0; ring < 6; ++ring) {
    for (int i = 0; i < 8; ++i) {
      const double angle = glm::radians(45.0 * i);
      soup.positions.emplace_back(std::cos(angle), std::sin(angle), ring);
    }
  }
  for (std::uint32_t ring = 0; ring < 5; ++ring) {
    for (std::uint32_t i = 0; i < 8; ++i) {
      const std::uint32_t next = (i + 1) % 8;
      soup.add_face(
          std::array{8 * ring + i, 8 * ring + next, 8 * ring + 8 + next, 8 * ring + 8 + i});
    }
  }
  const MeshPointer cylinder = test::control_mesh(soup);
  IgnoreProgress progress;
  const auto bends = face_bends(*cylinder, CornerRule::kSharp, progress).value();
  for (std::size_t f = 16; f < 24; ++f) {
    EXPECT_NEAR(bends[f], 45.0, 1e-4);
  }
}

TEST(FaceBends, DoNotSeeBeyondACrease) {
  // The faces of a cube with all edges sharp are flat.
  PolygonSoup soup = test::cube_soup();
  std::vector<CreaseTag> creases;
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    const auto face = soup.face(f);
    for (std::size_t i = 0; i < 4; ++i) {
      if (face[i] < face[(i + 1) % 4]) {
        creases.push_back({{face[i], face[(i + 1) % 4]}, kInfiniteSharpness});
      }
    }
  }
  const MeshPointer cube = test::with_tags(soup, creases);
  IgnoreProgress progress;
  const auto creased = face_bends(*cube, CornerRule::kSharp, progress).value();
  const auto smooth = face_bends(*test::cube(), CornerRule::kSharp, progress).value();
  for (std::size_t f = 0; f < 6; ++f) {
    EXPECT_NEAR(creased[f], 0.0, 1e-4);
    EXPECT_GT(smooth[f], 60.0);
  }
}

}  // namespace
}  // namespace limn
