#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/progress.h"
#include "limn/subdivision/schemes/scheme.h"

namespace limn {

/// The sphere that fits points best, and how far they are from it.
struct SphereFit {
  glm::dvec3 centre{0.0};
  double radius = 0.0;
  /// Distance from the centre minus the radius, over all points, in the points' units.
  double least = 0.0;
  double greatest = 0.0;
  double root_mean_square = 0.0;
};

/// The least-squares sphere: it minimises the sum of squares of the distances to the sphere
/// (geometric, by Newton's method from the algebraic fit and from the points' mean). Nothing where
/// no sphere is determined: fewer than four points, all of them in a plane, or points that are as
/// near to a plane, which is a sphere of infinite radius.
[[nodiscard]] std::optional<SphereFit> fit_sphere(std::span<const glm::dvec3> points);

/// A row of the table that compares a scheme with a sphere.
struct SphereComparison {
  int level = 0;
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  double seconds = 0.0;  ///< To make this level, of the one before.
  SphereFit fit;
};

/// Levels 0..levels of a scheme, each held against its own least-squares sphere.
/// Errors: those of `subdivide`; kFailed where no sphere is determined.
[[nodiscard]] Result<std::vector<SphereComparison>> compare_with_sphere(
    const ControlMesh& mesh, const SchemeSettings& settings, int levels, Progress& progress);

}  // namespace limn
