// The radius that fits best around a given centre is the mean distance from it, so only the centre
// is sought (variable projection), by Newton's method from the algebraic fit and from the middle of
// the points. Everything is computed for points moved and scaled to the unit ball, where neither
// the place nor the size of the mesh costs digits.
#include "limn/comparison/sphere_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace limn {
namespace {

/// Points about their mean, in the unit ball.
struct Normalised {
  glm::dvec3 mean{0.0};
  double scale = 0.0;
  std::vector<glm::dvec3> points;
};

Normalised normalised(std::span<const glm::dvec3> points) {
  Normalised result;
  // About some point first: the mean of large numbers would lose digits.
  const glm::dvec3 first = points.front();
  for (const glm::dvec3& p : points) {
    result.mean += (p - first) / static_cast<double>(points.size());
  }
  result.mean += first;
  result.points.reserve(points.size());
  for (const glm::dvec3& p : points) {
    result.points.push_back(p - result.mean);
    result.scale = std::max(result.scale, glm::length(result.points.back()));
  }
  for (glm::dvec3& p : result.points) {
    p /= result.scale;
  }
  return result;
}

/// The distances from a centre.
struct Distances {
  double radius = 0.0;   ///< Their mean.
  double squares = 0.0;  ///< The sum of squares of what they differ from it.
};

Distances distances(const std::vector<glm::dvec3>& points, const glm::dvec3& centre) {
  Distances result;
  for (const glm::dvec3& p : points) {
    result.radius += glm::distance(p, centre);
  }
  result.radius /= static_cast<double>(points.size());
  for (const glm::dvec3& p : points) {
    const double error = glm::distance(p, centre) - result.radius;
    result.squares += error * error;
  }
  return result;
}

bool is_positive(const glm::dmat3& m) {
  return m[0][0] > 0.0 && m[0][0] * m[1][1] > m[0][1] * m[1][0] && glm::determinant(m) > 0.0;
}

/// The sum of p p^T.
glm::dmat3 scatter(const std::vector<glm::dvec3>& points) {
  glm::dmat3 sum(0.0);
  for (const glm::dvec3& p : points) {
    sum += glm::outerProduct(p, p);
  }
  return sum;
}

/// The centre that minimises the sum of (|p|^2 - 2 c.p - k)^2; k, for points about their mean, is
/// the mean of |p|^2. The mean itself where that says nothing.
glm::dvec3 algebraic_centre(const std::vector<glm::dvec3>& points, const glm::dmat3& scattered) {
  double mean = 0.0;
  for (const glm::dvec3& p : points) {
    mean += glm::dot(p, p) / static_cast<double>(points.size());
  }
  glm::dvec3 right(0.0);
  for (const glm::dvec3& p : points) {
    right += 0.5 * (glm::dot(p, p) - mean) * p;
  }
  return is_positive(scattered) ? glm::inverse(scattered) * right : glm::dvec3(0.0);
}

/// First and second derivatives of half the sum of squares by the centre.
struct Slope {
  glm::dvec3 first{0.0};
  glm::dmat3 second{0.0};
};

Slope slope_at(const std::vector<glm::dvec3>& points, const glm::dvec3& centre, double radius) {
  Slope slope;
  glm::dvec3 mean(0.0);
  for (const glm::dvec3& p : points) {
    const double distance = glm::distance(p, centre);
    if (distance > 0.0) {
      const glm::dvec3 outwards = (p - centre) / distance;
      const double error = distance - radius;
      slope.first -= error * outwards;
      slope.second += error / distance * glm::dmat3(1.0) +
                      (1.0 - error / distance) * glm::outerProduct(outwards, outwards);
      mean += outwards;
    }
  }
  slope.second -= glm::outerProduct(mean, mean) / static_cast<double>(points.size());
  return slope;
}

/// Goes down from a centre to where no step leads further down, or the centre is that far off.
glm::dvec3 lowest_from(const std::vector<glm::dvec3>& points, glm::dvec3 centre, double farthest) {
  constexpr int kMostSteps = 100;
  constexpr double kStill = 1e-14;
  // Near the best centre the sum of squares is flat: what it rises there is rounding.
  constexpr double kRounding = 1.0 + 1e-13;
  Distances here = distances(points, centre);
  for (int i = 0; i < kMostSteps && glm::length(centre) <= farthest; ++i) {
    const Slope slope = slope_at(points, centre, here.radius);
    const double still = kStill * (1.0 + glm::length(centre));
    // Damped as far as it takes to go down.
    double damping = 0.0;
    glm::dvec3 step(0.0);
    Distances there;
    do {
      const glm::dmat3 damped = slope.second + damping * glm::dmat3(1.0);
      there.squares = std::numeric_limits<double>::infinity();
      if (is_positive(damped)) {
        step = -glm::inverse(damped) * slope.first;
        there = distances(points, centre + step);
      }
      damping = std::max(4.0 * damping, 1e-9 * static_cast<double>(points.size()));
    } while (
        !(there.squares <= kRounding * here.squares) &&
        (there.squares == std::numeric_limits<double>::infinity() || glm::length(step) > still));
    if (!(glm::length(step) > still)) {
      break;
    }
    centre += step;
    here = there;
  }
  return centre;
}

/// The normal of the plane that is nearest to all points, which goes through their mean: the
/// direction in which they are scattered least, by inverse iteration.
glm::dvec3 plane_normal(const glm::dmat3& scattered) {
  const double all = scattered[0][0] + scattered[1][1] + scattered[2][2];
  const glm::dmat3 inverse = glm::inverse(scattered + 1e-13 * all * glm::dmat3(1.0));
  glm::dvec3 normal = glm::normalize(glm::dvec3(1.0, 0.9, 0.8));
  for (int i = 0; i < 100; ++i) {
    normal = glm::normalize(inverse * normal);
  }
  return normal;
}

/// How far the points are from a plane through their mean.
struct Flatness {
  double farthest = 0.0;
  double squares = 0.0;
};

Flatness flatness(const std::vector<glm::dvec3>& points, const glm::dvec3& normal) {
  Flatness result;
  for (const glm::dvec3& p : points) {
    const double distance = glm::dot(normal, p);
    result.farthest = std::max(result.farthest, std::abs(distance));
    result.squares += distance * distance;
  }
  return result;
}

}  // namespace

std::optional<SphereFit> fit_sphere(std::span<const glm::dvec3> points) {
  // In sizes of the point set: what is flatter than the first is flat, and no centre is sought
  // farther away than the second.
  constexpr double kFlat = 1e-9;
  constexpr double kFarthest = 1e5;
  if (points.size() < 4) {
    return std::nullopt;
  }
  const Normalised all = normalised(points);
  double largest = 0.0;
  for (const glm::dvec3& p : points) {
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * largest / all.scale;
  if (!(all.scale > 0.0)) {
    return std::nullopt;
  }
  const glm::dmat3 scattered = scatter(all.points);
  const Flatness plane = flatness(all.points, plane_normal(scattered));
  if (!(plane.farthest > std::max(kFlat, rounding))) {
    return std::nullopt;
  }

  // There may be several valleys; a plane, at the far end of some, is no sphere.
  glm::dvec3 centre(0.0);
  Distances fitted{0.0, plane.squares};
  for (const glm::dvec3& start : {algebraic_centre(all.points, scattered), glm::dvec3(0.0)}) {
    const glm::dvec3 lowest = lowest_from(all.points, start, kFarthest);
    const Distances there = distances(all.points, lowest);
    if (glm::length(lowest) <= kFarthest && there.squares < fitted.squares) {
      centre = lowest;
      fitted = there;
    }
  }
  if (!(fitted.squares < plane.squares)) {
    return std::nullopt;
  }
  SphereFit fit{all.mean + all.scale * centre, all.scale * fitted.radius,
                std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest(),
                all.scale * std::sqrt(fitted.squares / static_cast<double>(points.size()))};
  for (const glm::dvec3& p : all.points) {
    const double error = all.scale * (glm::distance(p, centre) - fitted.radius);
    fit.least = std::min(fit.least, error);
    fit.greatest = std::max(fit.greatest, error);
  }
  return fit;
}

}  // namespace limn
