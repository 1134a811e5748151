#include "subdivision/schemes/marked_corners.h"

namespace limn {

void mark_corners(CornerRule corners, LevelMesh& mesh) {
  mesh.edge_sharpness.clear();
  mesh.vertex_sharpness.clear();
  if (corners != CornerRule::kSharp) {
    return;
  }
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    const std::uint32_t leaving = mesh.vertex_starts[v];
    if (mesh.twins[leaving] == kNone && mesh.twins[mesh.previous(leaving)] == kNone) {
      if (mesh.vertex_sharpness.empty()) {
        mesh.vertex_sharpness.assign(mesh.vertex_count(), 0.0f);
      }
      mesh.vertex_sharpness[v] = kInfiniteSharpness;
    }
  }
}

}  // namespace limn
