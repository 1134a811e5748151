#pragma once

#include <functional>

#include "limn/subdivision/label_subdivision.h"

// What tests may reach and users may not.
namespace limn {

struct Level;

/// Deliberate errors, to show that tests see them.
struct RefineFaults {
  /// The finished quads of a Y-element stand in vertex rings as they are, with v3 where the virtual
  /// edge point belongs.
  bool drop_virtual_points = false;
};

struct RefineHooks {
  RefineFaults faults;
  std::function<void(const Level&)> on_level;  ///< Called for every level that gets a step.
};

/// `refine` with hooks.
[[nodiscard]] Result<RefinedMesh> refine_with_hooks(const ControlMesh& mesh,
                                                    const VertexLabels& labels,
                                                    const SubdivisionSettings& settings,
                                                    const RefineLimits& limits, Progress& progress,
                                                    const RefineHooks& hooks);

}  // namespace limn
