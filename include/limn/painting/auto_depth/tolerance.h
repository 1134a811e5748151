#pragma once

#include <span>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/painting/face_depths.h"
#include "limn/progress.h"
#include "limn/subdivision/settings.h"

namespace limn {

/// Depths that were chosen, and what is expected of them.
struct ChosenDepths {
  FaceDepths depths;
  double expected_error = 0.0;  ///< The greatest distance to the limit surface, in mesh units.
  std::size_t short_faces = 0;  ///< Faces that kMaxDepth levels do not suffice for.
};

/// The least depths at which each face, refined evenly, stays within a distance of the limit
/// surface (subdivision/face_errors.h), for vertices where `settings` put them. Where the paper's
/// uniform first step adds a level, depths are one less.
///
/// In a mixed-level mesh a face may be refined further than asked, beside deeper ones, and is never
/// refined less. Measure the refined mesh to know what was reached.
/// `distances`, in mesh units and not negative, are one for all faces or one a face; infinite ones
/// ask for nothing. Errors: kCancelled; kUsage where the settings ask for Loop's scheme.
[[nodiscard]] Result<ChosenDepths> depths_for_tolerance(const ControlMesh& mesh,
                                                        const SubdivisionSettings& settings,
                                                        std::span<const double> distances,
                                                        Progress& progress);

/// As `depths_for_tolerance`, less what a measurement shows to be needless: as long as the refined
/// mesh, measured (comparison/limit_distance.h), stays within its distance where faces have a level
/// less, they have. Errors are estimated from above, and beside creases that wear off, where they
/// hardly fall from one level to the next, that may be levels. Never more faces than an even
/// painting that stays within all distances.
///
/// `expected_error` is what was measured last. Refines and measures some few times: that takes
/// longer than all else.
/// Errors: as above.
[[nodiscard]] Result<ChosenDepths> depths_for_measured_tolerance(
    const ControlMesh& mesh, const SubdivisionSettings& settings, std::span<const double> distances,
    Progress& progress);

}  // namespace limn
