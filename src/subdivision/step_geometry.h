#pragma once

#include "limn/mesh/refined_mesh.h"
#include "limn/subdivision/settings.h"
#include "subdivision/refine_hooks.h"
#include "subdivision/step.h"

// Positions of one step. Internal to this folder.
namespace limn {

struct GeometryRules {
  CornerRule corners = CornerRule::kSharp;
  RefineFaults faults;
};

/// Computes P_(k+1) of every point of the step from P_k, in double precision. Emitted points go to
/// `output` as floats, with the level they belong to; all go to `next` where it is not null.
template <class Sides>
void place_points(Sweep& sweep, const Sides& sides, const Level& level, const Step& step,
                  const GeometryRules& rules, Level* next, RefinedMesh& output);

}  // namespace limn
