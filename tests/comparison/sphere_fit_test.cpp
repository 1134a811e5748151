#include "limn/comparison/sphere_fit.h"

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "limn/mesh/bundled.h"
#include "limn/subdivision/schemes/uniform.h"
#include "support/shapes.h"

namespace limn::test {
namespace {

using Points = std::vector<glm::dvec3>;

glm::dvec3 random_direction(Random& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random);
  const double y = normal(random);
  const double z = normal(random);
  return glm::normalize(glm::dvec3(x, y, z));
}

/// Points on a sphere, moved in and out by up to `noise` radii.
Points noisy_sphere(std::size_t count, const glm::dvec3& centre, double radius, double noise,
                    Random& random) {
  std::uniform_real_distribution<double> shift(-noise, noise);
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 direction = random_direction(random);
    points.push_back(centre + radius * (1.0 + shift(random)) * direction);
  }
  return points;
}

/// What a fit is to make least.
double squares(const Points& points, const glm::dvec3& centre, double radius) {
  double sum = 0.0;
  for (const glm::dvec3& p : points) {
    const double error = glm::distance(p, centre) - radius;
    sum += error * error;
  }
  return sum;
}

/// Neither a little elsewhere nor with another radius is any better, and what the fit says of the
/// points is so.
void expect_best(const Points& points, const SphereFit& fit, Random& random) {
  const double best = squares(points, fit.centre, fit.radius);
  for (const double step : {1e-2, 1e-3, 1e-4}) {
    for (int i = 0; i < 20; ++i) {
      const glm::dvec3 centre = fit.centre + step * fit.radius * random_direction(random);
      const double radius = fit.radius * (1.0 + step * (i % 3 - 1));
      ASSERT_GT(squares(points, centre, radius), best) << "step " << step;
    }
  }
  double least = 1e300;
  double greatest = -1e300;
  for (const glm::dvec3& p : points) {
    least = std::min(least, glm::distance(p, fit.centre) - fit.radius);
    greatest = std::max(greatest, glm::distance(p, fit.centre) - fit.radius);
  }
  const double digits = 1e-12 * (fit.radius + glm::length(fit.centre));
  EXPECT_NEAR(fit.least, least, digits);
  EXPECT_NEAR(fit.greatest, greatest, digits);
  EXPECT_NEAR(fit.root_mean_square, std::sqrt(best / static_cast<double>(points.size())), digits);
}

/// The derivatives of the sum of squares by centre and radius, in radii and per point.
double slope(const Points& points, const SphereFit& fit) {
  glm::dvec3 by_centre(0.0);
  double by_radius = 0.0;
  for (const glm::dvec3& p : points) {
    const double distance = glm::distance(p, fit.centre);
    by_centre -= (distance - fit.radius) / distance * (p - fit.centre);
    by_radius -= distance - fit.radius;
  }
  return (glm::length(by_centre) + std::abs(by_radius)) /
         (fit.radius * static_cast<double>(points.size()));
}

TEST(SphereFit, FindsAnExactSphere) {
  Random random(1);
  for (const double radius : {1e-6, 1.0, 3e4}) {
    for (const std::size_t count : {4u, 5u, 8u, 200u}) {
      const glm::dvec3 centre = radius * 3.0 * random_direction(random);
      const auto fit = fit_sphere(noisy_sphere(count, centre, radius, 0.0, random));
      ASSERT_TRUE(fit);
      EXPECT_LT(glm::distance(fit->centre, centre), 1e-11 * radius);
      EXPECT_NEAR(fit->radius, radius, 1e-11 * radius);
      EXPECT_NEAR(fit->least, 0.0, 1e-11 * radius);
      EXPECT_NEAR(fit->greatest, 0.0, 1e-11 * radius);
      EXPECT_NEAR(fit->root_mean_square, 0.0, 1e-11 * radius);
    }
  }
}

TEST(SphereFit, IsBestForNoisyPoints) {
  Random random(2);
  for (int i = 0; i < 60; ++i) {
    const double noise = std::pow(10.0, -1 - i % 6) * 3.0;
    const Points points =
        noisy_sphere(6 + 5 * static_cast<std::size_t>(i), {1, -2, 0.5}, 2.5, noise, random);
    const auto fit = fit_sphere(points);
    ASSERT_TRUE(fit);
    EXPECT_LT(slope(points, *fit), 1e-11) << "noise " << noise;
    expect_best(points, *fit, random);
  }
}

/// The algebraic fit that it starts from is not the geometric one: points nearer one side count
/// differently.
TEST(SphereFit, MinimisesDistancesAndNotPowers) {
  const Points points{{2, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const auto fit = fit_sphere(points);
  ASSERT_TRUE(fit);
  EXPECT_LT(slope(points, *fit), 1e-12);
  // By symmetry both centres lie on the x-axis: found by a search along it.
  const auto best_x = [](const std::function<double(double)>& cost) {
    double best = 0.0;
    for (int i = -100000; i <= 100000; ++i) {
      best = cost(i * 1e-5) < cost(best) ? i * 1e-5 : best;
    }
    return best;
  };
  const double geometric = best_x([&](double x) {
    double mean = 0.0;
    for (const glm::dvec3& p : points) {
      mean += glm::distance(p, {x, 0, 0}) / 6.0;
    }
    return squares(points, {x, 0, 0}, mean);
  });
  const double algebraic = best_x([&](double x) {
    double mean = 0.0;
    double sum = 0.0;
    for (const glm::dvec3& p : points) {
      const double power = glm::dot(p - glm::dvec3(x, 0, 0), p - glm::dvec3(x, 0, 0));
      mean += power / 6.0;
      sum += power * power;
    }
    return sum - 6.0 * mean * mean;
  });
  EXPECT_NEAR(fit->centre.x, geometric, 2e-5);
  EXPECT_NEAR(fit->centre.y, 0.0, 1e-12);
  EXPECT_GT(std::abs(geometric - algebraic), 1e-3);
}

TEST(SphereFit, MovesAndScalesWithThePoints) {
  Random random(3);
  const Points points = noisy_sphere(80, {0, 0, 0}, 1.0, 0.05, random);
  const auto fit = fit_sphere(points);
  ASSERT_TRUE(fit);
  for (const double scale : {1e-5, 1.0, 1e5}) {
    for (const double far : {0.0, 1e3, 1e7}) {
      const glm::dvec3 shift = scale * far * glm::dvec3(0.6, -0.64, 0.48);
      Points moved;
      for (const glm::dvec3& p : points) {
        moved.push_back(scale * p + shift);
      }
      const auto there = fit_sphere(moved);
      ASSERT_TRUE(there) << scale << " " << far;
      // Coordinates so far away have no more digits than these.
      const double digits = scale * (1e-12 + 1e-15 * far);
      EXPECT_LT(glm::distance(there->centre, scale * fit->centre + shift), digits);
      EXPECT_NEAR(there->radius, scale * fit->radius, digits);
      EXPECT_NEAR(there->least, scale * fit->least, digits);
      EXPECT_NEAR(there->greatest, scale * fit->greatest, digits);
      EXPECT_NEAR(there->root_mean_square, scale * fit->root_mean_square, digits);
    }
  }
}

TEST(SphereFit, FindsTheSphereOfASmallCap) {
  Points points;
  for (int i = -5; i <= 5; ++i) {
    for (int j = -5; j <= 5; ++j) {
      const double x = 0.002 * i;
      const double y = 0.002 * j;
      points.emplace_back(x, y, std::sqrt(1.0 - x * x - y * y));
    }
  }
  const auto fit = fit_sphere(points);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->radius, 1.0, 1e-8);
  EXPECT_LT(glm::length(fit->centre), 1e-8);
}

TEST(SphereFit, FindsTheCircumsphereOfPlatonicSolids) {
  const auto cube_fit = fit_sphere(cube()->positions());
  ASSERT_TRUE(cube_fit);
  EXPECT_NEAR(cube_fit->radius, std::sqrt(3.0), 1e-14);
  EXPECT_NEAR(cube_fit->root_mean_square, 0.0, 1e-14);
  const auto icosahedron = load_bundled_mesh("icosahedron");
  ASSERT_TRUE(icosahedron);
  const auto icosahedron_fit = fit_sphere(icosahedron->mesh->positions());
  ASSERT_TRUE(icosahedron_fit);
  EXPECT_NEAR(icosahedron_fit->radius, 1.0, 1e-6);  // Six digits in the file.
}

TEST(SphereFit, IsNothingWherePointsDetermineNone) {
  EXPECT_FALSE(fit_sphere(Points{}));
  EXPECT_FALSE(fit_sphere(Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_FALSE(fit_sphere(Points(9, {3, 4, 5})));
  EXPECT_FALSE(fit_sphere(Points{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {5, 5, 5}}));
  // In a plane that is no coordinate plane, and far out.
  Random random(4);
  std::uniform_real_distribution<double> along(-1.0, 1.0);
  for (const double far : {0.0, 1.0, 1e6}) {
    Points points;
    for (int i = 0; i < 50; ++i) {
      const double u = along(random);
      const double v = along(random);
      points.push_back(u * glm::dvec3(1, 2, -0.7) + v * glm::dvec3(-0.3, 1, 1) +
                       far * glm::dvec3(0.1, 0.7, 0.3));
    }
    EXPECT_FALSE(fit_sphere(points)) << far;
  }
  // A saddle is nearer to a plane than to any sphere.
  Points saddle;
  for (int i = -4; i <= 4; ++i) {
    for (int j = -4; j <= 4; ++j) {
      saddle.emplace_back(i, j, 0.02 * (i * i - j * j));
    }
  }
  EXPECT_FALSE(fit_sphere(saddle));
}

/// Both have a middle plane that they are nearer to than to any sphere.
TEST(SphereFit, IsNothingWhereAPlaneIsNearer) {
  for (const char* name : {"creature", "torus_open"}) {
    EXPECT_FALSE(fit_sphere(load_bundled_mesh(name)->mesh->positions())) << name;
  }
}

/// In clouds of any shape it is not led away from a nearer sphere by a valley that ends in a plane.
TEST(SphereFit, IsNoFartherThanTheBestPlaneOrSphereInSight) {
  Random random(5);
  std::normal_distribution<double> normal;
  int fitted = 0;
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 spread(1.0, 0.4 + 0.006 * i, 0.3 + 0.007 * i);
    Points points;
    for (int j = 0; j < 40; ++j) {
      const glm::dvec3 direction = random_direction(random);
      points.push_back(spread * direction * (1.0 + 0.1 * normal(random)));
    }
    const auto fit = fit_sphere(points);
    if (!fit) {
      continue;
    }
    ++fitted;
    const double best = squares(points, fit->centre, fit->radius);
    for (int j = 0; j < 200; ++j) {
      const glm::dvec3 centre = 0.3 * std::abs(normal(random)) * random_direction(random);
      double mean = 0.0;
      for (const glm::dvec3& p : points) {
        mean += glm::distance(p, centre) / 40.0;
      }
      ASSERT_GE(squares(points, centre, mean), best) << i;
    }
  }
  EXPECT_GT(fitted, 60);
}

TEST(CompareWithSphere, HoldsEveryLevelAgainstItsOwnSphere) {
  const MeshPointer mesh = load_bundled_mesh("icosahedron")->mesh;
  for (const Scheme scheme : {Scheme::kLoop, Scheme::kCatmullClark, Scheme::kDooSabin}) {
    const SchemeSettings settings{.scheme = scheme};
    IgnoreProgress nobody;
    const auto rows = compare_with_sphere(*mesh, settings, 3, nobody);
    ASSERT_TRUE(rows) << rows.error().message;
    ASSERT_EQ(rows->size(), 4u);
    for (int level = 0; level <= 3; ++level) {
      const SphereComparison& row = (*rows)[static_cast<std::size_t>(level)];
      const RefinedMesh refined = subdivide(*mesh, settings, {.levels = level}, nobody).value();
      Points points;
      for (std::size_t v = 0; v < refined.vertex_count(); ++v) {
        points.push_back(refined.position(v));
      }
      const auto fit = fit_sphere(points);
      ASSERT_TRUE(fit);
      EXPECT_EQ(row.level, level);
      EXPECT_EQ(row.vertices, refined.vertex_count());
      EXPECT_EQ(row.faces, refined.face_count());
      EXPECT_EQ(row.vertices - row.edges + row.faces, 2u);
      EXPECT_NEAR(row.fit.radius, fit->radius, 1e-7);
      EXPECT_NEAR(row.fit.root_mean_square, fit->root_mean_square, 1e-7);
    }
  }
}

/// All vertices of an icosahedron are alike, so after one step its own are on one sphere and its
/// midpoints on another: worked out from the weights.
TEST(CompareWithSphere, FindsTheErrorsOfOneLoopStepOfTheIcosahedron) {
  const MeshPointer mesh = load_bundled_mesh("icosahedron")->mesh;
  IgnoreProgress nobody;
  const auto rows = compare_with_sphere(
      *mesh, {.scheme = Scheme::kLoop, .weights = LoopWeights::kWarren}, 1, nobody);
  ASSERT_TRUE(rows) << rows.error().message;
  const double old_vertex = 1.0 - 0.375 + 0.375 / std::sqrt(5.0);
  // Ends at an angle of acos(1 / sqrt 5); the vertices opposite lie on their bisector's plane.
  const double half = 0.5 * std::acos(1.0 / std::sqrt(5.0));
  const double opposite = 1.0 / std::sqrt(5.0) / std::cos(half);
  const double midpoint = 0.75 * std::cos(half) + 0.25 * opposite;
  const double radius = (12.0 * old_vertex + 30.0 * midpoint) / 42.0;
  const SphereFit& fit = (*rows)[1].fit;
  EXPECT_NEAR(fit.radius, radius, 1e-6);
  EXPECT_NEAR(fit.least, std::min(old_vertex, midpoint) - radius, 1e-6);
  EXPECT_NEAR(fit.greatest, std::max(old_vertex, midpoint) - radius, 1e-6);
}

TEST(CompareWithSphere, SaysWhyItCannot) {
  IgnoreProgress nobody;
  const auto unfit = compare_with_sphere(*cube(), {.scheme = Scheme::kLoop}, 1, nobody);
  ASSERT_FALSE(unfit);
  EXPECT_EQ(unfit.error().kind, ErrorKind::kFailed);
  const MeshPointer square =
      control_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
  const auto flat = compare_with_sphere(*square, {.scheme = Scheme::kLinear}, 1, nobody);
  ASSERT_FALSE(flat);
  EXPECT_THAT(flat.error().message, testing::HasSubstr("level 0"));

  class Cancel final : public Progress {
    bool report(double, std::string_view) override { return false; }
  } cancel;
  const auto cancelled = compare_with_sphere(*cube(), {.scheme = Scheme::kLinear}, 1, cancel);
  ASSERT_FALSE(cancelled);
  EXPECT_EQ(cancelled.error().kind, ErrorKind::kCancelled);
}

}  // namespace
}  // namespace limn::test
