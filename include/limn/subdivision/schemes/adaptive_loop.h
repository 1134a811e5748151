#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/mesh/refined_mesh.h"
#include "limn/progress.h"
#include "limn/subdivision/schemes/scheme.h"
#include "limn/subdivision/schemes/uniform.h"

/// Loop's scheme where an artist wants it: every face of a triangle mesh to a depth of its own.
///
/// Faces that share an edge differ by one level at most. Where they differ, the triangles on the
/// coarser side take the vertices that the finer side has on their edges for corners and are cut
/// into a fan of triangles, so that nothing cracks.
namespace limn {

/// The least depths that are not below the given ones, with faces that share an edge no more than
/// one apart. One entry per face, 0..kMaxDepth. Takes linear time.
[[nodiscard]] std::vector<std::uint8_t> balanced_depths(const ControlMesh& mesh,
                                                        std::span<const std::uint8_t> depths);

/// What `refine_by_loop` gives for balanced depths, exactly, before any work.
[[nodiscard]] SchemeCounts predict_adaptive_loop(const ControlMesh& mesh,
                                                 std::span<const std::uint8_t> depths);

struct AdaptiveLoopSettings {
  LoopWeights weights = LoopWeights::kOriginal;
  CornerRule corners = CornerRule::kSharp;
  std::uint64_t face_budget = std::numeric_limits<std::uint64_t>::max();
};

/// Adaptive Loop of a triangle mesh whose `depths` are balanced.
///
/// Exact: a vertex lies where uniform Loop has it at level k, the greatest depth of the faces
/// around it (RefinedMesh::vertex_levels). All faces of the result are triangles, those of one
/// depth together, coarse first; fans have the depth of the triangle they fill. Creases and corners
/// hold for as many levels as they are sharp. Texture coordinates are not carried. Time and memory
/// are proportional to the mesh and the output. The same input gives the same bytes for any number
/// of threads.
/// Errors: kFailed (`check_fits`), kOverBudget (before any work), kCancelled.
[[nodiscard]] Result<RefinedMesh> refine_by_loop(const ControlMesh& mesh,
                                                 std::span<const std::uint8_t> depths,
                                                 const AdaptiveLoopSettings& settings,
                                                 Progress& progress);

}  // namespace limn
