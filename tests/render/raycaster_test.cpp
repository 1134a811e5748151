#include "support/raycaster.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace limn::test {
namespace {

/// Triangles and convex quads, scattered.
Polygons scattered(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  Polygons polygons;
  for (std::size_t f = 0; f < count; ++f) {
    const glm::dvec3 middle(unit(random), unit(random), unit(random));
    const glm::dvec3 a = 0.1 * glm::dvec3(unit(random), unit(random), unit(random));
    const glm::dvec3 b = 0.1 * glm::dvec3(unit(random), unit(random), unit(random));
    const auto first = static_cast<std::uint32_t>(polygons.positions.size());
    for (const glm::dvec3& corner : {a, b, -a, -b}) {
      polygons.positions.push_back(middle + corner);
    }
    const std::uint32_t sides = f % 2 == 0 ? 4 : 3;
    for (std::uint32_t i = 0; i < sides; ++i) {
      polygons.vertices.push_back(first + i);
    }
    polygons.offsets.push_back(static_cast<std::uint32_t>(polygons.vertices.size()));
  }
  return polygons;
}

/// Independent of the class: signed volumes of the ray with every edge, over every triangle.
std::optional<Raycaster::Hit> by_brute_force(const Polygons& p, const glm::dvec3& origin,
                                             const glm::dvec3& direction) {
  Raycaster::Hit best{0, INFINITY};
  for (std::uint32_t f = 0; f < p.face_count(); ++f) {
    for (std::uint32_t i = p.offsets[f] + 1; i + 1 < p.offsets[f + 1]; ++i) {
      const glm::dvec3 a = p.positions[p.vertices[p.offsets[f]]] - origin;
      const glm::dvec3 b = p.positions[p.vertices[i]] - origin;
      const glm::dvec3 c = p.positions[p.vertices[i + 1]] - origin;
      const double u = glm::dot(direction, glm::cross(b, c));
      const double v = glm::dot(direction, glm::cross(c, a));
      const double w = glm::dot(direction, glm::cross(a, b));
      if (!((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) || u + v + w == 0) {
        continue;
      }
      const glm::dvec3 at = (u * a + v * b + w * c) / (u + v + w);
      const double t = glm::dot(at, direction) / glm::dot(direction, direction);
      if (t >= 0 && t < best.distance) {
        best = {f, t};
      }
    }
  }
  return best.distance < INFINITY ? std::optional(best) : std::nullopt;
}

TEST(Raycaster, NearestHitIsThatOfBruteForce) {
  const Raycaster caster(scattered(500, 1));
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 origin = 2.0 * glm::dvec3(unit(random), unit(random), unit(random));
    const glm::dvec3 direction = glm::dvec3(unit(random), unit(random), unit(random)) - origin;
    const auto expected = by_brute_force(caster.polygons(), origin, direction);
    const auto found = caster.nearest(origin, direction);
    ASSERT_EQ(found.has_value(), expected.has_value());
    if (found) {
      ++hits;
      EXPECT_EQ(found->face, expected->face);
      EXPECT_NEAR(found->distance, expected->distance, 1e-9);
    }
  }
  EXPECT_GT(hits, 200);
}

TEST(Raycaster, RaysAlongAxesAndCommonEdgesHit) {
  // Two quads that meet at x = 0, in the plane z = 0.
  Polygons polygons;
  polygons.positions = {{-1, -1, 0}, {0, -1, 0}, {1, -1, 0}, {-1, 1, 0}, {0, 1, 0}, {1, 1, 0}};
  polygons.vertices = {0, 1, 4, 3, 1, 2, 5, 4};
  polygons.offsets = {0, 4, 8};
  const Raycaster caster(polygons);
  const auto on_edge = caster.nearest({0.0, 0.25, 3.0}, {0.0, 0.0, -1.0});
  ASSERT_TRUE(on_edge);
  EXPECT_EQ(on_edge->face, 0U);
  EXPECT_DOUBLE_EQ(on_edge->distance, 3.0);
  EXPECT_EQ(caster.nearest({0.5, 0.5, -1.0}, {0.0, 0.0, 1.0})->face, 1U);
  EXPECT_FALSE(caster.nearest({0.5, 0.5, 3.0}, {0.0, 0.0, 1.0}));
  EXPECT_FALSE(caster.nearest({2.5, 0.5, 3.0}, {0.0, 0.0, -1.0}));
  EXPECT_FALSE(Raycaster(Polygons{}).nearest({0, 0, 0}, {0, 0, 1}));
}

}  // namespace
}  // namespace limn::test
