#pragma once

#include <cstdint>
#include <vector>

#include "mesh/edge_matching.h"

namespace limn::detail {

/// Faces of a soup on their way to a manifold.
struct WorkingFaces {
  std::vector<std::uint32_t> offsets{0};
  std::vector<std::uint32_t> vertices;
  std::vector<std::uint32_t> uvs;      ///< One per corner, or empty; goes wherever its corner goes.
  std::vector<std::uint32_t> sources;  ///< The soup's number of every face.
  std::size_t vertex_count = 0;

  [[nodiscard]] FaceArrays arrays() const noexcept { return {offsets, vertices, vertex_count}; }
};

[[nodiscard]] inline std::uint32_t next_corner(const FaceArrays& faces, std::uint32_t f,
                                               std::uint32_t c) {
  return c + 1 < faces.offsets[f + 1] ? c + 1 : faces.offsets[f];
}

[[nodiscard]] inline std::uint32_t previous_corner(const FaceArrays& faces, std::uint32_t f,
                                                   std::uint32_t c) {
  return c > faces.offsets[f] ? c - 1 : faces.offsets[f + 1] - 1;
}

}  // namespace limn::detail
