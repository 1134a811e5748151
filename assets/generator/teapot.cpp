// The patches are sampled strip by strip: a strip is a stack of closed rings of vertices, and
// neighbouring rings are joined by quads, so that patches share their vertices by construction. A
// ring of radius 0 is a pole: a single vertex. The triangles around it are joined two by two:
//
//        b---c---d                b---c---d
//         \  |  / \                \     / \      (pole, b, c) and (pole, c, d)
//          \ | /   \    ------>     \   /   \     become (pole, b, c, d)
//           pole---e                 pole---e
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "families.h"
#include "teapot_data.h"

namespace limn::generator {
namespace {

using glm::dvec3;
using Index = std::uint32_t;
using Ring = std::vector<dvec3>;

constexpr std::size_t kQuarter = 5;     // quads around a quarter of body and lid
constexpr std::size_t kHalfHandle = 4;  // quads around half of the handle
constexpr std::size_t kHalfSpout = 5;   // and of the spout

std::array<double, 4> bernstein(double t) {
  const double s = 1.0 - t;
  return {s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t};
}

template <class Point>
dvec3 bezier(const Point& point_at, double t) {
  const std::array<double, 4> weights = bernstein(t);
  dvec3 sum(0.0);
  for (std::size_t i = 0; i < 4; ++i) {
    sum += weights[i] * point_at(i);
  }
  return sum;
}

double fraction(std::size_t part, std::size_t of) {
  return static_cast<double>(part) / static_cast<double>(of);
}

/// One ring of a patch around the axis at parameter t along its profile, all four quarters,
/// counter-clockwise seen from above.
Ring ring_around_axis(std::span<const teapot::Row, 4> patch, double t) {
  const dvec3 row = bezier(
      [&](std::size_t i) { return dvec3(patch[i].radius, patch[i].tangent, patch[i].height); }, t);
  if (row.x == 0.0) {
    return {dvec3(0.0, 0.0, row.z)};
  }
  const std::array<dvec3, 4> arc = {dvec3(row.x, 0.0, row.z), dvec3(row.x, row.y, row.z),
                                    dvec3(row.y, row.x, row.z), dvec3(0.0, row.x, row.z)};
  Ring quarter;
  for (std::size_t i = 0; i < kQuarter; ++i) {
    quarter.push_back(bezier([&](std::size_t k) { return arc[k]; }, fraction(i, kQuarter)));
  }
  Ring ring;
  for (std::size_t turn = 0; turn < 4; ++turn) {
    for (dvec3& p : quarter) {
      ring.push_back(p);
      p = {-p.y, p.x, p.z};
    }
  }
  return ring;
}

/// One ring of handle or spout at parameter t of the patch that starts at arc `first`: over the far
/// side, which mirrors the published one, and back over that.
Ring ring_of_tube(std::span<const teapot::Arc> arcs, std::size_t first, double t,
                  std::size_t half) {
  std::array<dvec3, 4> arc;
  for (std::size_t k = 0; k < 4; ++k) {
    arc[k] = bezier([&](std::size_t i) { return arcs[first + i][k]; }, t);
  }
  Ring ring;
  for (std::size_t i = 0; i <= half; ++i) {
    const dvec3 p = bezier([&](std::size_t k) { return arc[k]; }, fraction(i, half));
    ring.emplace_back(p.x, -p.y, p.z);
  }
  ring.front().y = 0.0;
  ring.back().y = 0.0;
  for (std::size_t i = half - 1; i > 0; --i) {
    ring.emplace_back(ring[i].x, -ring[i].y, ring[i].z);
  }
  return ring;
}

/// Joins a stack of rings by quads. The side is outside from which the rings turn
/// counter-clockwise and are stacked downwards.
void add_strip(PolygonSoup& soup, const std::vector<Ring>& rings) {
  std::vector<Index> starts;
  for (const Ring& ring : rings) {
    starts.push_back(static_cast<Index>(soup.positions.size()));
    soup.positions.insert(soup.positions.end(), ring.begin(), ring.end());
  }
  for (std::size_t k = 0; k + 1 < rings.size(); ++k) {
    const Index upper = starts[k];
    const Index lower = starts[k + 1];
    if (rings[k].size() == 1) {
      const auto count = static_cast<Index>(rings[k + 1].size());
      for (Index i = 0; i < count; i += 2) {
        soup.add_face(std::array{upper, lower + i, lower + i + 1, lower + (i + 2) % count});
      }
    } else if (rings[k + 1].size() == 1) {
      const auto count = static_cast<Index>(rings[k].size());
      for (Index i = 0; i < count; i += 2) {
        soup.add_face(std::array{lower, upper + (i + 2) % count, upper + i + 1, upper + i});
      }
    } else {
      const auto count = static_cast<Index>(rings[k].size());
      for (Index i = 0; i < count; ++i) {
        const Index j = (i + 1) % count;
        soup.add_face(std::array{upper + i, lower + i, lower + j, upper + j});
      }
    }
  }
}

struct ProfilePart {
  std::span<const teapot::Row, 4> patch;
  std::size_t segments;
};

void add_profile(PolygonSoup& soup, std::span<const ProfilePart> parts) {
  std::vector<Ring> rings;
  for (const ProfilePart& part : parts) {
    for (std::size_t i = rings.empty() ? 0 : 1; i <= part.segments; ++i) {
      rings.push_back(ring_around_axis(part.patch, fraction(i, part.segments)));
    }
  }
  add_strip(soup, rings);
}

/// `reach` is the parameter at which the second patch ends.
void add_tube(PolygonSoup& soup, std::span<const teapot::Arc> arcs, std::size_t half,
              std::array<std::size_t, 2> segments, double reach) {
  std::vector<Ring> rings;
  for (std::size_t patch = 0; patch < 2; ++patch) {
    const double end = patch == 1 ? reach : 1.0;
    for (std::size_t i = patch; i <= segments[patch]; ++i) {
      rings.push_back(ring_of_tube(arcs, 3 * patch, end * fraction(i, segments[patch]), half));
    }
  }
  add_strip(soup, rings);
}

}  // namespace

PolygonSoup utah_teapot() {
  PolygonSoup soup;
  add_profile(soup,
              std::array{ProfilePart{teapot::kRim, 2}, ProfilePart{teapot::kUpperBody, 5},
                         ProfilePart{teapot::kLowerBody, 4}, ProfilePart{teapot::kBottom, 3}});
  add_profile(soup, std::array{ProfilePart{teapot::kKnob, 5}, ProfilePart{teapot::kLid, 5}});
  // The published handle ends on the body; a little longer it still meets a body that subdivision
  // has drawn in.
  add_tube(soup, teapot::kHandle, kHalfHandle, {7, 6}, 1.12);
  add_tube(soup, teapot::kSpout, kHalfSpout, {7, 4}, 1.0);

  // From -3 to 3.45 in x and 0 to 3.15 in z; z becomes the height.
  constexpr double kScale = 0.34;
  for (dvec3& p : soup.positions) {
    p = kScale * dvec3(p.x - 0.2, p.z - 1.575, -p.y);
  }
  return soup;
}

}  // namespace limn::generator
