// Both surfaces are cut into triangles and sorted into trees once; then either is sampled against
// the other, each time with samples at 1/sqrt 2 of the spacing before, until nothing changes.
#include "limn/comparison/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "comparison/cut_surface.h"
#include "comparison/directed_sampling.h"
#include "comparison/triangle_tree.h"
#include "subdivision/sweep.h"

namespace limn {
namespace {

/// Parts of a triangle's side, at most: one triangle of a coarse mesh is all of its area.
constexpr double kMostParts = 4096.0;
constexpr double kFirstSamples = 100'000.0;
constexpr double kSamplesInPart = 6.0;
/// Of the diagonal: what rounding leaves of equal surfaces.
constexpr double kRounding = 1e-12;

glm::dvec3 point_of(const CutSurface<double>& cut, std::uint32_t t, const glm::dvec3& weights) {
  const auto& corners = cut.triangles[t];
  return weights.x * cut.points[corners[0]] + weights.y * cut.points[corners[1]] +
         weights.z * cut.points[corners[2]];
}

/// One of the meshes, both to take samples of and to look for the nearest point on.
class MeasuredSurface {
 public:
  MeasuredSurface(const ControlMesh& mesh, Sweep& sweep) : cut_(cut_surface(mesh, sweep)) {
    tree_.build(cut_.points, cut_.triangles, sweep);
    for (const auto& corners : cut_.triangles) {
      const glm::dvec3 normal = glm::cross(cut_.points[corners[1]] - cut_.points[corners[0]],
                                           cut_.points[corners[2]] - cut_.points[corners[0]]);
      area_ += 0.5 * glm::length(normal);
    }
  }

  [[nodiscard]] double total_area() const noexcept { return area_; }
  [[nodiscard]] std::size_t samples() const {
    std::size_t samples = cut_.points.size();
    for (std::uint32_t t = 0; t < cut_.triangles.size(); ++t) {
      samples += std::size_t{6} * parts(t) * parts(t);
    }
    return samples;
  }
  /// Samples shall be about so far apart.
  void set_spacing(double spacing) noexcept { spacing_ = spacing; }

  [[nodiscard]] std::size_t point_count() const noexcept { return cut_.points.size(); }
  [[nodiscard]] std::size_t triangle_count() const noexcept { return cut_.triangles.size(); }
  [[nodiscard]] const glm::dvec3& vertex(std::size_t v) const noexcept { return cut_.points[v]; }
  [[nodiscard]] glm::dvec3 point(std::uint32_t t, const glm::dvec3& weights) const noexcept {
    return point_of(cut_, t, weights);
  }
  [[nodiscard]] double area(std::uint32_t t) const noexcept {
    const auto& corners = cut_.triangles[t];
    return 0.5 * glm::length(glm::cross(cut_.points[corners[1]] - cut_.points[corners[0]],
                                        cut_.points[corners[2]] - cut_.points[corners[0]]));
  }
  [[nodiscard]] std::uint32_t parts(std::uint32_t t) const noexcept {
    const auto& corners = cut_.triangles[t];
    double longest = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      longest = std::max(longest,
                         glm::distance(cut_.points[corners[i]], cut_.points[corners[(i + 1) % 3]]));
    }
    const double parts = spacing_ > 0.0 ? std::ceil(longest / spacing_) : 1.0;
    return static_cast<std::uint32_t>(std::clamp(parts, 1.0, kMostParts));
  }

  [[nodiscard]] NearestSurface nearest(const glm::dvec3& p, std::uint32_t hint) const {
    NearestPoint nearest;
    if (hint < cut_.triangles.size()) {
      const auto& corners = cut_.triangles[hint];
      nearest.weights = nearest_weights(p, cut_.points[corners[0]], cut_.points[corners[1]],
                                        cut_.points[corners[2]]);
      nearest.triangle = hint;
      const glm::dvec3 offset = point_of(cut_, hint, nearest.weights) - p;
      nearest.square = glm::dot(offset, offset);
    }
    tree_.find_nearest(p, nearest);
    return {std::sqrt(nearest.square), point_of(cut_, nearest.triangle, nearest.weights),
            nearest.triangle};
  }

 private:
  CutSurface<double> cut_;
  TriangleTree<double> tree_;
  double area_ = 0.0;
  double spacing_ = 0.0;
};

DirectedDistance measure_one_way(const MeasuredSurface& from, const MeasuredSurface& to,
                                 Sweep& sweep) {
  const auto ignore = [](std::size_t, const NearestSurface&) {};
  return measure_directed(from, to, ignore, ignore, sweep);
}

}  // namespace

Result<SurfaceDistance> measure_surface_distance(const ControlMesh& mesh, const ControlMesh& other,
                                                 Progress& progress,
                                                 const SurfaceDistanceLimits& limits) {
  std::vector<std::uint64_t> scratch;
  Sweep sweep(progress, scratch);
  sweep.begin_stage("Sorting triangles", 0.0, 0.1, 20 * (mesh.face_count() + other.face_count()));
  MeasuredSurface one(mesh, sweep);
  MeasuredSurface two(other, sweep);
  const double nothing = kRounding * std::max(mesh.bounds().diagonal(), other.bounds().diagonal());
  const auto cancelled = [] { return fail(ErrorKind::kCancelled, "Measuring was cancelled."); };
  double spacing =
      std::sqrt((one.total_area() + two.total_area()) * kSamplesInPart / kFirstSamples);
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
