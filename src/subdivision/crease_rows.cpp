// Inside an edge a vertex has two sharp edges, so each row follows from the one before; at its two
// ends the other edges around the control vertex matter, and a VertexRing knows these.
#include "subdivision/crease_rows.h"

#include <algorithm>
#include <cmath>

#include "subdivision/ring_seed.h"
#include "subdivision/sharpness.h"

namespace limn {
namespace {

float child_of(const SharpnessSum& sum, float sharpness) {
  return chaikin_child(sharpness, sum.mean_besides(sharpness));
}

/// The sharpness of one edge at its end in all levels, its vertex's other edges considered.
class EndSharpness {
 public:
  void begin(const Cage& cage, std::uint32_t v, std::size_t edge) {
    seed_sharpness(ring_, cage, v);
    edge_ = edge;
    for (Point& point : ring_.edges()) {
      point = Point{};
    }
    for (Point& point : ring_.centroids()) {
      point = Point{};
    }
    ring_.centre() = Point{};
  }
  float next(CornerRule corners) {
    ring_.step(CreasingMethod::kChaikin, corners);
    return ring_.edge_sharpness()[edge_];
  }

 private:
  VertexRing ring_;
  std::size_t edge_ = 0;
};

}  // namespace

float SideSharpness::at(int level, std::ptrdiff_t i) const noexcept {
  if (rows_ == nullptr) {
    return uniform_ >= kInfiniteSharpness ? kInfiniteSharpness
                                          : std::max(uniform_ - static_cast<float>(level), 0.0f);
  }
  if (level > last_level_) {
    return 0.0f;
  }
  const std::ptrdiff_t edges = std::ptrdiff_t{1} << (level - first_level_);
  const std::ptrdiff_t all = std::ptrdiff_t{1} << level;
  const std::ptrdiff_t at = (is_reversed_ ? edges - 1 - i : i) + (is_second_ ? edges : 0);
  // Beyond the control edge a corner's ring sees to everything.
  return at < 0 || at >= all ? 0.0f : rows_[all - 1 + at];
}

void CreaseRows::build(const Cage& cage) {
  edges_.clear();
  sharpness_.clear();
  if (cage.creases->method != CreasingMethod::kChaikin || cage.creases->edge_sharpness.empty()) {
    return;
  }
  const FlatTopology& topology = *cage.topology;
  edges_.resize(topology.edge_corners.size());
  EndSharpness start;
  EndSharpness end;
  const float greatest = *std::ranges::max_element(
      cage.creases->edge_sharpness, {}, [](float s) { return is_semi_sharp(s) ? s : 0.0f; });
  // No average is sharper than its greatest part, so after so many levels all has worn off.
  const int last_level = static_cast<int>(std::ceil(greatest));
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const auto [corner, other] = topology.edge_corners[e];
    if (other == kNone || !is_semi_sharp(cage.edge_sharpness(e))) {
      continue;
    }
    edges_[e] = {static_cast<std::uint32_t>(sharpness_.size()), last_level};
    start.begin(cage, topology.corner_vertices[corner], topology.corner_ranks[corner]);
    end.begin(cage, topology.corner_vertices[other], topology.corner_ranks[other]);
    std::size_t row = sharpness_.size();
    sharpness_.push_back(cage.edge_sharpness(e));
    for (int level = 0; level < last_level; ++level) {
      const std::size_t edges = std::size_t{1} << level;
      const std::size_t next = sharpness_.size();
      sharpness_.resize(next + 2 * edges);
      for (std::size_t i = 0; i + 1 < edges; ++i) {
        SharpnessSum sum;
        sum.add(sharpness_[row + i]);
        sum.add(sharpness_[row + i + 1]);
        sharpness_[next + 2 * i + 1] = child_of(sum, sharpness_[row + i]);
        sharpness_[next + 2 * i + 2] = child_of(sum, sharpness_[row + i + 1]);
      }
      sharpness_[next] = start.next(cage.corners);
      sharpness_[next + 2 * edges - 1] = end.next(cage.corners);
      row = next;
    }
  }
}

SideSharpness CreaseRows::of_corner(const Cage& cage, std::uint32_t corner) const noexcept {
  const std::uint32_t edge = cage.topology->corner_edges[corner];
  if (edges_.empty() || edges_[edge].first == kNone) {
    return SideSharpness(cage.edge_sharpness(edge));
  }
  const SideSharpness side(sharpness_.data() + edges_[edge].first, edges_[edge].last_level);
  return cage.topology->edge_corners[edge][0] == corner ? side : side.reversed();
}

}  // namespace limn
