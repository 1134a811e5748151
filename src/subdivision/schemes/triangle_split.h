#pragma once

#include <cstddef>
#include <cstdint>

#include "subdivision/schemes/level_mesh.h"

// Internal to this folder.
namespace limn {

[[nodiscard]] constexpr std::uint32_t next_in_triangle(std::uint32_t h) noexcept {
  return h % 3 == 2 ? h - 2 : h + 1;
}
[[nodiscard]] constexpr std::uint32_t previous_in_triangle(std::uint32_t h) noexcept {
  return h % 3 == 0 ? h + 2 : h - 1;
}

/// Every triangle becomes four. Vertices: the old ones, then one per edge. Triangle 4 f + i lies at
/// corner i of triangle f and starts with it, triangle 4 f + 3 in the middle. Edge e becomes 2 e at
/// the start of its first half-edge, and 2 e + 1.
[[nodiscard]] LevelFaces split_triangles(const LevelMesh& from);
void connect_split_triangles(const LevelMesh& from, LevelMesh& to);
[[nodiscard]] std::size_t split_triangle_vertices(const LevelMesh& from);

}  // namespace limn
