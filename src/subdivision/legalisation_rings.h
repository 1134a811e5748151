#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "limn/mesh/control_mesh.h"
#include "limn/mesh/large_array.h"
#include "limn/subdivision/labels.h"

// Internal to this folder.
namespace limn {

/// One edge of a vertex and the quad that follows it.
struct Spoke {
  std::uint32_t neighbour = kNone;  ///< The other end of the edge.
  std::uint32_t diagonal = kNone;   ///< The corner across the quad between this spoke and the next;
                                    ///< kNone where there is no face, or one that is no quad.
};

/// Every vertex of label 0 with all that legality depends on around it, one short run of memory a
/// vertex. The others, which are no candidates, have none.
///
/// The spokes of a vertex are one for each mesh edge, in cyclic order; the one after the last is
/// the first.
class SpokeRings {
 public:
  SpokeRings(const FlatTopology& topology, const VertexLabels& labels);

  [[nodiscard]] std::span<const Spoke> of(std::uint32_t v) const noexcept {
    return std::span(spokes_).subspan(first_[v], first_[v + 1] - first_[v]);
  }
  /// The most of a vertex.
  [[nodiscard]] std::size_t most_spokes() const noexcept { return most_spokes_; }

 private:
  std::size_t most_spokes_ = 0;
  LargeArray<std::uint32_t> first_;  ///< V + 1.
  LargeArray<Spoke> spokes_;         ///< At most two for each mesh edge.
};

/// Calls `visit(a, diagonal, b)` for every quad around the vertex these spokes belong to; a, the
/// vertex, b, and the diagonal are its corners in cyclic order.
template <class Visit>
void for_each_quad(std::span<const Spoke> spokes, const Visit& visit) {
  for (std::size_t i = 0; i < spokes.size(); ++i) {
    if (spokes[i].diagonal != kNone) {
      const std::size_t next = i + 1 < spokes.size() ? i + 1 : 0;
      visit(spokes[i].neighbour, spokes[i].diagonal, spokes[next].neighbour);
    }
  }
}

}  // namespace limn
