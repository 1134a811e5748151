#pragma once

#include <cstddef>

#include "limn/comparison/directed_distance.h"
#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/progress.h"

namespace limn {

/// How dense the samples of a measurement become.
struct SurfaceDistanceLimits {
  double change = 0.01;  ///< Doubling the samples is to change no figure by more than this part.
  std::size_t samples = std::size_t{1} << 25;  ///< Of both surfaces together, before it gives up.
};

/// The distance between two polygon surfaces, as they are, without any subdivision.
struct SurfaceDistance {
  DirectedDistance to_other;    ///< From the first surface to the second.
  DirectedDistance from_other;  ///< From the second to the first.
  bool is_settled = false;      ///< Whether the last doubling of the samples changed all figures by
                                ///< less than what was asked.

  [[nodiscard]] double greatest() const noexcept { return greatest_of(to_other, from_other); }
  [[nodiscard]] double root_mean_square() const noexcept {
    return root_mean_square_of(to_other, from_other);
  }
};

/// Measures how far two meshes are apart: from points of either surface to the nearest point of the
/// other, whatever triangle that lies in (no sampling there).
///
/// Faces are the triangles that STL files get: diagonals inside the face, the shortest first
/// (mesh/triangulate.h; what that says of diagonals between vertices that are joined already is
/// left aside). The program draws a face as a fan around its first corner, which in a face that is
/// not plane is another surface. Samples are the vertices and points spread evenly over the area;
/// where the distance is greatest it is followed up to its peak. Time grows with the samples times
/// the logarithm of the faces. The same input gives the same figures for any number of threads.
/// Errors: kCancelled.
[[nodiscard]] Result<SurfaceDistance> measure_surface_distance(
    const ControlMesh& mesh, const ControlMesh& other, Progress& progress,
    const SurfaceDistanceLimits& limits = {});

}  // namespace limn
