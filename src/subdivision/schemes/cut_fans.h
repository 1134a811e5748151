#pragma once

#include <cstdint>

#include "subdivision/schemes/level_mesh.h"
#include "subdivision/sharpness.h"

// Internal to this folder: boundaries and creases for the interpolating schemes. Along them runs
// the four-point curve (Dyn, Levin & Gregory 1987), and stencils end there: what lies beyond
// mirrors what lies within.
namespace limn {

/// Whether the edge of h holds the four-point curve.
[[nodiscard]] inline bool is_held(const LevelMesh& mesh, std::uint32_t h) noexcept {
  return is_sharp(mesh.sharpness(h));
}

/// The half-edge on the other side, kNone where stencils end.
[[nodiscard]] inline std::uint32_t across(const LevelMesh& mesh, std::uint32_t h) noexcept {
  return is_held(mesh, h) ? kNone : mesh.twins[h];
}

/// Whether all edges at vertex v are free, and how many there are.
struct FreeFan {
  bool is_whole = false;
  std::uint32_t edges = 0;
};
[[nodiscard]] inline FreeFan free_fan(const LevelMesh& mesh, std::uint32_t v) {
  FreeFan fan{true, 0};
  const std::uint32_t arriving = mesh.around(v, [&](std::uint32_t h) {
    fan.is_whole = fan.is_whole && !is_held(mesh, h);
    ++fan.edges;
  });
  fan.is_whole = fan.is_whole && arriving == kNone;
  return fan;
}

/// The point of the four-point curve on the held edge of h.
[[nodiscard]] Point four_point_on_curve(const LevelMesh& mesh, CornerRule corners, std::uint32_t h);

/// (-1 9 9 -1) / 16.
[[nodiscard]] inline Point four_point(const Point& before, const Point& a, const Point& b,
                                      const Point& after) noexcept {
  return (9.0 * (a + b) - (before + after)) / 16.0;
}

}  // namespace limn
