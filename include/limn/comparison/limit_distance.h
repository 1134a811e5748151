#pragma once

#include <cstddef>

#include "limn/comparison/directed_distance.h"
#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/mesh/large_array.h"
#include "limn/mesh/refined_mesh.h"
#include "limn/progress.h"
#include "limn/subdivision/labels.h"
#include "limn/subdivision/settings.h"

namespace limn {

/// How dense the samples of a measurement become.
struct LimitDistanceLimits {
  double change = 0.01;  ///< Doubling the samples is to change no figure by more than this part.
  /// In one round, before it gives up; and no round takes more than four times what the second
  /// took, which looks at everything.
  std::size_t samples = std::size_t{1} << 26;
};

/// The distance between a refined mesh and the surface that its control mesh tends to.
struct LimitDistance {
  DirectedDistance to_limit;    ///< From the mesh to the limit surface.
  DirectedDistance from_limit;  ///< From the limit surface to the mesh.
  /// For every face of the refined mesh the greatest distance of its points from the limit surface,
  /// and of the points of the limit surface that it is nearest to.
  LargeArray<float> of_faces;
  bool is_settled = false;  ///< Whether the last doubling of the samples changed all figures by
                            ///< less than what was asked.

  [[nodiscard]] double greatest() const noexcept { return greatest_of(to_limit, from_limit); }
  [[nodiscard]] double root_mean_square() const noexcept {
    return root_mean_square_of(to_limit, from_limit);
  }
};

/// Measures how far `refined` is from the Catmull-Clark limit surface of `mesh`, with its creases,
/// corners and boundary.
///
/// `refined` comes from `refine` with these labels and settings, at whichever SurfacePoints; labels
/// above a limit of levels are those of the limit. All labels 0: the control mesh itself is
/// measured. Its faces are triangles as in comparison/surface_distance.h, and a point of the limit
/// surface is held against the nearest of these, exactly. The limit surface is known by points and
/// normals from the engine, more closely spaced than the mesh's vertices by a factor that grows
/// until the figures settle, after two rounds only in the control faces that they depend on;
/// between them it is the surface of second order through these (Phong tessellation at 1/2;
/// Boubekeur & Alexa 2008, doi 10.1145/1409060.1409094). What is left of positions in single
/// precision limits the figures to some 1e-7 of the diagonal. The same input gives the same figures
/// for any number of threads. Errors: kCancelled; kUsage where the settings ask for another scheme.
[[nodiscard]] Result<LimitDistance> measure_limit_distance(
    const ControlMesh& mesh, const VertexLabels& labels, const SubdivisionSettings& settings,
    const RefinedMesh& refined, Progress& progress, const LimitDistanceLimits& limits = {});

}  // namespace limn
