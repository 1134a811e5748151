// The kernel against sums in double precision, place by place: errors in the direction of the
// normal by sampling triangles densely, the rest as it is defined.
#include "subdivision/bicubic_errors.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "subdivision/tensor_kernels.h"

namespace limn {
namespace {

using Grid = std::array<glm::dvec3, 16>;

constexpr std::uint8_t kNoCurves = 0;

/// Basis of the cubic B-spline and its derivatives at t in 0..1.
std::array<std::array<double, 4>, 3> basis(double t) {
  const double s = 1.0 - t;
  return {{{s * s * s / 6.0, (4.0 - 6.0 * t * t + 3.0 * t * t * t) / 6.0,
            (4.0 - 6.0 * s * s + 3.0 * s * s * s) / 6.0, t * t * t / 6.0},
           {-0.5 * s * s, 1.5 * t * t - 2.0 * t, 2.0 * s - 1.5 * s * s, 0.5 * t * t},
           {s, 3.0 * t - 2.0, 3.0 * s - 2.0, t}}};
}

glm::dvec3 derivative(const Grid& grid, double u, double v, std::size_t by_u, std::size_t by_v) {
  glm::dvec3 sum(0.0);
  for (std::size_t y = 0; y < 4; ++y) {
    for (std::size_t x = 0; x < 4; ++x) {
      sum += basis(u)[by_u][x] * basis(v)[by_v][y] * grid[4 * y + x];
    }
  }
  return sum;
}

/// How far the triangles of a unit quad in x^2 a / 2 + x y b + y^2 c / 2 are off it at the most.
double sampled_error(double a, double b, double c, bool cuts_up) {
  constexpr int kSteps = 96;
  const auto height = [&](double x, double y) {
    return 0.5 * a * x * x + b * x * y + 0.5 * c * y * y;
  };
  double greatest = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const double x = static_cast<double>(i) / kSteps;
      const double y = static_cast<double>(j) / kSteps;
      double plane = 0.0;
      if (cuts_up) {  // From (0, 0) to (1, 1).
        plane = x >= y ? height(1, 0) * (x - y) + height(1, 1) * y
                       : height(0, 1) * (y - x) + height(1, 1) * x;
      } else if (x + y <= 1.0) {
        plane = height(1, 0) * x + height(0, 1) * y;
      } else {
        plane = height(1, 0) * (1 - y) + height(0, 1) * (1 - x) + height(1, 1) * (x + y - 1);
      }
      greatest = std::max(greatest, std::abs(plane - height(x, y)));
    }
  }
  return greatest;
}

struct Errors {
  double outwards = 0.0;
  double within = 0.0;
  double turn = 0.0;
};

/// Of one bicubic, for vertices on the limit.
Errors plain_errors(const Grid& grid) {
  Errors errors;
  const auto normal_at = [&](double u, double v) {
    return glm::normalize(glm::cross(derivative(grid, u, v, 1, 0), derivative(grid, u, v, 0, 1)));
  };
  const glm::dvec3 middle = normal_at(0.5, 0.5);
  for (const double u : {0.0, 0.5, 1.0}) {
    for (const double v : {0.0, 0.5, 1.0}) {
      const glm::dvec3 n = normal_at(u, v);
      const glm::dvec3 uu = derivative(grid, u, v, 2, 0);
      const glm::dvec3 uv = derivative(grid, u, v, 1, 1);
      const glm::dvec3 vv = derivative(grid, u, v, 0, 2);
      const double up = glm::dot(derivative(grid, u, v, 1, 0), derivative(grid, u, v, 0, 1));
      const double size = std::pow(glm::length(derivative(grid, u, v, 1, 0)), 2) +
                          std::pow(glm::length(derivative(grid, u, v, 0, 1)), 2);
      const bool is_either = std::abs(up) < 0.1 * size;
      for (const bool cuts_up : {true, false}) {
        if (is_either || cuts_up == (up < 0.0)) {
          errors.outwards =
              std::max(errors.outwards,
                       sampled_error(glm::dot(uu, n), glm::dot(uv, n), glm::dot(vv, n), cuts_up));
        }
      }
      const auto beside = [&](const glm::dvec3& d) { return glm::length(d - n * glm::dot(d, n)); };
      errors.within = std::max(errors.within, (beside(uu) + beside(vv)) / 6.0 + beside(uv) / 4.0);
      errors.turn = std::max(errors.turn,
                             glm::dot(n, middle) > 0.0 ? glm::length(glm::cross(n, middle)) : 1.0);
    }
  }
  return errors;
}

void put(const Grid& grid, std::uint8_t curves, std::size_t lane, BicubicBatch& batch) {
  for (std::size_t i = 0; i < grid.size(); ++i) {
    batch.points[lane][i] = to_point(grid[i]);
  }
  batch.curves[lane] = curves;
}

/// Of one bicubic, which stands in all lanes.
Errors errors_of(const Grid& grid, bool at_level = false, std::uint8_t curves = kNoCurves) {
  BicubicBatch batch{};
  for (std::size_t lane = 0; lane < BicubicBatch::kMost; ++lane) {
    put(grid, curves, lane, batch);
  }
  BicubicErrors errors;
  bicubic_errors(batch, at_level, errors);
  for (std::size_t lane = 1; lane < BicubicBatch::kMost; ++lane) {
    EXPECT_EQ(errors.outwards[lane], errors.outwards[0]);
    EXPECT_EQ(errors.within[lane], errors.within[0]);
    EXPECT_EQ(errors.turn[lane], errors.turn[0]);
  }
  return {errors.outwards[0], errors.within[0], errors.turn[0]};
}

std::array<std::uint32_t, 3> bits_of(const BicubicErrors& errors, std::size_t lane) {
  return {std::bit_cast<std::uint32_t>(errors.outwards[lane]),
          std::bit_cast<std::uint32_t>(errors.within[lane]),
          std::bit_cast<std::uint32_t>(errors.turn[lane])};
}

/// Columns and rows 1 apart around the unit square.
Grid grid_of_places() {
  Grid grid;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const std::size_t row = i / 4;
    grid[i] = {static_cast<double>(i % 4) - 1.0, static_cast<double>(row) - 1.0, 0.0};
  }
  return grid;
}

/// The same, moved at random, far from the origin.
Grid random_grid(std::mt19937& random) {
  std::uniform_real_distribution<double> off(-0.25, 0.25);
  Grid grid = grid_of_places();
  for (glm::dvec3& point : grid) {
    point += glm::dvec3(1000.0 + off(random), -500.0 + off(random), 70.0 + 2.0 * off(random));
  }
  return grid;
}

/// x^2 a / 2 + y^2 c / 2 over the unit square.
Grid paraboloid(double a, double c) {
  Grid grid = grid_of_places();
  for (glm::dvec3& p : grid) {
    p.z = 0.5 * (a * (p.x * p.x - 1.0 / 3.0) + c * (p.y * p.y - 1.0 / 3.0));
  }
  return grid;
}

TEST(BicubicErrors, AreWhatDoublePrecisionGives) {
  std::mt19937 random(11);
  for (int i = 0; i < 200; ++i) {
    const Grid grid = random_grid(random);
    const Errors expected = plain_errors(grid);
    const Errors errors = errors_of(grid);
    EXPECT_NEAR(errors.outwards, expected.outwards, 2e-3 * expected.outwards) << i;
    EXPECT_NEAR(errors.within, expected.within, 1e-4 * expected.within) << i;
    EXPECT_NEAR(errors.turn, expected.turn, 1e-4) << i;
  }
}

TEST(BicubicErrors, OfEachLaneAreItsOwn) {
  std::mt19937 random(12);
  std::vector<Grid> grids;
  BicubicBatch batch{};
  for (std::size_t lane = 0; lane < BicubicBatch::kMost; ++lane) {
    grids.push_back(random_grid(random));
    put(grids.back(), static_cast<std::uint8_t>(2 * lane), lane, batch);
  }
  for (const bool at_level : {false, true}) {
    BicubicErrors together;
    bicubic_errors(batch, at_level, together);
    for (std::size_t lane = 0; lane < BicubicBatch::kMost; ++lane) {
      const Errors alone = errors_of(grids[lane], at_level, static_cast<std::uint8_t>(2 * lane));
      EXPECT_EQ(together.outwards[lane], static_cast<float>(alone.outwards)) << lane;
      EXPECT_EQ(together.within[lane], static_cast<float>(alone.within)) << lane;
      EXPECT_EQ(together.turn[lane], static_cast<float>(alone.turn)) << lane;
    }
  }
}

TEST(BicubicErrors, AreTheSameBitsOnEveryProcessor) {
  std::mt19937 random(13);
  for (int i = 0; i < 50; ++i) {
    BicubicBatch batch{};
    for (std::size_t lane = 0; lane < BicubicBatch::kMost; ++lane) {
      put(random_grid(random), static_cast<std::uint8_t>(random() % 16), lane, batch);
    }
    for (const bool at_level : {false, true}) {
      BicubicErrors baseline;
      BicubicErrors here;
      kBaselineKernels.bicubic_errors(batch, at_level, baseline);
      tensor_kernels().bicubic_errors(batch, at_level, here);
      for (std::size_t lane = 0; lane < BicubicBatch::kMost; ++lane) {
        EXPECT_EQ(bits_of(baseline, lane), bits_of(here, lane)) << i;
      }
    }
  }
}

TEST(BicubicErrors, OfAParaboloidAreAQuarterOfItsBendWhateverTheUnit) {
  // Chords along diagonals span sqrt(2), and bend by 2 / 8.
  for (const double unit : {1e-12, 1.0, 1e12}) {
    Grid grid = paraboloid(0.003, 0.003);
    for (glm::dvec3& point : grid) {
      point *= unit;
    }
    const Errors errors = errors_of(grid);
    EXPECT_NEAR(errors.outwards, 0.00075 * unit, 1e-6 * unit);
    EXPECT_NEAR(errors.within, 0.0, 2e-5 * unit);
    EXPECT_NEAR(errors.turn, 0.003 * std::sqrt(0.5), 1e-5);
    // Where subdivision puts them, corners stand off by a sixth of both.
    EXPECT_NEAR(errors_of(grid, true).outwards, 0.001 * unit, 1e-6 * unit);
  }
}

TEST(BicubicErrors, OfAPlaneAreWithinIt) {
  Grid grid = paraboloid(0.0, 0.0);
  for (glm::dvec3& point : grid) {
    point.x = 4.0 * point.x + 0.5 * point.x * point.x;
  }
  const Errors errors = errors_of(grid);
  EXPECT_EQ(errors.outwards, 0.0);
  EXPECT_NEAR(errors.within, 1.0 / 6.0, 1e-5);
  EXPECT_EQ(errors.turn, 0.0);
}

TEST(BicubicErrors, OfWhatIsAllInOnePointAreNone) {
  Grid grid;
  grid.fill({3.0, 4.0, 5.0});
  for (const bool at_level : {false, true}) {
    const Errors errors = errors_of(grid, at_level, 15);
    EXPECT_EQ(errors.outwards, 0.0);
    EXPECT_EQ(errors.within, 0.0);
    EXPECT_EQ(errors.turn, 1.0);
  }
}

TEST(BicubicErrors, AtACurveWhatBendsWithinTheSurfaceCounts) {
  // A plane, whose columns are parabolas that bend along x.
  Grid grid = paraboloid(0.0, 0.0);
  for (glm::dvec3& point : grid) {
    point.x += 0.001 * (point.y * point.y - 1.0 / 3.0);
  }
  EXPECT_EQ(errors_of(grid).outwards, 0.0);
  for (std::size_t side = 0; side < 4; ++side) {
    const auto curves = static_cast<std::uint8_t>(1U << side);
    const double bend = side % 2 == 0 ? 0.0 : 0.002;  // Rows are straight.
    EXPECT_NEAR(errors_of(grid, false, curves).outwards, bend / 8.0, 1e-6) << side;
    EXPECT_NEAR(errors_of(grid, true, curves).outwards, bend / 6.0, 1e-6) << side;
  }
}

}  // namespace
}  // namespace limn
