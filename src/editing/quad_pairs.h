#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "limn/mesh/control_mesh.h"

// Internal to this folder.
namespace limn {

/// Two triangles in one plane that are the halves of a convex quad.
struct QuadPair {
  std::uint32_t corner = 0;  ///< On the diagonal, the first of its edge.
  /// Around the quad, counter-clockwise: the diagonal joins 0 and 2.
  std::array<std::uint32_t, 4> vertices{};
};

/// Pairs whose triangles' planes differ by at most `degrees`, each triangle in one pair at most,
/// and no seam of the texture on a diagonal. Where several neighbours would do, the diagonal is the
/// edge that is longest beside the quad's sides. In the order of edges. Faces are triangles.
[[nodiscard]] std::vector<QuadPair> find_quad_pairs(const ControlMesh& mesh, double degrees);

}  // namespace limn
