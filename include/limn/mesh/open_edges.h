#pragma once

#include <cstdint>
#include <vector>

#include "limn/mesh/control_mesh.h"

namespace limn {

/// Where the surface ends: vertices in order along one boundary, each once. The surface lies to the
/// left of the way as seen from outside.
using BoundaryLoop = std::vector<std::uint32_t>;

/// Every loop of boundary edges, by its lowest vertex. Takes time linear in the mesh.
[[nodiscard]] std::vector<BoundaryLoop> boundary_loops(const ControlMesh& mesh);

/// A boundary vertex that lies on a boundary edge without being an end of it. The faces on either
/// side only seem to be joined there: subdivided, they part, and a crack opens.
struct TJunction {
  std::uint32_t vertex = kNone;
  std::uint32_t edge = kNone;

  [[nodiscard]] bool operator==(const TJunction&) const = default;
};

/// All T-junctions, by vertex, then edge. A vertex lies on an edge where it is within
/// `tolerance` times the edge's length of it, and farther than that from its ends. Takes
/// O(b log b) time for b boundary edges that are short beside the mesh; at worst O(b^2).
[[nodiscard]] std::vector<TJunction> find_t_junctions(const ControlMesh& mesh,
                                                      double tolerance = 1e-4);

}  // namespace limn
