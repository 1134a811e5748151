#pragma once

#include <cstdint>
#include <memory>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"

namespace limn {

/// Edits of single edges of triangle meshes, as in a mesh editor. All give a new mesh; the old one
/// stays. Faces and vertices that an edit does not touch keep their numbers, positions and
/// attributes; what is new comes last.

/// A new vertex in the middle of an edge, joined to the vertices opposite. Both halves keep the
/// edge's sharpness. A boundary edge may be split.
///
/// The new vertex has number V. Of each triangle at the edge, the half that holds the edge's first
/// vertex keeps its number, the other is appended.
/// Errors: kFailed, with the reason, where a face at the edge is no triangle or where the result
/// would not be a manifold.
[[nodiscard]] Result<std::shared_ptr<const ControlMesh>> split_edge(const ControlMesh& mesh,
                                                                    std::uint32_t edge);

/// The edge of two triangles joins their other two vertices instead. Its sharpness goes.
///
/// Errors: kFailed, with the reason: a boundary edge, a face that is no triangle, vertices opposite
/// that are joined by an edge already (it would be doubled), or one and the same.
[[nodiscard]] Result<std::shared_ptr<const ControlMesh>> flip_edge(const ControlMesh& mesh,
                                                                   std::uint32_t edge);

/// One step of Loop's scheme done by hand, as mesh editors do: every old edge is split, then every
/// new edge that joins an old and a new vertex is flipped, then vertices are moved. Equal to
/// `subdivide` with Loop's original weights: the same positions and the same set of faces.
/// Errors: kFailed where a face is no triangle.
[[nodiscard]] Result<std::shared_ptr<const ControlMesh>> upsample_by_split_and_flip(
    const ControlMesh& mesh);

}  // namespace limn
