// The distance to the limit surface against OpenSubdiv: its limit positions of a deep uniform
// level, and every triangle looked at.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "limn/comparison/limit_distance.h"
#include "limn/mesh/bundled.h"
#include "limn/mesh/import.h"
#include "limn/mesh/triangulate.h"
#include "limn/subdivision/label_subdivision.h"
#include "support/attribute_shapes.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/opensubdiv_reference.h"
#include "support/shapes.h"

namespace limn::test {
namespace {

/// Triangles in the order of the x of their middles, looked at from the nearest outwards.
class Triangles {
 public:
  using Corners = std::array<glm::dvec3, 3>;

  explicit Triangles(const std::vector<Corners>& corners) {
    for (const Corners& t : corners) {
      const glm::dvec3 middle = (t[0] + t[1] + t[2]) / 3.0;
      const double radius = std::max(
          {glm::distance(middle, t[0]), glm::distance(middle, t[1]), glm::distance(middle, t[2])});
      largest_ = std::max(largest_, radius);
      balls_.push_back({middle, radius, t});
    }
    std::sort(balls_.begin(), balls_.end(),
              [](const Ball& a, const Ball& b) { return a.middle.x < b.middle.x; });
  }

  [[nodiscard]] double distance_to(const glm::dvec3& p) const {
    const auto start = std::lower_bound(balls_.begin(), balls_.end(), p.x,
                                        [](const Ball& a, double x) { return a.middle.x < x; });
    double best = 1e300;
    const auto look = [&](const Ball& ball) {
      if (std::abs(ball.middle.x - p.x) > best + largest_) {
        return false;
      }
      const double reach = best + ball.radius;
      const glm::dvec3 offset = p - ball.middle;
      if (glm::dot(offset, offset) < reach * reach) {
        best = std::min(best, distance(p, ball.corners));
      }
      return true;
    };
    for (auto up = start; up != balls_.end() && look(*up); ++up) {
    }
    for (auto down = start; down != balls_.begin() && look(*(down - 1)); --down) {
    }
    return best;
  }

 private:
  struct Ball {
    glm::dvec3 middle;
    double radius;
    Corners corners;
  };

  static double to_segment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
    const double square = glm::dot(b - a, b - a);
    const double share = square > 0.0 ? std::clamp(glm::dot(p - a, b - a) / square, 0.0, 1.0) : 0.0;
    return glm::distance(p, a + share * (b - a));
  }

  /// To the plane where its foot lies within all sides, else to the nearest side.
  static double distance(const glm::dvec3& p, const Corners& t) {
    const glm::dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
    bool is_inside = glm::dot(normal, normal) > 0.0;
    double sides = 1e300;
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec3& a = t[i];
      const glm::dvec3& b = t[(i + 1) % 3];
      is_inside = is_inside && glm::dot(glm::cross(b - a, p - a), normal) >= 0.0;
      sides = std::min(sides, to_segment(p, a, b));
    }
    return is_inside ? std::abs(glm::dot(p - t[0], normal)) / glm::length(normal) : sides;
  }

  std::vector<Ball> balls_;
  double largest_ = 0.0;
};

/// The limit surface by OpenSubdiv.
struct Limit {
  std::vector<glm::dvec3> points;
  std::vector<double> areas;  ///< Around each point.
  std::vector<Triangles::Corners> triangles;
};

Limit limit_of(const ControlMesh& mesh, int levels, CornerRule corners) {
  const UniformHierarchy hierarchy(mesh, levels, corners);
  Limit limit;
  limit.points = hierarchy.limits(mesh.positions()).positions;
  limit.areas.resize(limit.points.size());
  for (std::uint32_t f = 0; f < hierarchy.face_count(levels); ++f) {
    const auto v = hierarchy.face_vertices(levels, f);
    for (const std::array<std::size_t, 3>& t :
         {std::array<std::size_t, 3>{0, 1, 2}, std::array<std::size_t, 3>{0, 2, 3}}) {
      const glm::dvec3& a = limit.points[v[t[0]]];
      const glm::dvec3& b = limit.points[v[t[1]]];
      const glm::dvec3& c = limit.points[v[t[2]]];
      limit.triangles.push_back({a, b, c});
      for (const std::size_t corner : t) {
        limit.areas[v[corner]] += glm::length(glm::cross(b - a, c - a)) / 6.0;
      }
    }
  }
  return limit;
}

struct Case {
  std::string name;
  MeshPointer mesh;
  std::vector<std::uint8_t> depths;
  SubdivisionSettings settings;
};

std::vector<std::uint8_t> all(const ControlMesh& mesh, std::uint8_t depth) {
  return std::vector<std::uint8_t>(mesh.face_count(), depth);
}

void expect_as_by_opensubdiv(const Case& at) {
  SCOPED_TRACE(at.name);
  IgnoreProgress nobody;
  const double diagonal = at.mesh->bounds().diagonal();
  const VertexLabels labels = legal_labels(*at.mesh, at.depths, at.settings, nobody).value().labels;
  const RefinedMesh refined = refine(*at.mesh, labels, at.settings, {}, nobody).value();
  const LimitDistance measured =
      measure_limit_distance(*at.mesh, labels, at.settings, refined, nobody).value();
  EXPECT_TRUE(measured.is_settled);
  // So much finer than the finest that linear triangles do.
  const int finest = *std::max_element(labels.begin(), labels.end());
  const int levels = finest + (at.mesh->face_count() << (2 * finest) > 100 ? 3 : 4);
  const Limit limit = limit_of(*at.mesh, levels, at.settings.corners);
  const Triangles limit_triangles(limit.triangles);

  // What the program writes as STL: triangles that follow each other face by face.
  const MeshPointer cut = triangulated(*to_control_mesh(refined));
  std::vector<Triangles::Corners> corners;
  std::vector<std::size_t> faces;
  std::size_t face = 0;
  for (std::size_t t = 0; t < cut->face_count(); ++t) {
    const auto v = cut->face(t);
    corners.push_back({cut->positions()[v[0]], cut->positions()[v[1]], cut->positions()[v[2]]});
    const auto has = [&](std::uint32_t vertex) {
      const auto of_face = refined.face(face);
      return vertex >= refined.vertex_count() ||
             std::find(of_face.begin(), of_face.end(), vertex) != of_face.end();
    };
    while (!has(v[0]) || !has(v[1]) || !has(v[2])) {
      ++face;
    }
    faces.push_back(face);
  }

  const Triangles triangles(corners);

  const double noise = 2e-7 * diagonal;
  Random random(5);
  std::uniform_real_distribution<double> chance(0.0, 1.0);
  double greatest = 0.0;
  double squares = 0.0;
  double area = 0.0;
  for (std::size_t i = 0; i < limit.points.size(); ++i) {
    const double distance = triangles.distance_to(limit.points[i]);
    greatest = std::max(greatest, distance);
    squares += limit.areas[i] * distance * distance;
    area += limit.areas[i];
  }
  EXPECT_LE(greatest, 1.01 * measured.from_limit.greatest + noise);
  EXPECT_GE(greatest, 0.8 * measured.from_limit.greatest - noise);
  // The pair that has the greatest distance is one: where the reference has no point so near.
  const DirectedDistance& from = measured.from_limit;
  EXPECT_LE(limit_triangles.distance_to(from.from), 0.02 * from.greatest + noise);
  EXPECT_NEAR(triangles.distance_to(from.from), from.greatest, noise);
  EXPECT_NEAR(glm::distance(from.from, from.to), from.greatest, noise);
  EXPECT_NEAR(std::sqrt(squares / area), measured.from_limit.root_mean_square,
              0.07 * measured.from_limit.root_mean_square + noise);

  // In every triangle the middles of parts * parts triangles, those that stand on their tips too.
  constexpr double kSamples = 12000.0;
  const auto parts = std::max<std::size_t>(
      3, static_cast<std::size_t>(std::sqrt(kSamples / static_cast<double>(faces.size()))));
  const double kept = kSamples / static_cast<double>(faces.size() * parts * parts);
  greatest = 0.0;
  squares = 0.0;
  area = 0.0;
  for (std::size_t t = 0; t < faces.size(); ++t) {
    if (chance(random) >= kept) {
      continue;
    }
    const auto& [a, b, c] = corners[t];
    const double of_triangle = glm::length(glm::cross(b - a, c - a));
    double mean = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < parts; ++i) {
      for (std::size_t j = 0; j < 2 * (parts - i) - 1; ++j) {
        const double third = j % 2 == 0 ? 1.0 / 3.0 : 2.0 / 3.0;
        const double u = (static_cast<double>(i) + third) / static_cast<double>(parts);
        const std::size_t before = j / 2;
        const double v = (static_cast<double>(before) + third) / static_cast<double>(parts);
        const double distance = limit_triangles.distance_to(a + u * (b - a) + v * (c - a));
        ASSERT_LE(distance, 1.06 * measured.of_faces[faces[t]] + 0.01 * measured.greatest() + noise)
            << "face " << faces[t];
        greatest = std::max(greatest, distance);
        mean += distance * distance;
        ++count;
      }
    }
    for (const glm::dvec3& corner : {a, b, c}) {
      greatest = std::max(greatest, limit_triangles.distance_to(corner));
    }
    squares += of_triangle * mean / static_cast<double>(count);
    area += of_triangle;
  }
  EXPECT_LE(greatest, 1.02 * measured.to_limit.greatest + noise);
  EXPECT_GE(greatest, 0.8 * measured.to_limit.greatest - noise);
  const DirectedDistance& to = measured.to_limit;
  EXPECT_LE(triangles.distance_to(to.from), noise);
  EXPECT_NEAR(limit_triangles.distance_to(to.from), to.greatest, 0.02 * to.greatest + noise);
  EXPECT_LE(limit_triangles.distance_to(to.to), 0.02 * to.greatest + noise);
  EXPECT_NEAR(std::sqrt(squares / area), measured.to_limit.root_mean_square,
              0.07 * measured.to_limit.root_mean_square + noise);
}

TEST(LimitDistanceReference, OfTheCubeAtEveryDepth) {
  for (const SurfacePoints points : {SurfacePoints::kLevel, SurfacePoints::kLimit}) {
    for (std::uint8_t depth = 0; depth < 2; ++depth) {
      expect_as_by_opensubdiv(
          {fmt::format("depth {}", depth), cube(), all(*cube(), depth), {.points = points}});
    }
  }
  expect_as_by_opensubdiv({"one face", cube(), {2, 0, 0, 0, 0, 0}, {}});
}

TEST(LimitDistanceReference, OfFacesThatAreNoQuads) {
  const MeshPointer prism = mixed_prism();
  expect_as_by_opensubdiv({"unpainted", prism, all(*prism, 0), {}});
  expect_as_by_opensubdiv({"painted", prism, all(*prism, 1), {}});
  std::vector<std::uint8_t> depths = all(*prism, 0);
  depths[0] = 1;
  expect_as_by_opensubdiv(
      {"where painted", prism, depths, {.non_quads = NonQuadRule::kWherePainted}});
}

TEST(LimitDistanceReference, OfBoundaries) {
  for (const CornerRule corners : {CornerRule::kSharp, CornerRule::kSmooth}) {
    const MeshPointer mesh = grid(4);
    expect_as_by_opensubdiv({"grid", mesh, all(*mesh, 0), {.corners = corners}});
    std::vector<std::uint8_t> depths = all(*mesh, 0);
    depths[5] = 2;
    expect_as_by_opensubdiv({"painted grid", mesh, depths, {.corners = corners}});
  }
  Random random(3);
  const MeshPointer holes = control_mesh(with_holes(torus_soup(7, 6), 4, random));
  expect_as_by_opensubdiv({"torus with holes", holes, all(*holes, 1), {}});
}

TEST(LimitDistanceReference, OfCreases) {
  std::size_t count = 0;
  for (const NamedShape& shape : creased_shapes()) {
    // OpenSubdiv's limits are approximations where a crease ends, and takes what is semi-sharp at
    // its last level for infinitely sharp.
    if (shape.name.find("dart") == std::string::npos && count++ % 3 == 0 &&
        (effort() >= 1.0 || count < 4)) {
      expect_as_by_opensubdiv({shape.name, shape.mesh, all(*shape.mesh, 1), {}});
    }
  }
  EXPECT_GT(count, 6u);
}

TEST(LimitDistanceReference, OfBundledMeshes) {
  for (const char* name : {"mixed", "torus_open"}) {
    if (effort() < 1.0 && std::string(name) != "mixed") {
      continue;
    }
    const MeshPointer mesh = load_bundled_mesh(name)->mesh;
    Random random(11);
    expect_as_by_opensubdiv({name, mesh, random_depths(*mesh, 0.3, 1, random), {}});
  }
}

/// Skipped where this machine has no corpus.
TEST(LimitDistanceReference, OfTheCorpus) {
  std::size_t count = 0;
  for (const auto& path : corpus_files(".obj")) {
    const auto imported = import_mesh(path);
    if (!imported || imported->mesh->face_count() > 300 || imported->mesh->face_count() < 8 ||
        path.string().find("opensubdiv") == std::string::npos) {
      continue;
    }
    if (count++ % 16 == 0) {
      const MeshPointer& mesh = imported->mesh;
      expect_as_by_opensubdiv({path.filename().string(), mesh, all(*mesh, 1), {}});
    }
  }
  if (count == 0) {
    GTEST_SKIP() << "no corpus of meshes: set LIMN_CORPUS or put one at ../shared/corpus";
  }
}

}  // namespace
}  // namespace limn::test
