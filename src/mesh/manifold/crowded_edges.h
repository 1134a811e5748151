#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "mesh/manifold/fans.h"
#include "mesh/manifold/mend_log.h"
#include "mesh/manifold/working_faces.h"

namespace limn::detail {

/// Joins faces at the crowded edges of a matching, so that `twins` are those of a manifold: pairs
/// that run in opposite directions, the straightest first, in doubt those that hang together
/// elsewhere; the rest stays without a twin. No two edges get the same ends. Returns the fans.
///
/// Follows Gueziec, Taubin, Lazarus and Horn 1998 ("Converting sets of polygons to manifold
/// surfaces by cutting and stitching"): all crowded edges are cut first, then stitched.
[[nodiscard]] FanOwners join_crowded_edges(const WorkingFaces& faces, CornerMatching& matching,
                                           std::span<const glm::dvec3> positions, MendLog& log);

}  // namespace limn::detail
