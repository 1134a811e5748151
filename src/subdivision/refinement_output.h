#pragma once

#include "limn/mesh/control_mesh.h"
#include "limn/mesh/refined_mesh.h"
#include "limn/subdivision/prediction.h"
#include "subdivision/step.h"

// Filling the arrays of a RefinedMesh. Internal to this folder.
namespace limn {

/// The origin chosen, arrays of their final sizes; the control vertices in place, at level 0, and
/// the non-quads that stay as they are.
[[nodiscard]] RefinedMesh allocate_output(const ControlMesh& mesh, const VertexLabels& labels,
                                          const RefinementPrediction& prediction);

/// Writes the quads that are finished in this step: faces that stay, the two coarse quads of
/// Y-elements, and after the last step all children too.
template <class Sides>
void emit_quads(Sweep& sweep, const Sides& sides, const Level& level, const Step& step,
                RefinedMesh& output);

}  // namespace limn
