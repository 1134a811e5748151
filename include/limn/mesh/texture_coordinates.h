#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "limn/mesh/flat_topology.h"

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

/// Texture coordinates as a mesh in the texture plane, with the faces and corners of the control
/// mesh. Seams are boundaries, and a vertex has one point for every stretch of faces between two.
struct TextureSurface {
  FlatTopology topology;
  std::vector<glm::dvec3> points;       ///< u, v and 0, one per vertex of `topology`.
  std::vector<std::uint32_t> vertices;  ///< The control vertex of each vertex,
  std::vector<std::uint32_t> edges;     ///< and the control edge of each edge of `topology`.
};

/// `texture` is not empty and fits `control`. Takes linear time.
[[nodiscard]] TextureSurface make_texture_surface(const FlatTopology& control,
                                                  const TextureCoordinates& texture);

}  // namespace limn
