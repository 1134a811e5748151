#pragma once

#include <cstdint>
#include <memory>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/mesh/creases.h"

namespace limn {

/// Edits of single edges of triangle meshes, as in a mesh editor. All give a new mesh; the old one
/// stays. Faces and vertices that an edit does not touch keep their numbers, positions and
/// attributes; what is new comes last.

/// A new vertex in the middle of an edge, joined to the vertices opposite. Both halves keep the
/// edge's sharpness, and the texture coordinates in the middle are the mean of its ends'. A
/// boundary edge may be split.
///
/// The new vertex has number V. Of each triangle at the edge, the half that holds the edge's first
/// vertex keeps its number and its place of first corner, the other is appended: first that of the
/// triangle of the edge's first corner.
/// Errors: kFailed, with the reason, where a face at the edge is no triangle or where the result
/// would not be a manifold (two triangles back to back).
[[nodiscard]] Result<std::shared_ptr<const ControlMesh>> split_edge(const ControlMesh& mesh,
                                                                    std::uint32_t edge);

/// The edge of two triangles joins their other two vertices instead. Its sharpness goes. The
/// triangle of the edge's first corner becomes the one that holds the edge's first vertex.
///
/// Errors: kFailed, with the reason: a boundary edge, a face that is no triangle, vertices opposite
/// that are joined by an edge already (it would be doubled), or one and the same; or a seam of the
/// texture, since the flipped edge would lie in two charts.
[[nodiscard]] Result<std::shared_ptr<const ControlMesh>> flip_edge(const ControlMesh& mesh,
                                                                   std::uint32_t edge);

/// One step of Loop's scheme done by hand, as mesh editors do: every old edge is split, then every
/// new edge that joins an old and a new vertex is flipped, then vertices are moved. Equal to
/// `subdivide` with Loop's original weights, creases included: the same positions and the same set
/// of faces. Vertex V + e lies on edge e. Texture coordinates are spread linearly. Takes linear
/// time.
/// Errors: kFailed where a face is no triangle, or where two lie back to back.
[[nodiscard]] Result<std::shared_ptr<const ControlMesh>> upsample_by_split_and_flip(
    const ControlMesh& mesh, CornerRule corners = CornerRule::kSharp);

}  // namespace limn
