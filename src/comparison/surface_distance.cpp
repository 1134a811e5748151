// Both surfaces are cut into triangles and sorted into trees once; then either is sampled against
// the other, each time with samples at 1/sqrt 2 of the spacing before, until nothing changes.
#include "limn/comparison/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "comparison/directed_sampling.h"
#include "comparison/tree_surface.h"
#include "subdivision/sweep.h"

namespace limn {
namespace {

/// Parts of a triangle's side, at most: one triangle of a coarse mesh is all of its area.
constexpr double kMostParts = 4096.0;
constexpr double kFirstSamples = 100'000.0;
constexpr std::size_t kSamplesInPart = 6;
/// Of the diagonal: what rounding leaves of equal surfaces.
constexpr double kRounding = 1e-12;

/// One of the meshes, both to take samples of and to look for the nearest point on.
class ComparedSurface : public TreeSurface<double> {
 public:
  ComparedSurface(const ControlMesh& mesh, Sweep& sweep)
      : TreeSurface(cut_surface(mesh, sweep), sweep) {
    for (std::uint32_t t = 0; t < triangle_count(); ++t) {
      area_ += area(t);
    }
  }

  [[nodiscard]] double total_area() const noexcept { return area_; }
  [[nodiscard]] std::size_t samples() const {
    std::size_t samples = 0;
    for (std::uint32_t t = 0; t < triangle_count(); ++t) {
      samples += kSamplesInPart * parts(t) * parts(t);
    }
    return samples;
  }
  /// Samples shall be about so far apart.
  void set_spacing(double spacing) noexcept { spacing_ = spacing; }

  [[nodiscard]] std::uint32_t group(std::uint32_t) const noexcept { return 0; }
  [[nodiscard]] glm::dvec3 point(std::uint32_t t, const glm::dvec3& weights) const noexcept {
    return linear_point(t, weights);
  }
  [[nodiscard]] std::uint32_t parts(std::uint32_t t) const noexcept {
    const Corners& at = corners(t);
    double longest = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      longest = std::max(longest, glm::distance(vertex(at[i]), vertex(at[(i + 1) % 3])));
    }
    const double parts = spacing_ > 0.0 ? std::ceil(longest / spacing_) : 1.0;
    return static_cast<std::uint32_t>(std::clamp(parts, 1.0, kMostParts));
  }
  [[nodiscard]] NearestSurface nearest(const glm::dvec3& p, std::uint32_t hint) const {
    const NearestPoint nearest = nearest_linear(p, hint);
    return {std::sqrt(nearest.square), linear_point(nearest.triangle, nearest.weights),
            nearest.triangle};
  }

 private:
  double area_ = 0.0;
  double spacing_ = 0.0;
};

DirectedDistance measure_one_way(const ComparedSurface& from, const ComparedSurface& to,
                                 Sweep& sweep) {
  GroupDistance all;
  measure_directed(
      from, to, [](std::uint32_t, double, std::uint32_t) {}, std::span(&all, 1), sweep);
  return directed_distance(std::span(&all, 1));
}

}  // namespace

Result<SurfaceDistance> measure_surface_distance(const ControlMesh& mesh, const ControlMesh& other,
                                                 Progress& progress,
                                                 const SurfaceDistanceLimits& limits) {
  std::vector<std::uint64_t> scratch;
  Sweep sweep(progress, scratch);
  sweep.begin_stage("Sorting triangles", 0.0, 0.1, 20 * (mesh.face_count() + other.face_count()));
  ComparedSurface one(mesh, sweep);
  ComparedSurface two(other, sweep);
  const double nothing = kRounding * std::max(mesh.bounds().diagonal(), other.bounds().diagonal());
  const auto cancelled = [] { return fail(ErrorKind::kCancelled, "Measuring was cancelled."); };
  double spacing = std::sqrt((one.total_area() + two.total_area()) *
                             static_cast<double>(kSamplesInPart) / kFirstSamples);
  SurfaceDistance result;
  double done = 0.1;
  for (int round = 0;; ++round, spacing *= std::sqrt(0.5)) {
    one.set_spacing(spacing);
    two.set_spacing(spacing);
    const std::size_t samples = one.samples() + two.samples();
    if (sweep.is_cancelled()) {
      return cancelled();
    }
    if (round > 1 && samples > limits.samples) {
      return result;
    }
    const double until = done + 0.5 * (1.0 - done);
    sweep.begin_stage("Measuring", done, until, samples);
    done = until;
    SurfaceDistance now;
    now.to_other = measure_one_way(one, two, sweep);
    now.from_other = measure_one_way(two, one, sweep);
    if (sweep.is_cancelled()) {
      return cancelled();
    }
    now.is_settled = round > 0 &&
                     has_settled(result.to_other, now.to_other, limits.change, nothing) &&
                     has_settled(result.from_other, now.from_other, limits.change, nothing);
    result = now;
    if (result.is_settled) {
      return result;
    }
  }
}

}  // namespace limn
