#pragma once

#include "limn/mesh/refined_mesh.h"
#include "subdivision/control_faces.h"

// What stays sharp. Internal to this folder.
namespace limn {

/// Lists the sharp edges and vertices of a refined mesh whose vertices are written.
void list_creases(const RefinementPlan& plan, RefinedMesh& result);

/// Lists what boundary edges have become where labels of finer levels are given.
void list_boundary_edges(const RefinementPlan& plan, RefinedMesh& result);

}  // namespace limn
