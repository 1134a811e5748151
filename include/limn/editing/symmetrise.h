#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"

namespace limn {

/// What to do with the diagonals of flat quads that were cut into two triangles. Said of a cube,
/// which has 48 symmetries uncut:
enum class SymmetriseBy : std::uint8_t {
  kSplit,       ///< Each diagonal is split in the middle, and the pair becomes four triangles:
                ///< all 48 symmetries.
  kFlipToAxis,  ///< Each pair takes the diagonal that reaches furthest along one space diagonal
                ///< of the bounds: one three-fold axis, 12 symmetries, no more faces.
  kFlipAlternately,  ///< Diagonals join every other vertex: the 24 symmetries of a tetrahedron, no
                     ///< more faces. Needs quads that can be coloured like that.
};

struct Symmetrised {
  std::shared_ptr<const ControlMesh> mesh;
  std::size_t pairs = 0;    ///< Coplanar pairs of triangles that were found.
  std::size_t changed = 0;  ///< Of these, split or flipped.
};

/// Makes a triangulated cube-like mesh symmetric before it is upsampled: triangle pairs in one
/// plane (within `degrees`) that are the halves of a convex quad, each triangle in one pair, the
/// longest diagonals beside the quads' sides first. Of the two ways to do kFlipAlternately the one
/// that flips fewer, in each connected part; a diagonal on a seam of the texture stays.
///
/// Numbering, creases and texture follow from `split_edge` and `flip_edge` (editing/edge_edits.h),
/// edge by edge.
/// Errors: kFailed where a face is no triangle, no pair is found, kFlipAlternately has no
/// colouring, or a diagonal cannot be changed.
[[nodiscard]] Result<Symmetrised> symmetrise(const ControlMesh& mesh, SymmetriseBy by,
                                             double degrees = 1.0);

}  // namespace limn
