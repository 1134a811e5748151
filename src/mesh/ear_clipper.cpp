// Ears are clipped in the plane of the face, the one with the shortest diagonal first.
#include "mesh/ear_clipper.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace limn {
namespace {

constexpr std::size_t kMostSidesToClip = 32;

/// Twice the area vector of a polygon (Newell).
glm::dvec3 area_vector(std::span<const glm::dvec3> points) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 2; i < points.size(); ++i) {
    sum += glm::cross(points[i - 1] - points[0], points[i] - points[0]);
  }
  return sum;
}

/// The polygon seen against `normal`, from where it runs counter-clockwise.
void see_along(const glm::dvec3& normal, std::span<const glm::dvec3> points,
               std::vector<glm::dvec2>& seen) {
  const glm::dvec3 magnitude = glm::abs(normal);
  const glm::dvec3 aside = magnitude.x <= magnitude.y && magnitude.x <= magnitude.z
                               ? glm::dvec3(1.0, 0.0, 0.0)
                           : magnitude.y <= magnitude.z ? glm::dvec3(0.0, 1.0, 0.0)
                                                        : glm::dvec3(0.0, 0.0, 1.0);
  const glm::dvec3 right = glm::normalize(glm::cross(aside, normal));
  const glm::dvec3 up = glm::cross(normal, right);
  seen.clear();
  for (const glm::dvec3& point : points) {
    seen.emplace_back(glm::dot(point - points[0], right), glm::dot(point - points[0], up));
  }
}

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace

const std::vector<EarClipper::Triangle>* EarClipper::clip(std::span<const glm::dvec3> points) {
  triangles_.clear();
  if (points.size() == 3) {
    triangles_.push_back({0, 1, 2});
    return &triangles_;
  }
  if (points.size() > kMostSidesToClip) {
    return nullptr;
  }
  const glm::dvec3 area = area_vector(points);
  const double length = glm::length(area);
  if (!(length > 0.0) || !std::isfinite(length)) {
    return nullptr;
  }
  see_along(area / length, points, seen_);
  left_.resize(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    left_[i] = i;
  }
  while (left_.size() > 3) {
    const std::optional<std::size_t> ear = best_ear(points);
    if (!ear) {
      return nullptr;
    }
    triangles_.push_back(at(*ear));
    left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(*ear));
  }
  triangles_.push_back({left_[0], left_[1], left_[2]});
  return &triangles_;
}

EarClipper::Triangle EarClipper::at(std::size_t i) const {
  const std::size_t n = left_.size();
  return {left_[(i + n - 1) % n], left_[i], left_[(i + 1) % n]};
}

bool EarClipper::is_ear(const Triangle& t) const {
  const glm::dvec2& a = seen_[t[0]];
  const glm::dvec2& b = seen_[t[1]];
  const glm::dvec2& c = seen_[t[2]];
  if (turn(a, b, c) <= 0.0) {
    return false;
  }
  return std::ranges::none_of(left_, [&](std::uint32_t v) {
    return v != t[0] && v != t[1] && v != t[2] && turn(a, b, seen_[v]) >= 0.0 &&
           turn(b, c, seen_[v]) >= 0.0 && turn(c, a, seen_[v]) >= 0.0;
  });
}

/// In a quad both diagonals are ears of two corners; the first is taken.
std::optional<std::size_t> EarClipper::best_ear(std::span<const glm::dvec3> points) const {
  std::optional<std::size_t> best;
  double least = 0.0;
  for (std::size_t i = 0; i < left_.size(); ++i) {
    const Triangle t = at(i);
    const glm::dvec3 diagonal = points[t[2]] - points[t[0]];
    const double length = glm::dot(diagonal, diagonal);
    if ((!best || length < least) && is_ear(t)) {
      best = i;
      least = length;
    }
  }
  return best;
}

}  // namespace limn
