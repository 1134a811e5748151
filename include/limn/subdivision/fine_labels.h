#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/progress.h"
#include "limn/subdivision/fine_demands.h"
#include "limn/subdivision/labels.h"
#include "limn/subdivision/legalisation.h"
#include "limn/subdivision/settings.h"

namespace limn {

/// The labels of finer levels where demands make them others than those that follow from the
/// control mesh's. Made by `fine_labels` and read by predictions and refinements of the same mesh
/// alone.
class FineLabels;

/// Labels for depths and demands, and how they came about.
struct LabelsWithDemands {
  VertexLabels painted;  ///< Of the control mesh: L(v), the rule for non-quads, and 1 where demands
                         ///< need it.
  Legalisation legal;    ///< Of these.
  std::shared_ptr<const FineLabels> fine;  ///< Null where nothing is demanded.
};

/// As `legal_labels`, with demands on finer faces. Each is valid on the mesh (`is_demand_on`).
///
/// A demand of depth d on a face of level k asks for labels d - k at its corners at that level.
/// Then from the deepest level up, zeros become 1: those that the level below needs (a positive
/// edge point both ends of its edge, a positive vertex itself), and those that legalise the level:
/// while a quad has just two neighbouring positive labels, that of the zeros beside such quads
/// rises which mends most of them. A zero that becomes 1 is 0 again one level down, so no level
/// changes those below, and the labels are the same in whatever order the demands came. Levels of
/// which nothing is demanded are legalised as `settings` say. Without demands all is as
/// `legal_labels` gives it. Time is linear in the control mesh and in the demands with what is
/// around them. Errors: kCancelled.
[[nodiscard]] Result<LabelsWithDemands> legal_labels(const ControlMesh& mesh,
                                                     std::span<const std::uint8_t> depths,
                                                     const FineDemands& demands,
                                                     const SubdivisionSettings& settings,
                                                     Progress& progress);

}  // namespace limn
