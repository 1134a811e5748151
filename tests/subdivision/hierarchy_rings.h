#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "subdivision/vertex_ring.h"
#include "support/opensubdiv_reference.h"

// Rings of vertices of OpenSubdiv's meshes.
namespace limn::test {

/// The ring of a vertex of one level, whose positions are given.
[[nodiscard]] VertexRing ring_at(const UniformHierarchy& hierarchy,
                                 const std::vector<glm::dvec3>& positions, int level,
                                 std::uint32_t vertex);

/// The sharp edges of a ring whose semi-sharp ones have worn off.
struct Feature {
  bool is_corner = false;
  std::size_t count = 0;
  std::size_t first = 0;
  std::size_t last = 0;

  explicit Feature(const VertexRing& ring);

  [[nodiscard]] bool is_smooth() const { return !is_corner && count == 0; }
  [[nodiscard]] bool is_dart() const { return !is_corner && count == 1; }
  [[nodiscard]] bool is_crease() const { return !is_corner && count == 2; }
  /// Where OpenSubdiv's masks are left eigenvectors of the step, so the same at all levels.
  [[nodiscard]] bool has_exact_normal_mask() const {
    return !is_corner && (count == 0 || (count == 2 && last - first <= 2));
  }
};

/// A vector of length 0 is at right angles to all others.
[[nodiscard]] double angle_between(const glm::dvec3& a, const glm::dvec3& b);

}  // namespace limn::test
