#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include <glm/vec3.hpp>

#include "limn/mesh/large_array.h"

// Internal to this folder.
namespace limn {

class Sweep;

/// The point of a triangle that is nearest to some point.
struct NearestPoint {
  double square = std::numeric_limits<double>::infinity();  ///< Of the distance.
  std::uint32_t triangle = 0xFFFFFFFFu;
  glm::dvec3 weights{0.0};  ///< Of the triangle's corners; they add up to 1.
};

/// Weights of the point of a triangle that is nearest to p (Ericson, Real-Time Collision Detection,
/// 2005, 5.1.5). A triangle without area is its longest side, or its point.
[[nodiscard]] glm::dvec3 nearest_weights(const glm::dvec3& p, const glm::dvec3& a,
                                         const glm::dvec3& b, const glm::dvec3& c) noexcept;

/// Computed with at the same time.
using FourFloats [[gnu::vector_size(16)]] = float;

/// Finds the nearest of many triangles: a hierarchy of boxes, each quartered until no more than
/// four triangles are left, in flat arrays without pointers. Some 60 bytes a triangle in single
/// precision. Scalar: float or double; distances are computed in double precision either way.
template <class Scalar>
class TriangleTree {
 public:
  using Vector = glm::vec<3, Scalar>;
  using Triangle = std::array<std::uint32_t, 3>;

  /// Sorts the triangles into the tree, in O(n log n), by several threads. Triangles keep their
  /// numbers in results. Incomplete where `sweep` is cancelled, and not to be asked then.
  void build(std::span<const Vector> points, std::span<const Triangle> triangles, Sweep& sweep);

  /// Replaces `best` where some triangle is nearer. What is in there at first, the nearest so far
  /// or a bound alone, saves looking further.
  void find_nearest(const glm::dvec3& p, NearestPoint& best) const;

  [[nodiscard]] bool empty() const noexcept { return corners_.empty(); }

 private:
  /// The boxes of a box's four parts, relative to `origin_` and a little too large: no rounding of
  /// a point makes it be farther from them than it is from what is inside.
  struct Parts {
    std::array<FourFloats, 3> low;
    std::array<FourFloats, 3> high;
  };

  [[nodiscard]] std::size_t begin_of(int halvings, std::size_t i) const noexcept {
    return (corners_.size() * i) >> halvings;
  }
  [[nodiscard]] static FourFloats squares_to(const Parts& parts,
                                             const std::array<FourFloats, 3>& at) noexcept;
  void sort(std::span<const Vector> points, std::span<const Triangle> triangles, Sweep& sweep);
  void make_boxes(Sweep& sweep);
  void look_in_leaf(std::size_t leaf, const glm::dvec3& p, NearestPoint& best) const;

  int levels_ = 0;  ///< Of quartering: 4^levels leaves.
  glm::dvec3 origin_{0.0};
  LargeArray<Parts> parts_;  ///< Level by level: those of box i have the numbers 4 i + 1 and on.
  LargeArray<std::array<Vector, 3>> corners_;  ///< Leaf by leaf.
  LargeArray<std::uint32_t> numbers_;          ///< Of the triangles, in the order of corners_.
};

extern template class TriangleTree<float>;
extern template class TriangleTree<double>;

}  // namespace limn
