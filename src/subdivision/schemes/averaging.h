#pragma once

#include "limn/mesh/creases.h"
#include "subdivision/schemes/level_mesh.h"
#include "subdivision/schemes/point_sink.h"

// Internal to this folder.
namespace limn {

/// The points of a mesh split into quads (quad_split.h) after one averaging: every vertex becomes
/// the mean of the centroids of the quads around it, on boundaries and creases the mean of the
/// middles of the two edges along these (Warren & Schaefer 2004; Zorin & Schroeder 2001).
void place_averaged_points(const LevelMesh& from, CornerRule corners, const LevelMesh& to,
                           const PointSink& sink);

}  // namespace limn
