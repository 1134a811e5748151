#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "limn/mesh/control_mesh.h"
#include "limn/mesh/refined_mesh.h"

namespace limn::test {

/// Polygons as arrays, whatever mesh they come from: face f has the corners
/// `vertices[offsets[f] .. offsets[f + 1])`.
struct Polygons {
  std::vector<glm::dvec3> positions;
  std::vector<std::uint32_t> offsets{0};
  std::vector<std::uint32_t> vertices;

  [[nodiscard]] std::size_t face_count() const noexcept { return offsets.size() - 1; }
};

[[nodiscard]] Polygons polygons_of(const ControlMesh& mesh);
[[nodiscard]] Polygons polygons_of(const RefinedMesh& mesh);

/// The nearest faces along rays, in double precision on the CPU: what picking is held against.
///
/// Polygons are cut into the fan from their first corner, as the renderer does. Faces are hit from
/// both sides. A triangle's edges belong to it, so that a ray along a common edge hits.
class Raycaster {
 public:
  explicit Raycaster(Polygons polygons);

  struct Hit {
    std::uint32_t face = 0;
    double distance = 0.0;  ///< In lengths of the ray's direction, >= 0.
  };
  /// The nearest hit at distance >= 0; of several at exactly the same the lowest face.
  [[nodiscard]] std::optional<Hit> nearest(const glm::dvec3& origin,
                                           const glm::dvec3& direction) const;

  [[nodiscard]] const Polygons& polygons() const noexcept { return polygons_; }

 private:
  struct Triangle {
    glm::dvec3 a;
    glm::dvec3 ab;
    glm::dvec3 ac;
    std::uint32_t face;
  };
  /// A leaf holds `count` triangles from `first` on; an inner node (`count` 0) has its children at
  /// its own index + 1 and at `first`.
  struct Node {
    glm::dvec3 low;
    glm::dvec3 high;
    std::uint32_t first;
    std::uint32_t count;
  };
  void build(std::uint32_t first, std::uint32_t count);

  Polygons polygons_;
  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
};

}  // namespace limn::test
