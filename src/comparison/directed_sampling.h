#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "comparison/triangle_tree.h"
#include "limn/comparison/directed_distance.h"
#include "subdivision/sweep.h"

// Internal to this folder.
namespace limn {

/// What lies nearest to a sample on the other surface.
struct NearestSurface {
  double distance = 0.0;
  glm::dvec3 point{0.0};
  std::uint32_t triangle = 0xFFFFFFFFu;
};

/// A point of a surface of triangles.
struct SurfacePlace {
  std::uint32_t triangle = 0;
  glm::dvec3 weights{0.0};
};

namespace sampling {

/// The rule of six points that integrates polynomials of degree 4 over a triangle exactly (Dunavant
/// 1985, doi 10.1002/nme.1620210612): the distance is quadratic where the surfaces run side by
/// side, and its square is summed up.
struct RulePoint {
  glm::dvec3 weights;
  double share;
};
[[nodiscard]] inline const std::array<RulePoint, 6>& rule() {
  constexpr double kA = 0.445948490915965;
  constexpr double kB = 0.091576213509771;
  constexpr double kShareA = 0.223381589678011;
  constexpr double kShareB = 1.0 / 3.0 - kShareA;
  static const std::array<RulePoint, 6> points{{{{kA, kA, 1.0 - 2.0 * kA}, kShareA},
                                                {{kA, 1.0 - 2.0 * kA, kA}, kShareA},
                                                {{1.0 - 2.0 * kA, kA, kA}, kShareA},
                                                {{kB, kB, 1.0 - 2.0 * kB}, kShareB},
                                                {{kB, 1.0 - 2.0 * kB, kB}, kShareB},
                                                {{1.0 - 2.0 * kB, kB, kB}, kShareB}}};
  return points;
}

/// Calls `body(weights, share)` for the points of the rule in each of the parts * parts triangles
/// that a triangle is cut into; the shares add up to 1.
template <class Body>
void for_each_point(std::uint32_t parts, const Body& body) {
  const double part = 1.0 / static_cast<double>(parts);
  for (std::uint32_t row = 0; row < parts; ++row) {
    for (std::uint32_t column = 0; column < 2 * (parts - row) - 1; ++column) {
      const bool is_turned = column % 2 == 1;  // It stands on its tip.
      const double x = static_cast<double>(column / 2 + (is_turned ? 1 : 0));
      const double y = static_cast<double>(row + (is_turned ? 1 : 0));
      for (const RulePoint& point : rule()) {
        const double u = part * (is_turned ? x - point.weights.x : x + point.weights.x);
        const double v = part * (is_turned ? y - point.weights.y : y + point.weights.y);
        body(glm::dvec3(u, v, 1.0 - u - v), point.share * part * part);
      }
    }
  }
}

/// What the samples of some triangles come to.
struct Tally {
  double squares = 0.0;  ///< Of distances, times area.
  double area = 0.0;
  std::size_t samples = 0;
  double greatest = -1.0;
  SurfacePlace place;  ///< Of the greatest.
};

constexpr std::size_t kTrianglesInTally = 64;
constexpr std::size_t kPointsInTally = 256;

/// Follows the distance up to its peak within the triangle, from a sample that stands `step` from
/// others.
template <class Surface, class Other>
SurfacePlace climb(const Surface& surface, const Other& other, SurfacePlace place, double greatest,
                   double step) {
  constexpr int kHalvings = 6;
  constexpr std::array<glm::dvec3, 6> kWays{{{1.0, -1.0, 0.0},
                                             {-1.0, 1.0, 0.0},
                                             {0.0, 1.0, -1.0},
                                             {0.0, -1.0, 1.0},
                                             {1.0, 0.0, -1.0},
                                             {-1.0, 0.0, 1.0}}};
  std::uint32_t hint = 0xFFFFFFFFu;
  int moves_left = 64;
  for (int i = 0; i < kHalvings; ++i, step *= 0.5) {
    bool has_moved = true;
    while (has_moved && moves_left-- > 0) {
      has_moved = false;
      const glm::dvec3 from = place.weights;
      for (const glm::dvec3& way : kWays) {
        const glm::dvec3 weights = from + step * way;
        if (weights.x < 0.0 || weights.y < 0.0 || weights.z < 0.0) {
          continue;
        }
        const NearestSurface there = other.nearest(surface.point(place.triangle, weights), hint);
        hint = there.triangle;
        if (there.distance > greatest) {
          greatest = there.distance;
          place.weights = weights;
          has_moved = true;
        }
      }
    }
  }
  return place;
}

}  // namespace sampling

/// Measures from one surface to another.
///
/// `surface` has point_count(), vertex(i), triangle_count(), corners(t) (into its vertices),
/// point(t, weights), area(t) and parts(t): triangle t is looked at in parts(t)^2 parts. `other`
/// has nearest(p, hint), the hint being a triangle that is likely near, and can be asked by several
/// threads. `found(t, nearest)` is told of every sample in triangle t, or at vertices, which come
/// first, `found_vertex(v, nearest)`: from several threads. Unspecified where `sweep` is cancelled.
template <class Surface, class Other, class FoundVertex, class Found>
DirectedDistance measure_directed(const Surface& surface, const Other& other,
                                  const FoundVertex& found_vertex, const Found& found,
                                  Sweep& sweep) {
  using sampling::Tally;
  DirectedDistance result;
  result.greatest = -1.0;
  const auto take_greatest = [&result](const glm::dvec3& from, const NearestSurface& to) {
    if (to.distance > result.greatest) {
      result.greatest = to.distance;
      result.from = from;
      result.to = to.point;
    }
  };

  constexpr std::size_t kPoints = sampling::kPointsInTally;
  const std::size_t points = surface.point_count();
  std::vector<Tally> of_points((points + kPoints - 1) / kPoints);
  sweep.ranges(of_points.size(), 128, 1, kPoints, [&](std::size_t first, std::size_t last) {
    for (std::size_t b = first; b < last; ++b) {
      std::uint32_t hint = 0xFFFFFFFFu;
      Tally& tally = of_points[b];
      for (std::size_t v = b * kPoints; v < std::min(points, (b + 1) * kPoints); ++v) {
        const NearestSurface there = other.nearest(surface.vertex(v), hint);
        hint = there.triangle;
        found_vertex(v, there);
        if (there.distance > tally.greatest) {
          tally.greatest = there.distance;
          tally.place.triangle = static_cast<std::uint32_t>(v);
        }
      }
    }
  });

  constexpr std::size_t kTriangles = sampling::kTrianglesInTally;
  const std::size_t triangles = surface.triangle_count();
  std::vector<Tally> tallies((triangles + kTriangles - 1) / kTriangles);
  sweep.ranges(tallies.size(), 64, 1, kTriangles, [&](std::size_t first, std::size_t last) {
    for (std::size_t b = first; b < last; ++b) {
      std::uint32_t hint = 0xFFFFFFFFu;
      Tally& tally = tallies[b];
      const std::size_t end = std::min(triangles, (b + 1) * kTriangles);
      for (auto t = static_cast<std::uint32_t>(b * kTriangles); t < end; ++t) {
        const double area = surface.area(t);
        tally.area += area;
        sampling::for_each_point(surface.parts(t), [&](const glm::dvec3& weights, double share) {
          const NearestSurface there = other.nearest(surface.point(t, weights), hint);
          hint = there.triangle;
          found(t, there);
          tally.squares += area * share * there.distance * there.distance;
          ++tally.samples;
          if (there.distance > tally.greatest) {
            tally.greatest = there.distance;
            tally.place = {t, weights};
          }
        });
      }
    }
  });
  if (sweep.is_cancelled() || tallies.empty()) {
    return {};
  }

  double squares = 0.0;
  for (const Tally& tally : tallies) {
    squares += tally.squares;
    result.area += tally.area;
    result.samples += tally.samples;
  }
  result.samples += points;
  result.root_mean_square = result.area > 0.0 ? std::sqrt(squares / result.area) : 0.0;

  // The highest samples first; where they are equally high, in the order of the triangles.
  constexpr std::size_t kPeaks = 64;
  const auto by_height = [](const Tally& a, const Tally& b) { return a.greatest > b.greatest; };
  const Tally& highest_point = *std::min_element(of_points.begin(), of_points.end(), by_height);
  const glm::dvec3 farthest = surface.vertex(highest_point.place.triangle);
  take_greatest(farthest, other.nearest(farthest, 0xFFFFFFFFu));
  std::stable_sort(tallies.begin(), tallies.end(), by_height);
  tallies.resize(std::min(tallies.size(), kPeaks));
  std::vector<NearestSurface> peaks(tallies.size());
  std::vector<glm::dvec3> tops(tallies.size());
  sweep.ranges(tallies.size(), 16, 1, 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const Tally& tally = tallies[i];
      const double step = 0.5 / static_cast<double>(surface.parts(tally.place.triangle));
      const SurfacePlace top = sampling::climb(surface, other, tally.place, tally.greatest, step);
      tops[i] = surface.point(top.triangle, top.weights);
      peaks[i] = other.nearest(tops[i], 0xFFFFFFFFu);
      found(top.triangle, peaks[i]);
    }
  });
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    take_greatest(tops[i], peaks[i]);
  }
  return result;
}

/// Whether both say the same but for `change`, and for differences that mean nothing.
[[nodiscard]] inline bool has_settled(const DirectedDistance& before, const DirectedDistance& now,
                                      double change, double nothing) {
  const auto is_close = [&](double a, double b) {
    return std::abs(a - b) <= std::max(change * b, nothing);
  };
  return is_close(before.greatest, now.greatest) &&
         is_close(before.root_mean_square, now.root_mean_square);
}

}  // namespace limn
