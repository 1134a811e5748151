#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "limn/mesh/control_mesh.h"
#include "limn/subdivision/labels.h"

namespace limn::bench {

/// How the painted faces lie.
enum class Layout {
  kPatches,    ///< In twelve round patches, as an artist paints.
  kScattered,  ///< Each for itself: the longest seam between levels that can be had.
};

/// A part of the faces, in percent, painted to the same depth.
struct Painting {
  Layout layout = Layout::kPatches;
  int percent = 0;
  int depth = 0;
};

/// `LAYOUT/PERCENT/DEPTH`, the part of a case's name.
[[nodiscard]] std::string path_of(const Painting& painting);

[[nodiscard]] std::vector<std::uint8_t> depths_of(const ControlMesh& mesh,
                                                  const Painting& painting);
[[nodiscard]] VertexLabels legal_labels_of(const ControlMesh& mesh, const Painting& painting);

/// The paintings that are measured: shares of 1, 5 and 20 percent in both layouts, each as deep as
/// the result stays at some millions of faces for the largest asteroid.
[[nodiscard]] const std::vector<Painting>& deepest_paintings();

}  // namespace limn::bench
