#pragma once

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/subdivision/settings.h"

// Internal to this folder.
namespace limn {

/// Levels that all faces get on top of their depths as soon as anything is painted.
[[nodiscard]] inline int first_step_levels(const ControlMesh& mesh,
                                           const SubdivisionSettings& settings) noexcept {
  return !mesh.is_all_quads() && settings.non_quads == NonQuadRule::kUniformFirstStep ? 1 : 0;
}

/// What is chosen by distances to the limit surface means Catmull-Clark's.
[[nodiscard]] inline Result<void> check_has_limit(const SubdivisionSettings& settings) {
  if (settings.scheme == RefinementScheme::kLoop) {
    return fail(ErrorKind::kUsage,
                "Depths are chosen by the limit surface of Catmull-Clark, and painted faces are to "
                "be subdivided by Loop's scheme; choose Catmull-Clark for painted faces first.");
  }
  return {};
}

}  // namespace limn
