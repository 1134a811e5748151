#pragma once

#include <cstddef>
#include <span>

#include "subdivision/sharpness.h"

// Internal to this folder: which rule a vertex follows, as OpenSubdiv's Sdc::Scheme decides it.
namespace limn {

enum class VertexRule { kSmooth, kCrease, kCorner };

/// The sharp ones of the edges around a vertex, by their places there: with the vertex's own
/// sharpness they decide its rule.
struct SharpEdges {
  std::size_t count = 0;
  std::size_t first = 0;
  std::size_t last = 0;

  /// Places are added in growing order.
  constexpr void add(std::size_t place, float sharpness) noexcept {
    if (is_sharp(sharpness)) {
      first = count == 0 ? place : first;
      last = place;
      ++count;
    }
  }
  [[nodiscard]] static constexpr SharpEdges among(std::span<const float> sharpness) noexcept {
    SharpEdges sharp;
    for (std::size_t i = 0; i < sharpness.size(); ++i) {
      sharp.add(i, sharpness[i]);
    }
    return sharp;
  }
  [[nodiscard]] constexpr VertexRule rule(float vertex_sharpness) const noexcept {
    if (is_sharp(vertex_sharpness) || count > 2) {
      return VertexRule::kCorner;
    }
    return count == 2 ? VertexRule::kCrease : VertexRule::kSmooth;
  }
};

/// The weight of a vertex's rule in a step; the rest has the rule of its child. `worn` has seen all
/// edges around and the vertex itself.
[[nodiscard]] constexpr double weight_of_rule(VertexRule rule, VertexRule child,
                                              const WornOff& worn) noexcept {
  return child == rule || rule == VertexRule::kSmooth ? 1.0 : static_cast<double>(worn.mean());
}

}  // namespace limn
