#pragma once

#include <cstddef>

#include "limn/error.h"
#include "limn/mesh/halfedge_mesh.h"
#include "mesh/edge_matching.h"

namespace limn::detail {

/// Whether a mesh of this size fits the signed 32-bit handles of OpenMesh; kBadInput if not.
[[nodiscard]] Result<void> check_halfedge_limits(std::size_t vertices, std::size_t edges,
                                                 std::size_t faces);

/// Makes a half-edge mesh of faces that are an oriented manifold: at most two faces at an edge,
/// running along it in opposite directions, and one fan of faces at every vertex.
///
/// Faces keep their numbers and their first corner; edge e is edge e of the matching, and its
/// half-edge 0 runs as its first corner does. The outgoing half-edge of a boundary vertex is its
/// boundary one, as OpenMesh wants it. Positions are left for the caller to set.
[[nodiscard]] HalfedgeMesh assemble_halfedges(const FaceArrays& faces, const EdgeMatching& edges);

}  // namespace limn::detail
