#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace limn {

/// Cuts polygons into triangles as mesh/triangulate.h says; keeps its memory from one to the next.
class EarClipper {
 public:
  using Triangle = std::array<std::uint32_t, 3>;  ///< Places in a face.

  /// The triangles of a face, until the next is cut; null where no cut stays inside, or it has more
  /// than 32 sides. A triangle stays.
  [[nodiscard]] const std::vector<Triangle>* clip(std::span<const glm::dvec3> points);

 private:
  [[nodiscard]] Triangle at(std::size_t i) const;
  [[nodiscard]] bool is_ear(const Triangle& triangle) const;
  [[nodiscard]] std::optional<std::size_t> best_ear(std::span<const glm::dvec3> points) const;

  std::vector<glm::dvec2> seen_;
  std::vector<std::uint32_t> left_;
  std::vector<Triangle> triangles_;
};

}  // namespace limn
