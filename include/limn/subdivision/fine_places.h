#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "limn/mesh/control_mesh.h"
#include "limn/mesh/refined_mesh.h"
#include "limn/subdivision/fine_demands.h"
#include "limn/subdivision/fine_labels.h"
#include "limn/subdivision/labels.h"

namespace limn {

/// From what a refined mesh was made: the control mesh, labels and levels that `refine` had.
struct RefinedFrom {
  const ControlMesh* control = nullptr;
  const VertexLabels* labels = nullptr;
  const FineLabels* fine = nullptr;
  int levels = 0;
};

/// Which faces of the uniform levels some faces of a refined mesh are: one for each, in their
/// order. A control face that is still whole has level 0. Of the three quads of a Y-element the two
/// that are no faces of their level are taken for those that they begin with: at the two corners
/// beside the positive one. `faces` are ascending. In time that is linear in them and in the labels
/// of their control faces.
[[nodiscard]] std::vector<FineFace> places_of(const RefinedFrom& from, const RefinedMesh& refined,
                                              std::span<const std::uint32_t> faces);

}  // namespace limn
