// Every box is halved at the median of its triangles' middles along its longest axis, so the tree
// is balanced, and where a box lies and which triangles it holds follows from its number:
//
//   level 0            0                 triangles 0 .. n
//   level 1      1           2           0 .. n/2, n/2 .. n
//   level 2    3   4       5   6         0 .. n/4, ...
#include "comparison/triangle_tree.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "limn/contract.h"
#include "subdivision/sweep.h"

namespace limn {
namespace {

constexpr std::size_t kLeafSize = 4;
constexpr int kMostLevels = 16;  ///< 4^16 leaves are more than there can be triangles.
/// Of the farthest coordinate: what rounding to float does to a box and to a point near it, twice
/// over; and of the square of a distance, what it does to the rest.
constexpr float kSlack = 4e-7f;
constexpr double kCertain = 1.0 + 1e-5;

struct Box {
  glm::vec3 low{std::numeric_limits<float>::max()};
  glm::vec3 high{std::numeric_limits<float>::lowest()};
};

struct Middle {
  glm::vec3 point;
  std::uint32_t number;
};

FourFloats all_of(float value) {
  return FourFloats{value, value, value, value};
}

/// Boxes whose square of the distance is not below this have nothing nearer.
float bound_of(const NearestPoint& best) {
  return static_cast<float>(best.square * kCertain);
}

std::size_t longest_axis(std::span<const Middle> middles) {
  glm::vec3 low = middles.front().point;
  glm::vec3 high = low;
  for (const Middle& middle : middles) {
    low = glm::min(low, middle.point);
    high = glm::max(high, middle.point);
  }
  const glm::vec3 size = high - low;
  return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

void halve(std::span<Middle> middles, std::size_t at) {
  if (middles.size() < 2) {
    return;
  }
  const auto axis = static_cast<int>(longest_axis(middles));
  // Ties go by number: the same tree from every standard library's order of equal elements.
  std::nth_element(middles.begin(), middles.begin() + static_cast<std::ptrdiff_t>(at),
                   middles.end(), [axis](const Middle& a, const Middle& b) {
                     return a.point[axis] != b.point[axis] ? a.point[axis] < b.point[axis]
                                                           : a.number < b.number;
                   });
}

/// Weights along the side from one corner to another.
double weight_along(const glm::dvec3& p, const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dvec3 side = to - from;
  const double square = glm::dot(side, side);
  return square > 0.0 ? std::clamp(glm::dot(p - from, side) / square, 0.0, 1.0) : 0.0;
}

glm::dvec3 nearest_on_sides(const glm::dvec3& p, const std::array<glm::dvec3, 3>& corners) {
  glm::dvec3 best(1.0, 0.0, 0.0);
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const auto from = static_cast<std::size_t>(i);
    const std::size_t to = (from + 1) % 3;
    const double share = weight_along(p, corners[from], corners[to]);
    const glm::dvec3 offset = corners[from] + share * (corners[to] - corners[from]) - p;
    if (const double square = glm::dot(offset, offset); square < least) {
      least = square;
      best = glm::dvec3(0.0);
      best[i] = 1.0 - share;
      best[static_cast<int>(to)] = share;
    }
  }
  return best;
}

}  // namespace

glm::dvec3 nearest_weights(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                           const glm::dvec3& c) noexcept {
  const glm::dvec3 ab = b - a;
  const glm::dvec3 ac = c - a;
  const glm::dvec3 ap = p - a;
  const double d1 = glm::dot(ab, ap);
  const double d2 = glm::dot(ac, ap);
  if (d1 <= 0.0 && d2 <= 0.0) {
    return {1.0, 0.0, 0.0};
  }
  const glm::dvec3 bp = p - b;
  const double d3 = glm::dot(ab, bp);
  const double d4 = glm::dot(ac, bp);
  if (d3 >= 0.0 && d4 <= d3) {
    return {0.0, 1.0, 0.0};
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 && d1 > d3) {
    const double v = d1 / (d1 - d3);
    return {1.0 - v, v, 0.0};
  }
  const glm::dvec3 cp = p - c;
  const double d5 = glm::dot(ab, cp);
  const double d6 = glm::dot(ac, cp);
  if (d6 >= 0.0 && d5 <= d6) {
    return {0.0, 0.0, 1.0};
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 && d2 > d6) {
    const double w = d2 / (d2 - d6);
    return {1.0 - w, 0.0, w};
  }
  const double va = d3 * d6 - d5 * d4;
  const double bc_from = d4 - d3;
  const double bc_to = d5 - d6;
  if (va <= 0.0 && bc_from >= 0.0 && bc_to >= 0.0 && bc_from + bc_to > 0.0) {
    const double w = bc_from / (bc_from + bc_to);
    return {0.0, 1.0 - w, w};
  }
  const double sum = va + vb + vc;
  if (!(sum > 0.0)) {
    return nearest_on_sides(p, {a, b, c});
  }
  return {1.0 - vb / sum - vc / sum, vb / sum, vc / sum};
}

template <class Scalar>
void TriangleTree<Scalar>::sort(std::span<const Vector> points, std::span<const Triangle> triangles,
                                Sweep& sweep) {
  const std::size_t n = triangles.size();
  // Middles are rounded to float: how far that puts them off matters little.
  LargeArray<Middle> middles(n);
  sweep.each(n, [&](std::size_t i) {
    const Triangle& t = triangles[i];
    const glm::dvec3 sum =
        glm::dvec3(points[t[0]]) + glm::dvec3(points[t[1]]) + glm::dvec3(points[t[2]]);
    middles[i] = {glm::vec3(sum / 3.0 - origin_), static_cast<std::uint32_t>(i)};
  });
  for (int halvings = 0; halvings < 2 * levels_; ++halvings) {
    const std::size_t count = std::size_t{1} << halvings;
    const std::size_t grain = std::max<std::size_t>(1, count >> 7);
    sweep.ranges(count, std::max<std::size_t>(grain, count >> 4), grain, n / count,
                 [&](std::size_t first, std::size_t last) {
                   for (std::size_t i = first; i < last; ++i) {
                     const std::size_t begin = begin_of(halvings, i);
                     const std::size_t end = begin_of(halvings, i + 1);
                     halve(std::span(middles).subspan(begin, end - begin),
                           begin_of(halvings + 1, 2 * i + 1) - begin);
                   }
                 });
  }
  sweep.each(n, [&](std::size_t i) {
    numbers_[i] = middles[i].number;
    const Triangle& t = triangles[numbers_[i]];
    corners_[i] = {points[t[0]], points[t[1]], points[t[2]]};
  });
}

template <class Scalar>
void TriangleTree<Scalar>::make_boxes(Sweep& sweep) {
  const std::size_t leaves = std::size_t{1} << (2 * levels_);
  LargeArray<Box> boxes(leaves);
  sweep.each(leaves, [&](std::size_t leaf) {
    Box box;
    for (std::size_t i = begin_of(2 * levels_, leaf); i < begin_of(2 * levels_, leaf + 1); ++i) {
      for (const Vector& corner : corners_[i]) {
        const glm::vec3 local(glm::dvec3(corner) - origin_);
        box.low = glm::min(box.low, local);
        box.high = glm::max(box.high, local);
      }
    }
    boxes[leaf] = box;
  });
  float reach = 0.0f;
  for (const Box& box : boxes) {
    for (int axis = 0; axis < 3; ++axis) {
      reach = std::max({reach, -box.low[axis], box.high[axis]});
    }
  }
  const float slack = kSlack * reach;
  std::size_t first = parts_.size();
  for (std::size_t count = leaves / 4; count > 0 && !sweep.is_cancelled(); count /= 4) {
    first -= count;
    for (std::size_t i = 0; i < count; ++i) {
      Parts& parts = parts_[first + i];
      Box whole;
      for (std::size_t part = 0; part < 4; ++part) {
        const Box& box = boxes[4 * i + part];
        whole.low = glm::min(whole.low, box.low);
        whole.high = glm::max(whole.high, box.high);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          parts.low[axis][part] = box.low[static_cast<int>(axis)] - slack;
          parts.high[axis][part] = box.high[static_cast<int>(axis)] + slack;
        }
      }
      boxes[i] = whole;
    }
  }
}

template <class Scalar>
void TriangleTree<Scalar>::build(std::span<const Vector> points,
                                 std::span<const Triangle> triangles, Sweep& sweep) {
  const std::size_t n = triangles.size();
  LIMN_EXPECTS(n < 0xFFFFFFFFu);
  levels_ = 0;
  while ((n >> (2 * levels_)) > kLeafSize) {
    ++levels_;
  }
  corners_.resize(n);
  numbers_.resize(n);
  parts_.resize(((std::size_t{1} << (2 * levels_)) - 1) / 3);
  if (n == 0) {
    return;
  }
  glm::dvec3 low(points[triangles[0][0]]);
  glm::dvec3 high = low;
  for (const Vector& point : points) {
    low = glm::min(low, glm::dvec3(point));
    high = glm::max(high, glm::dvec3(point));
  }
  origin_ = 0.5 * (low + high);
  sort(points, triangles, sweep);
  if (!sweep.is_cancelled()) {
    make_boxes(sweep);
  }
}

/// Most triangles are farther away than the best by their planes alone.
template <class Scalar>
void TriangleTree<Scalar>::look_in_leaf(std::size_t leaf, const glm::dvec3& p,
                                        NearestPoint& best) const {
  for (std::size_t i = begin_of(2 * levels_, leaf); i < begin_of(2 * levels_, leaf + 1); ++i) {
    const glm::dvec3 a(corners_[i][0]);
    const glm::dvec3 b(corners_[i][1]);
    const glm::dvec3 c(corners_[i][2]);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double height = glm::dot(normal, p - a);
    if (height * height >= best.square * glm::dot(normal, normal) && height != 0.0) {
      continue;
    }
    const glm::dvec3 weights = nearest_weights(p, a, b, c);
    const glm::dvec3 offset = weights.x * a + weights.y * b + weights.z * c - p;
    if (const double square = glm::dot(offset, offset); square < best.square) {
      best = {square, numbers_[i], weights};
    }
  }
}

template <class Scalar>
FourFloats TriangleTree<Scalar>::squares_to(const Parts& parts,
                                            const std::array<FourFloats, 3>& at) noexcept {
  FourFloats squares{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const FourFloats below = parts.low[axis] - at[axis];
    const FourFloats above = at[axis] - parts.high[axis];
    const FourFloats farther = below > above ? below : above;
    const FourFloats beyond = farther > 0.0f ? farther : FourFloats{};
    squares += beyond * beyond;
  }
  return squares;
}

template <class Scalar>
void TriangleTree<Scalar>::find_nearest(const glm::dvec3& p, NearestPoint& best) const {
  struct Waiting {
    float square;
    std::uint32_t box;
  };
  if (corners_.empty()) {
    return;
  }
  const auto first_leaf = static_cast<std::uint32_t>(parts_.size());
  const glm::vec3 local(p - origin_);
  const std::array<FourFloats, 3> at{all_of(local.x), all_of(local.y), all_of(local.z)};
  float bound = bound_of(best);
  std::array<Waiting, 3 * kMostLevels + 1> waiting;
  std::size_t count = 1;
  waiting[0] = {0.0f, 0};
  while (count > 0) {
    const Waiting next = waiting[--count];
    if (!(next.square < bound)) {
      continue;
    }
    if (next.box >= first_leaf) {
      look_in_leaf(next.box - first_leaf, p, best);
      bound = bound_of(best);
      continue;
    }
    const FourFloats squares = squares_to(parts_[next.box], at);
    // The nearest part is looked into first: it comes last.
    const std::size_t begin = count;
    for (std::uint32_t part = 0; part < 4; ++part) {
      if (!(squares[part] < bound)) {
        continue;
      }
      const Waiting candidate{squares[part], 4 * next.box + 1 + part};
      std::size_t place = count++;
      for (; place > begin && waiting[place - 1].square < candidate.square; --place) {
        waiting[place] = waiting[place - 1];
      }
      waiting[place] = candidate;
    }
  }
}

template class TriangleTree<float>;
template class TriangleTree<double>;

}  // namespace limn
