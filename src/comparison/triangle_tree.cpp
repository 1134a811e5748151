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
constexpr int kMostLevels = 32;

struct Middle {
  glm::vec3 point;
  std::uint32_t number;
};

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
void TriangleTree<Scalar>::build(std::span<const Vector> points,
                                 std::span<const Triangle> triangles, Sweep& sweep) {
  const std::size_t n = triangles.size();
  LIMN_EXPECTS(n < 0xFFFFFFFFu);
  depth_ = 0;
  while ((n >> depth_) > kLeafSize) {
    ++depth_;
  }
  corners_.resize(n);
  numbers_.resize(n);
  boxes_.resize((std::size_t{2} << depth_) - 1);

  // Middles are rounded to float about a point of their own: how far that is off matters little.
  LargeArray<Middle> middles(n);
  const glm::dvec3 origin = n > 0 ? glm::dvec3(points[triangles[0][0]]) : glm::dvec3(0.0);
  sweep.each(n, [&](std::size_t i) {
    const Triangle& t = triangles[i];
    const glm::dvec3 sum =
        glm::dvec3(points[t[0]]) + glm::dvec3(points[t[1]]) + glm::dvec3(points[t[2]]);
    middles[i] = {glm::vec3(sum / 3.0 - origin), static_cast<std::uint32_t>(i)};
  });
  for (int level = 0; level < depth_; ++level) {
    const std::size_t count = std::size_t{1} << level;
    const std::size_t grain = std::max<std::size_t>(1, count >> 7);
    sweep.ranges(count, std::max<std::size_t>(grain, count >> 4), grain, n / count,
                 [&](std::size_t first, std::size_t last) {
                   for (std::size_t i = first; i < last; ++i) {
                     const std::size_t begin = begin_of(level, i);
                     const std::size_t end = begin_of(level, i + 1);
                     halve(std::span(middles).subspan(begin, end - begin),
                           begin_of(level + 1, 2 * i + 1) - begin);
                   }
                 });
  }
  const std::size_t leaves = std::size_t{1} << depth_;
  sweep.each(leaves, [&](std::size_t leaf) {
    Box box{Vector(std::numeric_limits<Scalar>::max()),
            Vector(std::numeric_limits<Scalar>::lowest())};
    for (std::size_t i = begin_of(depth_, leaf); i < begin_of(depth_, leaf + 1); ++i) {
      numbers_[i] = middles[i].number;
      const Triangle& t = triangles[numbers_[i]];
      corners_[i] = {points[t[0]], points[t[1]], points[t[2]]};
      for (const Vector& corner : corners_[i]) {
        box.low = glm::min(box.low, corner);
        box.high = glm::max(box.high, corner);
      }
    }
    boxes_[leaves - 1 + leaf] = box;
  });
  for (std::size_t i = leaves - 1; i-- > 0 && !sweep.is_cancelled();) {
    const Box& one = boxes_[2 * i + 1];
    const Box& other = boxes_[2 * i + 2];
    boxes_[i] = {glm::min(one.low, other.low), glm::max(one.high, other.high)};
  }
}

template <class Scalar>
double TriangleTree<Scalar>::square_to(const Box& box, const glm::dvec3& p) noexcept {
  const glm::dvec3 beyond =
      glm::max(glm::max(glm::dvec3(box.low) - p, p - glm::dvec3(box.high)), glm::dvec3(0.0));
  return glm::dot(beyond, beyond);
}

template <class Scalar>
void TriangleTree<Scalar>::look_in_leaf(std::size_t leaf, const glm::dvec3& p,
                                        NearestPoint& best) const {
  for (std::size_t i = begin_of(depth_, leaf); i < begin_of(depth_, leaf + 1); ++i) {
    const glm::dvec3 a(corners_[i][0]);
    const glm::dvec3 b(corners_[i][1]);
    const glm::dvec3 c(corners_[i][2]);
    const glm::dvec3 weights = nearest_weights(p, a, b, c);
    const glm::dvec3 offset = weights.x * a + weights.y * b + weights.z * c - p;
    if (const double square = glm::dot(offset, offset); square < best.square) {
      best = {square, numbers_[i], weights};
    }
  }
}

template <class Scalar>
void TriangleTree<Scalar>::find_nearest(const glm::dvec3& p, NearestPoint& best) const {
  struct Waiting {
    double square;
    std::size_t box;
  };
  if (corners_.empty()) {
    return;
  }
  std::array<Waiting, kMostLevels> waiting;
  std::size_t count = 0;
  const std::size_t first_leaf = (std::size_t{1} << depth_) - 1;
  Waiting next{square_to(boxes_[0], p), 0};
  while (true) {
    if (next.square < best.square) {
      if (next.box >= first_leaf) {
        look_in_leaf(next.box - first_leaf, p, best);
      } else {
        const std::size_t child = 2 * next.box + 1;
        Waiting near{square_to(boxes_[child], p), child};
        Waiting far{square_to(boxes_[child + 1], p), child + 1};
        if (far.square < near.square) {
          std::swap(near, far);
        }
        if (far.square < best.square) {
          waiting[count++] = far;
        }
        next = near;
        continue;
      }
    }
    if (count == 0) {
      return;
    }
    next = waiting[--count];
  }
}

template class TriangleTree<float>;
template class TriangleTree<double>;

}  // namespace limn
