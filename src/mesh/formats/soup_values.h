#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "limn/mesh/polygon_soup.h"

namespace limn::detail {

/// Adds a texture coordinate, or 0 0 and a count where it is no usable number.
inline void add_uv(PolygonSoup& soup, double u, double v) {
  constexpr double largest = 1e18;  // Refined ones are single precision.
  // Written so that what is not a number fails it too.
  const bool is_usable = std::abs(u) <= largest && std::abs(v) <= largest;
  soup.uvs.push_back(is_usable ? glm::dvec2(u, v) : glm::dvec2(0.0));
  soup.broken_uvs += is_usable ? 0 : 1;
}

/// Ends a face whose corners have been added. Offsets in files stay below 4 GiB.
inline void end_face(PolygonSoup& soup, std::size_t place) {
  soup.face_offsets.push_back(static_cast<std::uint32_t>(soup.face_vertices.size()));
  soup.face_places.push_back(static_cast<std::uint32_t>(place));
}

inline void add_vertex(PolygonSoup& soup, const glm::dvec3& position, std::size_t place) {
  soup.positions.push_back(position);
  soup.vertex_places.push_back(static_cast<std::uint32_t>(place));
}

}  // namespace limn::detail
