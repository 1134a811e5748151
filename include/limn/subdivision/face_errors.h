#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/progress.h"
#include "limn/subdivision/settings.h"

namespace limn {

/// Levels that a face's errors are told for: those of every depth, and one more for the uniform
/// first step.
inline constexpr std::size_t kErrorLevels = kMaxDepth + 2;

/// How far a face lies from the limit surface, in mesh units, if it and all around it are refined
/// evenly by 0, 1, 2, ... levels. Never grows from level to level.
using LevelErrors = std::array<float, kErrorLevels>;

[[nodiscard]] inline float at_level(const LevelErrors& errors, int level) noexcept {
  return errors[static_cast<std::size_t>(level)];
}

/// What is asked of errors.
struct FaceErrorOptions {
  CornerRule corners = CornerRule::kSharp;
  /// Where vertices stand: on the limit surface, or where uniform subdivision puts them, which is
  /// further off.
  SurfacePoints points = SurfacePoints::kLimit;
  /// Errors up to this one need not be told apart: where a part of a face has come down to it, what
  /// follows is only extrapolated. In mesh units.
  double enough = 0.0;
  /// Nobody asks for more levels than these, 0..kErrorLevels - 1.
  int deepest = static_cast<int>(kErrorLevels) - 1;
};

/// The errors of all faces: how far the triangles that a face is drawn with, cut by either
/// diagonal, are from the Catmull-Clark limit surface.
///
/// Away from irregular vertices the surface is a bicubic, and a quad of side h differs from it by
/// its second derivatives times h^2 / 8 (limit positions; in each direction, and along the
/// diagonal). Only what stands out of the surface counts, and across boundaries and creases what is
/// not along them: a distance is a distance to the surface and not to a point of it. Around
/// irregular vertices and creases that wear off the quads are measured level by level at their
/// corners, middles and centre, until they are near enough. (The bound of the literature, M / 4 and
/// M / 3 with the second-order norm M of the 16 control points, is the same with the greatest
/// second difference in place of derivatives, and the sum of both directions; it counts what lies
/// within the surface too.)
///
/// An estimate, from above as a rule: derivatives are sampled at nine places of a bicubic. Measure
/// the refined mesh (comparison/limit_distance.h) to know. Time is linear in the faces, more for
/// each irregular vertex. The result does not depend on the number of threads. Errors: kCancelled.
[[nodiscard]] Result<std::vector<LevelErrors>> face_errors(const ControlMesh& mesh,
                                                           const FaceErrorOptions& options,
                                                           Progress& progress);

/// By how much the limit surface turns within each face: the greatest angle between its normals at
/// the face's centre, corners and middles of sides, in degrees, 0..180, one entry a face. Where
/// it is creased, the normals are those of the face's own side.
/// Errors: kCancelled.
[[nodiscard]] Result<std::vector<float>> face_bends(const ControlMesh& mesh, CornerRule corners,
                                                    Progress& progress);

}  // namespace limn
