#pragma once

#include <memory>

#include "limn/mesh/control_mesh.h"

namespace limn {

/// The mesh with every face cut into triangles.
///
/// Faces of up to 32 sides are cut by diagonals that stay inside them in the plane that fits them
/// best, shortest first; no diagonal joins vertices that an edge or another diagonal joins already.
/// Where that leaves no way, and in faces of more sides, all sides are joined with a new vertex at
/// their centroid. Vertices keep their numbers, new ones come last; the triangles of a face follow
/// each other in its place, and faces that are triangles stay. Creases, corners and texture
/// coordinates are kept; diagonals are smooth.
[[nodiscard]] std::shared_ptr<const ControlMesh> triangulated(const ControlMesh& mesh);

}  // namespace limn
