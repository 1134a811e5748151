// The radius that fits best around a given centre is the mean distance from it, so only the centre
// is sought (variable projection). Everything is computed for points moved and scaled to the unit
// ball, where neither the place nor the size of the mesh costs digits, and by orthogonalisation
// rather than normal equations, since the points of a small cap say little of how deep its centre
// lies.
#include "limn/comparison/sphere_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

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

/// Half the distance between the two planes closest together that hold the points, about; along the
/// normal of the largest triangle that two of them make with the mean.
double thickness(const std::vector<glm::dvec3>& points) {
  const glm::dvec3 farthest =
      *std::ranges::max_element(points, {}, [](const glm::dvec3& p) { return glm::dot(p, p); });
  glm::dvec3 normal(0.0);
  for (const glm::dvec3& p : points) {
    const glm::dvec3 candidate = glm::cross(farthest, p);
    if (glm::dot(candidate, candidate) > glm::dot(normal, normal)) {
      normal = candidate;
    }
  }
  const double length = glm::length(normal);
  double most = 0.0;
  for (const glm::dvec3& p : points) {
    most = std::max(most, length > 0.0 ? std::abs(glm::dot(normal, p)) / length : 0.0);
  }
  return most;
}

/// An equation `row . x = right`.
struct Equation {
  glm::dvec3 row;
  double right;
};

/// The x that satisfies all of them best in the sense of least squares, by modified Gram-Schmidt.
/// Unknowns that they do not determine are 0.
glm::dvec3 solve(std::vector<Equation>& equations) {
  std::array<glm::dvec3, 3> upper{};
  std::array<double, 3> projected{};
  for (int k = 0; k < 3; ++k) {
    double squared = 0.0;
    glm::dvec3 products(0.0);
    double right = 0.0;
    for (const Equation& e : equations) {
      squared += e.row[k] * e.row[k];
      products += e.row[k] * e.row;
      right += e.row[k] * e.right;
    }
    const auto column = static_cast<std::size_t>(k);
    if (squared <= std::numeric_limits<double>::min()) {
      continue;
    }
    upper[column] = products / squared;
    projected[column] = right / squared;
    for (Equation& e : equations) {
      const double here = e.row[k];
      for (int j = k + 1; j < 3; ++j) {
        e.row[j] -= upper[column][j] * here;
      }
      e.right -= projected[column] * here;
    }
  }
  glm::dvec3 x(0.0);
  for (int k = 2; k >= 0; --k) {
    const auto column = static_cast<std::size_t>(k);
    x[k] = projected[column];
    for (int j = k + 1; j < 3; ++j) {
      x[k] -= upper[column][j] * x[j];
    }
  }
  return x;
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

/// The centre that minimises the sum of (|p|^2 - 2 c.p - k)^2; k, for points about their mean, is
/// the mean of |p|^2.
glm::dvec3 algebraic_centre(const std::vector<glm::dvec3>& points) {
  double mean = 0.0;
  for (const glm::dvec3& p : points) {
    mean += glm::dot(p, p) / static_cast<double>(points.size());
  }
  std::vector<Equation> equations;
  equations.reserve(points.size());
  for (const glm::dvec3& p : points) {
    equations.push_back({p, 0.5 * (glm::dot(p, p) - mean)});
  }
  return solve(equations);
}

/// Where Gauss and Newton would go from a centre.
glm::dvec3 geometric_step(const std::vector<glm::dvec3>& points, const glm::dvec3& centre,
                          double radius, std::vector<Equation>& equations) {
  equations.clear();
  glm::dvec3 mean(0.0);
  for (const glm::dvec3& p : points) {
    const double distance = glm::distance(p, centre);
    const glm::dvec3 direction = distance > 0.0 ? (p - centre) / distance : glm::dvec3(0.0);
    mean += direction / static_cast<double>(points.size());
    equations.push_back({direction, distance - radius});
  }
  for (Equation& e : equations) {
    e.row -= mean;
  }
  return solve(equations);
}

/// Goes down from the algebraic centre, halving steps that would lead up, until steps are rounding.
glm::dvec3 geometric_centre(const std::vector<glm::dvec3>& points, double farthest) {
  constexpr int kMostSteps = 200;
  constexpr double kStill = 1e-15;
  // Near the best centre the sum of squares is flat: what it rises there is rounding.
  constexpr double kRounding = 1.0 + 1e-13;
  glm::dvec3 centre = algebraic_centre(points);
  Distances here = distances(points, centre);
  std::vector<Equation> equations;
  equations.reserve(points.size());
  for (int i = 0; i < kMostSteps && glm::length(centre) <= farthest; ++i) {
    const double still = kStill * (1.0 + glm::length(centre));
    glm::dvec3 step = geometric_step(points, centre, here.radius, equations);
    Distances there = distances(points, centre + step);
    while (there.squares > kRounding * here.squares && glm::length(step) > still) {
      step *= 0.5;
      there = distances(points, centre + step);
    }
    if (!(glm::length(step) > still)) {
      break;
    }
    centre += step;
    here = there;
  }
  return centre;
}

}  // namespace

std::optional<SphereFit> fit_sphere(std::span<const glm::dvec3> points) {
  // In sizes of the point set: flatter than the first is flat, and a centre farther off than the
  // second says that a plane fits as well.
  constexpr double kFlat = 1e-9;
  constexpr double kFarthest = 1e6;
  if (points.size() < 4) {
    return std::nullopt;
  }
  const Normalised all = normalised(points);
  double largest = 0.0;
  for (const glm::dvec3& p : points) {
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * largest / all.scale;
  if (!(all.scale > 0.0) || !(thickness(all.points) > std::max(kFlat, rounding))) {
    return std::nullopt;
  }
  const glm::dvec3 centre = geometric_centre(all.points, kFarthest);
  if (!(glm::length(centre) <= kFarthest)) {
    return std::nullopt;
  }
  const Distances fitted = distances(all.points, centre);
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
