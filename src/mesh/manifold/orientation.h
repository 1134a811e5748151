#pragma once

#include <cstdint>
#include <vector>

#include "mesh/edge_matching.h"
#include "mesh/manifold/mend_log.h"
#include "mesh/manifold/working_faces.h"

namespace limn::detail {

/// Makes neighbours run along their common edge in opposite directions: floods each component over
/// its twins and turns over the smaller side, by number of faces; of two equal sides the one
/// without the component's first face. Faces turn about their first corner, and the matching goes
/// with them. Twins that cannot agree, on a one-sided surface, are parted.
void orient(WorkingFaces& faces, CornerMatching& matching, MendLog& log);

}  // namespace limn::detail
