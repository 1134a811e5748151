#pragma once

#include <cstdint>
#include <vector>

#include "limn/mesh/control_mesh.h"

namespace limn::bench {

/// How the painted faces lie.
enum class Layout {
  kPatches,    ///< In twelve round patches, as an artist paints.
  kScattered,  ///< Each for itself: the longest seam between levels that can be had.
};

/// Depths of a mesh of which `share` (0..1) of the faces is painted `depth` deep.
[[nodiscard]] std::vector<std::uint8_t> paint(const ControlMesh& mesh, Layout layout, double share,
                                              int depth);

}  // namespace limn::bench
