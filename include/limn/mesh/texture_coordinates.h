#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace limn {

/// Face-varying texture coordinates (UVs) of a control mesh: corners that share an index share a
/// point of the texture plane; an edge whose two faces name different indices is a seam.
struct TextureCoordinates {
  std::vector<glm::dvec2> values;
  std::vector<std::uint32_t> corner_values;  ///< One index per corner of FlatTopology, or empty:
                                             ///< the mesh has no texture coordinates.

  [[nodiscard]] bool empty() const noexcept { return corner_values.empty(); }
  [[nodiscard]] bool operator==(const TextureCoordinates&) const = default;
};

}  // namespace limn
