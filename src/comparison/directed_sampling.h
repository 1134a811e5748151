#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
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

/// What is looked at by one thread: some rows of the parts that one triangle is cut into, or all
/// rows of several triangles of one group.
struct Portion {
  std::uint32_t first_triangle = 0;
  std::uint32_t last_triangle = 0;  ///< Not of it.
  std::uint32_t first_row = 0;
  std::uint32_t last_row = 0;  ///< Not of it.
};

constexpr std::size_t kPartsInPortion = 128;
constexpr std::size_t kPointsInPortion = 256;

template <class Surface>
std::vector<Portion> portions_of(const Surface& surface) {
  std::vector<Portion> portions;
  const auto triangles = static_cast<std::uint32_t>(surface.triangle_count());
  std::size_t room = 0;  // For parts in the last portion.
  for (std::uint32_t t = 0; t < triangles; ++t) {
    const std::uint32_t parts = surface.parts(t);
    const std::size_t all = std::size_t{parts} * parts;
    if (all == 0) {
      room = 0;
    } else if (all > kPartsInPortion) {
      for (std::uint32_t row = 0; row < parts;) {
        const std::size_t in_row = 2 * std::size_t{parts - row} - 1;  // Rows grow shorter.
        const auto rows = static_cast<std::uint32_t>(
            std::clamp<std::size_t>(kPartsInPortion / in_row, 1, parts - row));
        portions.push_back({t, t + 1, row, row + rows});
        row += rows;
      }
      room = 0;
    } else {
      if (all > room || surface.group(t) != surface.group(t - 1)) {
        portions.push_back({t, t, 0, 0xFFFFFFFFu});
        room = kPartsInPortion;
      }
      portions.back().last_triangle = t + 1;
      room -= all;
    }
  }
  return portions;
}

/// Calls `body(weights, share)` for the points of the rule in the rows of the parts * parts
/// triangles that a triangle is cut into; the shares of all rows add up to 1.
template <class Body>
void for_each_point(std::uint32_t parts, const Portion& portion, const Body& body) {
  const double part = 1.0 / static_cast<double>(parts);
  for (std::uint32_t row = portion.first_row; row < std::min(portion.last_row, parts); ++row) {
    for (std::uint32_t column = 0; column < 2 * (parts - row) - 1; ++column) {
      const bool is_turned = column % 2 == 1;  // It stands on its tip.
      const std::uint32_t shift = is_turned ? 1 : 0;
      const std::uint32_t before = column / 2;
      const auto x = static_cast<double>(before + shift);
      const auto y = static_cast<double>(row + shift);
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

  void take(double distance, std::uint32_t triangle, const glm::dvec3& weights) noexcept {
    if (distance > greatest) {
      greatest = distance;
      place = {triangle, weights};
    }
  }
};

struct AtVertex {
  double distance = 0.0;
  std::uint32_t triangle = 0xFFFFFFFFu;
  bool is_looked_at = false;
};

/// At the vertices of triangles that are looked at.
template <class Surface, class Other>
std::vector<AtVertex> look_at_vertices(const Surface& surface, const Other& other, Sweep& sweep) {
  std::vector<AtVertex> vertices(surface.point_count());
  for (std::uint32_t t = 0; t < surface.triangle_count(); ++t) {
    if (surface.parts(t) > 0) {
      for (const std::uint32_t v : surface.corners(t)) {
        vertices[v].is_looked_at = true;
      }
    }
  }
  const std::size_t blocks = (vertices.size() + kPointsInPortion - 1) / kPointsInPortion;
  sweep.ranges(blocks, 128, 1, kPointsInPortion, [&](std::size_t first, std::size_t last) {
    for (std::size_t block = first; block < last; ++block) {
      std::uint32_t hint = 0xFFFFFFFFu;
      const std::size_t end = std::min(vertices.size(), (block + 1) * kPointsInPortion);
      for (std::size_t v = block * kPointsInPortion; v < end; ++v) {
        if (vertices[v].is_looked_at) {
          const NearestSurface there = other.nearest(surface.vertex(v), hint);
          hint = there.triangle;
          vertices[v].distance = there.distance;
          vertices[v].triangle = there.triangle;
        }
      }
    }
  });
  return vertices;
}

template <class Surface, class Other, class Found>
Tally tally(const Surface& surface, const Other& other, std::span<const AtVertex> vertices,
            const Portion& portion, const Found& found) {
  Tally result;
  std::uint32_t hint = 0xFFFFFFFFu;
  for (std::uint32_t t = portion.first_triangle; t < portion.last_triangle; ++t) {
    const double area = surface.area(t);
    for_each_point(surface.parts(t), portion, [&](const glm::dvec3& weights, double share) {
      const NearestSurface there = other.nearest(surface.point(t, weights), hint);
      hint = there.triangle;
      found(t, there.distance, there.triangle);
      result.take(there.distance, t, weights);
      result.area += area * share;
      result.squares += area * share * there.distance * there.distance;
      ++result.samples;
    });
    const std::array<std::uint32_t, 3> corners = surface.corners(t);
    for (int i = 0; i < 3; ++i) {
      glm::dvec3 corner(0.0);
      corner[i] = 1.0;
      const AtVertex& there = vertices[corners[static_cast<std::size_t>(i)]];
      found(t, there.distance, there.triangle);
      result.take(there.distance, t, corner);
    }
  }
  return result;
}

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

/// What was found of some triangles.
struct GroupDistance {
  double greatest = -1.0;
  double squares = 0.0;  ///< Of distances, times area.
  double area = 0.0;
  std::size_t samples = 0;
  glm::dvec3 from{0.0};
  glm::dvec3 to{0.0};
};

/// Measures from one surface to another.
///
/// `surface` has point_count(), vertex(i), triangle_count(), corners(t) (into its vertices),
/// point(t, weights), area(t), group(t), and parts(t): triangle t is looked at in parts(t)^2 parts,
/// 0: not at all. `other` has nearest(p, hint), the hint being a triangle that is likely near, and
/// can be asked by several threads. `found(t, distance, nearest)` is told of every sample in
/// triangle t and of the triangle that is nearest to it, by several threads. Adds to `groups`.
/// Unspecified where `sweep` is cancelled.
template <class Surface, class Other, class Found>
void measure_directed(const Surface& surface, const Other& other, const Found& found,
                      std::span<GroupDistance> groups, Sweep& sweep) {
  using sampling::Tally;
  if (sweep.is_cancelled()) {
    return;
  }
  const std::vector<sampling::AtVertex> vertices =
      sampling::look_at_vertices(surface, other, sweep);
  const std::vector<sampling::Portion> portions = sampling::portions_of(surface);
  std::vector<Tally> tallies(portions.size());
  sweep.ranges(tallies.size(), 64, 1, sampling::kPartsInPortion * 6,
               [&](std::size_t first, std::size_t last) {
                 for (std::size_t i = first; i < last; ++i) {
                   tallies[i] = sampling::tally(surface, other, vertices, portions[i], found);
                 }
               });
  if (sweep.is_cancelled()) {
    return;
  }
  const auto group_of = [&](const Tally& tally) -> GroupDistance& {
    return groups[surface.group(tally.place.triangle)];
  };
  for (const Tally& tally : tallies) {
    GroupDistance& group = group_of(tally);
    group.squares += tally.squares;
    group.area += tally.area;
    group.samples += tally.samples;
    group.greatest = std::max(group.greatest, tally.greatest);
  }

  // The highest samples are followed up, and of the others those that are a group's: in the order
  // of the triangles where they are equally high.
  constexpr std::size_t kPeaks = 64;
  std::erase_if(tallies, [&](const Tally& tally) {
    return groups.size() > 1 && tally.greatest < group_of(tally).greatest;
  });
  std::stable_sort(tallies.begin(), tallies.end(),
                   [](const Tally& a, const Tally& b) { return a.greatest > b.greatest; });
  if (groups.size() == 1) {
    tallies.resize(std::min(tallies.size(), kPeaks));
  }
  for (const Tally& tally : tallies) {
    group_of(tally).greatest = -1.0;
  }
  std::vector<NearestSurface> peaks(tallies.size());
  sweep.ranges(tallies.size(), 256, 1, 32, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      Tally& tally = tallies[i];
      if (i < kPeaks) {
        const double step = 0.5 / static_cast<double>(surface.parts(tally.place.triangle));
        tally.place = sampling::climb(surface, other, tally.place, tally.greatest, step);
      }
      peaks[i] =
          other.nearest(surface.point(tally.place.triangle, tally.place.weights), 0xFFFFFFFFu);
      found(tally.place.triangle, peaks[i].distance, peaks[i].triangle);
    }
  });
  for (std::size_t i = 0; i < tallies.size() && !sweep.is_cancelled(); ++i) {
    GroupDistance& group = group_of(tallies[i]);
    if (peaks[i].distance > group.greatest) {
      group.greatest = peaks[i].distance;
      group.from = surface.point(tallies[i].place.triangle, tallies[i].place.weights);
      group.to = peaks[i].point;
    }
  }
}

/// What the groups come to.
[[nodiscard]] inline DirectedDistance directed_distance(std::span<const GroupDistance> groups) {
  DirectedDistance result;
  double squares = 0.0;
  for (const GroupDistance& group : groups) {
    squares += group.squares;
    result.area += group.area;
    result.samples += group.samples;
    if (group.greatest > result.greatest) {
      result.greatest = group.greatest;
      result.from = group.from;
      result.to = group.to;
    }
  }
  result.root_mean_square = result.area > 0.0 ? std::sqrt(squares / result.area) : 0.0;
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
