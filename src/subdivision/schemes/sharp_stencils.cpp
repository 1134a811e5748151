#include "subdivision/schemes/sharp_stencils.h"

#include <algorithm>
#include <vector>

namespace limn {
namespace {

/// What Chaikin's rule needs to know of every vertex.
std::vector<SharpnessSum> sums_at_vertices(const LevelMesh& mesh) {
  std::vector<SharpnessSum> sums(mesh.vertex_count());
  for (std::uint32_t h = 0; h < mesh.half_edge_count(); ++h) {
    if (mesh.is_first(h)) {
      sums[mesh.start(h)].add(mesh.sharpness(h));
      sums[mesh.end(h)].add(mesh.sharpness(h));
    }
  }
  return sums;
}

bool is_any_sharp(const LargeArray<float>& sharpness) {
  return std::ranges::any_of(sharpness, is_sharp);
}

void wear_off_edges(const LevelMesh& from, std::size_t edges, LevelMesh& to) {
  to.edge_sharpness.assign(edges, 0.0f);
  if (from.creasing == CreasingMethod::kUniform) {
    for (std::size_t e = 0; e < from.edge_count; ++e) {
      to.edge_sharpness[2 * e] = to.edge_sharpness[2 * e + 1] =
          one_level_less(from.edge_sharpness[e]);
    }
    return;
  }
  const std::vector<SharpnessSum> sums = sums_at_vertices(from);
  for (std::uint32_t h = 0; h < from.half_edge_count(); ++h) {
    if (from.is_first(h)) {
      const std::size_t e = from.edges[h];
      const float sharpness = from.edge_sharpness[e];
      to.edge_sharpness[2 * e] =
          chaikin_child(sharpness, sums[from.start(h)].mean_besides(sharpness));
      to.edge_sharpness[2 * e + 1] =
          chaikin_child(sharpness, sums[from.end(h)].mean_besides(sharpness));
    }
  }
}

}  // namespace

void wear_off(const LevelMesh& from, std::size_t vertices, std::size_t edges, LevelMesh& to) {
  to.creasing = from.creasing;
  if (!from.edge_sharpness.empty()) {
    wear_off_edges(from, edges, to);
    if (!is_any_sharp(to.edge_sharpness)) {
      to.edge_sharpness.clear();
    }
  }
  if (!from.vertex_sharpness.empty()) {
    to.vertex_sharpness.assign(vertices, 0.0f);
    std::ranges::transform(from.vertex_sharpness, to.vertex_sharpness.begin(), one_level_less);
    if (!is_any_sharp(to.vertex_sharpness)) {
      to.vertex_sharpness.clear();
    }
  }
}

void SharpVertex::Star::add(std::size_t place, std::uint32_t neighbour, float sharpness) noexcept {
  edges.add(place, sharpness);
  if (is_sharp(sharpness)) {
    first = edges.count == 1 ? neighbour : first;
    last = neighbour;
  }
}

SharpVertex::SharpVertex(const LevelMesh& from, const LevelMesh& to, CornerRule corners,
                         std::uint32_t v)
    : from_(&from), v_(v) {
  float own = from.vertex_sharpness.empty() ? 0.0f : from.vertex_sharpness[v];
  WornOff worn;
  std::size_t place = 0;
  const auto add = [&](std::uint32_t h, std::uint32_t neighbour, std::uint32_t half) {
    const float sharpness = from.sharpness(h);
    const bool is_boundary = from.twins[h] == kNone;
    const float child = is_boundary                 ? kInfiniteSharpness
                        : to.edge_sharpness.empty() ? 0.0f
                                                    : to.edge_sharpness[half];
    now_.add(place, neighbour, sharpness);
    child_.add(place, neighbour, child);
    worn.add(sharpness, child);
    ++place;
  };
  const std::uint32_t arriving =
      from.around(v, [&](std::uint32_t h) { add(h, from.end(h), half_at_start(from, h)); });
  if (arriving != kNone) {
    if (place == 1 && corners == CornerRule::kSharp) {
      own = kInfiniteSharpness;
    }
    add(arriving, from.start(arriving), half_at_end(from, arriving));
  }
  const float child_own = one_level_less(own);
  worn.add(own, child_own);
  rule_ = now_.edges.rule(own);
  child_rule_ = child_.edges.rule(child_own);
  weight_ = weight_of_rule(rule_, child_rule_, worn);
}

}  // namespace limn
