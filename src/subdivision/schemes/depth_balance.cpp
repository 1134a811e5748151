#include <algorithm>
#include <array>

#include "limn/contract.h"
#include "limn/subdivision/schemes/adaptive_loop.h"
#include "limn/subdivision/settings.h"

namespace limn {
namespace {

/// Calls `visit(g)` for the faces that share an edge with face f.
template <class Visit>
void for_each_neighbour(const FlatTopology& flat, std::uint32_t f, const Visit& visit) {
  for (std::uint32_t c = flat.face_offsets[f]; c < flat.face_offsets[f + 1]; ++c) {
    if (flat.corner_twins[c] != kNone) {
      visit(flat.corner_faces[flat.corner_twins[c]]);
    }
  }
}

}  // namespace

std::vector<std::uint8_t> balanced_depths(const ControlMesh& mesh,
                                          std::span<const std::uint8_t> depths) {
  LIMN_EXPECTS(depths.size() == mesh.face_count());
  std::vector<std::uint8_t> balanced(depths.begin(), depths.end());
  // From the deepest on: whoever is raised is looked at one depth further down.
  std::array<std::vector<std::uint32_t>, kMaxDepth + 1> by_depth;
  for (std::uint32_t f = 0; f < balanced.size(); ++f) {
    LIMN_EXPECTS(balanced[f] <= kMaxDepth);
    by_depth[balanced[f]].push_back(f);
  }
  for (std::size_t depth = kMaxDepth; depth > 1; --depth) {
    for (const std::uint32_t f : by_depth[depth]) {
      for_each_neighbour(mesh.topology(), f, [&](std::uint32_t g) {
        if (balanced[g] + 1u < depth) {
          balanced[g] = static_cast<std::uint8_t>(depth - 1);
          by_depth[depth - 1].push_back(g);
        }
      });
    }
  }
  return balanced;
}

// A face of depth d has (2^d - 1) (2^d - 2) / 2 vertices within; an edge is as fine as the deeper
// of its faces, and each of the coarser one's 2^d triangles along it is cut in two more.
SchemeCounts predict_adaptive_loop(const ControlMesh& mesh, std::span<const std::uint8_t> depths) {
  const FlatTopology& flat = mesh.topology();
  SchemeCounts counts;
  counts.vertices = mesh.vertex_count();
  std::uint64_t boundary = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const std::uint64_t segments = std::uint64_t{1} << depths[f];
    counts.faces += segments * segments;
    counts.vertices += (segments - 1) * (segments - 2) / 2;
  }
  for (const auto& [one, other] : flat.edge_corners) {
    const std::uint8_t at_one = depths[flat.corner_faces[one]];
    const std::uint8_t at_other = other == kNone ? at_one : depths[flat.corner_faces[other]];
    const auto [lower, higher] = std::minmax({at_one, at_other});
    counts.vertices += (std::uint64_t{1} << higher) - 1;
    counts.faces += lower < higher ? std::uint64_t{1} << lower : 0;
    boundary += other == kNone ? std::uint64_t{1} << at_one : 0;
  }
  counts.edges = (3 * counts.faces + boundary) / 2;
  return counts;
}

}  // namespace limn
