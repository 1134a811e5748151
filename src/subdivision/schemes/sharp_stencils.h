#pragma once

#include <cstdint>

#include "limn/mesh/creases.h"
#include "subdivision/schemes/level_mesh.h"
#include "subdivision/sharpness.h"
#include "subdivision/vertex_rule.h"

// Internal to this folder: boundaries and creases, for schemes that split edges in the middle. In
// the next level edge e becomes 2 e, at the start of its first half-edge, and 2 e + 1; all other
// edges are smooth. Rules: DeRose, Kass & Truong 1998, as OpenSubdiv applies them to any scheme.
namespace limn {

/// Of the two halves of the edge of h, the one at its start, and the one at its end.
[[nodiscard]] inline std::uint32_t half_at_start(const LevelMesh& mesh, std::uint32_t h) noexcept {
  return 2 * mesh.edges[h] + (mesh.is_first(h) ? 0U : 1U);
}
[[nodiscard]] inline std::uint32_t half_at_end(const LevelMesh& mesh, std::uint32_t h) noexcept {
  return 2 * mesh.edges[h] + (mesh.is_first(h) ? 1U : 0U);
}

/// Sets the sharpness of the next level, which has so many vertices and edges; leaves it empty
/// where all has worn off.
void wear_off(const LevelMesh& from, std::size_t vertices, std::size_t edges, LevelMesh& to);

/// How much of the curve's midpoint the point on the edge of h takes; the rest is the scheme's own
/// rule.
[[nodiscard]] inline double sharp_share(const LevelMesh& from, const LevelMesh& to,
                                        std::uint32_t h) noexcept {
  if (from.twins[h] == kNone) {
    return 1.0;
  }
  if (from.edge_sharpness.empty()) {
    return 0.0;
  }
  const std::size_t e = from.edges[h];
  const float sharpness = from.edge_sharpness[e];
  if (!is_sharp(sharpness)) {
    return 0.0;
  }
  const bool is_gone = to.edge_sharpness.empty();
  return sharp_share_of_edge(sharpness, is_gone ? 0.0f : to.edge_sharpness[2 * e],
                             is_gone ? 0.0f : to.edge_sharpness[2 * e + 1]);
}

/// The rules of a vertex on a boundary or beside sharp edges: where it is held, and where along.
class SharpVertex {
 public:
  SharpVertex(const LevelMesh& from, const LevelMesh& to, CornerRule corners, std::uint32_t v);

  /// `smooth()` is the point by the scheme's own rule; it is asked only where it counts.
  template <class Smooth>
  [[nodiscard]] Point moved(const Smooth& smooth) const {
    Point point = weight_ * by_rule(rule_, now_, smooth);
    if (weight_ < 1.0) {
      point += (1.0 - weight_) * by_rule(child_rule_, child_, smooth);
    }
    return point;
  }

 private:
  struct Star {
    SharpEdges edges;
    std::uint32_t first = kNone;  ///< The neighbours that the first and last sharp edge lead to.
    std::uint32_t last = kNone;

    void add(std::size_t place, std::uint32_t neighbour, float sharpness) noexcept;
  };

  template <class Smooth>
  [[nodiscard]] Point by_rule(VertexRule rule, const Star& star, const Smooth& smooth) const {
    switch (rule) {
      case VertexRule::kCorner:
        return from_->points[v_];
      case VertexRule::kCrease:
        return 0.125 *
               (from_->points[star.first] + 6.0 * from_->points[v_] + from_->points[star.last]);
      case VertexRule::kSmooth:
        break;
    }
    return smooth();
  }

  const LevelMesh* from_;
  std::uint32_t v_;
  Star now_;
  Star child_;
  VertexRule rule_ = VertexRule::kSmooth;
  VertexRule child_rule_ = VertexRule::kSmooth;
  double weight_ = 1.0;
};

}  // namespace limn
