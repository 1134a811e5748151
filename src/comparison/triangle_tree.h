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

/// Finds the nearest of many triangles: a hierarchy of boxes that is halved until some four
/// triangles are left, in flat arrays without pointers. 48 bytes a triangle in single precision.
/// Scalar: float or double; distances are computed in double precision either way.
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
  struct Box {
    Vector low;
    Vector high;
  };

  [[nodiscard]] std::size_t begin_of(int level, std::size_t i) const noexcept {
    return (corners_.size() * i) >> level;
  }
  [[nodiscard]] static double square_to(const Box& box, const glm::dvec3& p) noexcept;
  void look_in_leaf(std::size_t leaf, const glm::dvec3& p, NearestPoint& best) const;

  int depth_ = 0;          ///< Leaves are the 2^depth boxes of this level.
  LargeArray<Box> boxes_;  ///< Level by level: children of box i are 2 i + 1 and 2 i + 2.
  LargeArray<std::array<Vector, 3>> corners_;  ///< Leaf by leaf.
  LargeArray<std::uint32_t> numbers_;          ///< Of the triangles, in the order of corners_.
};

extern template class TriangleTree<float>;
extern template class TriangleTree<double>;

}  // namespace limn
