#include "subdivision/ring_seed.h"

#include "subdivision/sharpness.h"

namespace limn {
namespace {

/// Calls `visit(edge)` for the edges at v, in the order of its ring.
template <class Visit>
void for_each_edge_at(const Cage& cage, std::uint32_t v, const Visit& visit) {
  const Fan fan = fan_of(cage, v);
  for (const std::uint32_t corner : fan.corners) {
    visit(cage.topology->corner_edges[corner]);
  }
  if (fan.is_boundary) {
    visit(cage.topology->corner_edges[cage.previous(fan.corners.back())]);
  }
}

bool is_boundary_edge(const Cage& cage, std::uint32_t edge) {
  return cage.topology->edge_corners[edge][1] == kNone;
}

}  // namespace

float far_sharpness(const Cage& cage, std::uint32_t v, std::uint32_t edge) {
  SharpnessSum others;
  const auto [a, b] = cage.topology->edge_vertices[edge];
  for_each_edge_at(cage, a == v ? b : a, [&](std::uint32_t other) {
    if (!is_boundary_edge(cage, other)) {
      others.add(cage.edge_sharpness(other));
    }
  });
  return others.mean_besides(cage.edge_sharpness(edge));
}

void seed_sharpness(VertexRing& ring, const Cage& cage, std::uint32_t v) {
  const Fan fan = fan_of(cage, v);
  ring.reset(fan.corners.size(), fan.is_boundary);
  ring.vertex_sharpness() = fan.is_boundary && cage.averaging == Averaging::kPinned
                                ? kInfiniteSharpness
                                : cage.vertex_sharpness(v);
  if (cage.creases->edge_sharpness.empty()) {
    return;
  }
  std::size_t i = 0;
  for_each_edge_at(cage, v, [&](std::uint32_t edge) {
    if (!is_boundary_edge(cage, edge)) {
      ring.edge_sharpness()[i] = cage.edge_sharpness(edge);
      if (cage.creases->method == CreasingMethod::kChaikin &&
          is_semi_sharp(cage.edge_sharpness(edge))) {
        ring.far_sharpness()[i] = far_sharpness(cage, v, edge);
      }
    }
    ++i;
  });
}

}  // namespace limn
