#include "subdivision/schemes/cut_fans.h"

namespace limn {
namespace {

/// Where the held curve that comes from vertex `from` goes on beyond vertex v; kNone where it ends:
/// at a sharp vertex, and where not exactly two held edges meet.
std::uint32_t beyond(const LevelMesh& mesh, CornerRule corners, std::uint32_t v,
                     std::uint32_t from) {
  std::uint32_t held = 0;
  std::uint32_t faces = 0;
  std::uint32_t on = kNone;
  const auto add = [&](std::uint32_t h, std::uint32_t neighbour) {
    if (is_held(mesh, h)) {
      ++held;
      on = neighbour == from ? on : neighbour;
    }
  };
  const std::uint32_t arriving = mesh.around(v, [&](std::uint32_t h) {
    ++faces;
    add(h, mesh.end(h));
  });
  if (arriving != kNone) {
    add(arriving, mesh.start(arriving));
  }
  const bool is_corner = arriving != kNone && faces == 1 && corners == CornerRule::kSharp;
  const bool is_sharp_vertex = !mesh.vertex_sharpness.empty() && is_sharp(mesh.vertex_sharpness[v]);
  return held == 2 && !is_corner && !is_sharp_vertex ? on : kNone;
}

}  // namespace

Point four_point_on_curve(const LevelMesh& mesh, CornerRule corners, std::uint32_t h) {
  const std::uint32_t a = mesh.start(h);
  const std::uint32_t b = mesh.end(h);
  const Point& at_a = mesh.points[a];
  const Point& at_b = mesh.points[b];
  const std::uint32_t before = beyond(mesh, corners, a, b);
  const std::uint32_t after = beyond(mesh, corners, b, a);
  return four_point(before == kNone ? 2.0 * at_a - at_b : mesh.points[before], at_a, at_b,
                    after == kNone ? 2.0 * at_b - at_a : mesh.points[after]);
}

}  // namespace limn
