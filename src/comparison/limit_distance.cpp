// The engine that refines a mesh knows the limit surface: with all labels raised by some levels and
// its vertices put on the limit it gives points and normals of it where the mesh is, and as much
// finer. Either surface is then sampled against the other, with more levels from round to round.
//
// Between its vertices the limit surface is the linear triangle x, moved half way to the mean of
// its projections on the corners' tangent planes. That is exact for surfaces of second order:
//
//   x = sum w_i x_i,   s(x) = x + 1/2 sum w_i ((x_i - x) . n_i) n_i
#include "limn/comparison/limit_distance.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "comparison/cut_surface.h"
#include "comparison/directed_sampling.h"
#include "comparison/triangle_tree.h"
#include "limn/contract.h"
#include "limn/subdivision/label_subdivision.h"
#include "subdivision/sweep.h"

namespace limn {
namespace {

/// Labels cannot be higher: a face painted as deep as can be, on a mesh with non-quads.
constexpr int kHighestLabel = kMaxDepth + 1;
/// Of the diagonal: what is left of positions in single precision.
constexpr double kNothing = 2e-7;
/// Small meshes are looked at no less closely than this.
constexpr std::uint64_t kFewestFaces = 4'000;

using Corners = std::array<std::uint32_t, 3>;

/// Part of a progress, for what reports from 0 to 1 itself.
class PartOfMeasuring final : public Progress {
 public:
  PartOfMeasuring(Progress& whole, double from, double to) : whole_(&whole), from_(from), to_(to) {}
  [[nodiscard]] bool report(double fraction, std::string_view stage) override {
    return whole_->report(from_ + fraction * (to_ - from_), stage);
  }

 private:
  Progress* whole_;
  double from_;
  double to_;
};

double area_of(const CutSurface<float>& cut, std::uint32_t t) {
  const Corners& corners = cut.triangles[t];
  const glm::dvec3 a(cut.points[corners[0]]);
  return 0.5 * glm::length(glm::cross(glm::dvec3(cut.points[corners[1]]) - a,
                                      glm::dvec3(cut.points[corners[2]]) - a));
}

glm::dvec3 linear_point(const CutSurface<float>& cut, std::uint32_t t, const glm::dvec3& weights) {
  const Corners& corners = cut.triangles[t];
  return weights.x * glm::dvec3(cut.points[corners[0]]) +
         weights.y * glm::dvec3(cut.points[corners[1]]) +
         weights.z * glm::dvec3(cut.points[corners[2]]);
}

/// The nearest point of the triangles alone.
NearestPoint nearest_triangle(const CutSurface<float>& cut, const TriangleTree<float>& tree,
                              const glm::dvec3& p, std::uint32_t hint) {
  NearestPoint nearest;
  if (hint < cut.triangles.size()) {
    const Corners& corners = cut.triangles[hint];
    nearest.weights =
        nearest_weights(p, glm::dvec3(cut.points[corners[0]]), glm::dvec3(cut.points[corners[1]]),
                        glm::dvec3(cut.points[corners[2]]));
    nearest.triangle = hint;
    const glm::dvec3 offset = linear_point(cut, hint, nearest.weights) - p;
    nearest.square = glm::dot(offset, offset);
  }
  tree.find_nearest(p, nearest);
  return nearest;
}

/// The refined mesh. Coordinates are relative to RefinedMesh::origin, here and below.
class MeasuredMesh {
 public:
  MeasuredMesh(const RefinedMesh& mesh, Sweep& sweep) : cut_(cut_surface(mesh, sweep)) {
    tree_.build(cut_.points, cut_.triangles, sweep);
  }

  void set_parts(std::uint32_t parts) noexcept { parts_ = parts; }
  [[nodiscard]] const CutSurface<float>& cut() const noexcept { return cut_; }

  [[nodiscard]] std::size_t point_count() const noexcept { return cut_.points.size(); }
  [[nodiscard]] std::size_t triangle_count() const noexcept { return cut_.triangles.size(); }
  [[nodiscard]] glm::dvec3 vertex(std::size_t v) const noexcept {
    return glm::dvec3(cut_.points[v]);
  }
  [[nodiscard]] glm::dvec3 point(std::uint32_t t, const glm::dvec3& weights) const noexcept {
    return linear_point(cut_, t, weights);
  }
  [[nodiscard]] double area(std::uint32_t t) const noexcept { return area_of(cut_, t); }
  [[nodiscard]] std::uint32_t parts(std::uint32_t) const noexcept { return parts_; }
  [[nodiscard]] NearestSurface nearest(const glm::dvec3& p, std::uint32_t hint) const {
    const NearestPoint nearest = nearest_triangle(cut_, tree_, p, hint);
    return {std::sqrt(nearest.square), linear_point(cut_, nearest.triangle, nearest.weights),
            nearest.triangle};
  }

 private:
  CutSurface<float> cut_;
  TriangleTree<float> tree_;
  std::uint32_t parts_ = 1;
};

/// The limit surface.
class LimitSurface {
 public:
  /// `points`: a refinement at SurfacePoints::kLimit, with normals.
  LimitSurface(RefinedMesh points, Sweep& sweep)
      : cut_(cut_surface(points, sweep)), normals_(std::move(points.normals)) {
    // A crease has two normals, a corner many, the centre of a polygon an unknown one.
    normals_.resize(cut_.points.size(), glm::vec3(0.0f));
    for (const RefinedCrease& crease : points.creases) {
      normals_[crease.vertices[0]] = glm::vec3(0.0f);
      normals_[crease.vertices[1]] = glm::vec3(0.0f);
    }
    for (const RefinedCorner& corner : points.corners) {
      normals_[corner.vertex] = glm::vec3(0.0f);
    }
    tree_.build(cut_.points, cut_.triangles, sweep);
  }

  [[nodiscard]] std::size_t point_count() const noexcept { return cut_.points.size(); }
  [[nodiscard]] std::size_t triangle_count() const noexcept { return cut_.triangles.size(); }
  [[nodiscard]] glm::dvec3 vertex(std::size_t v) const noexcept {
    return glm::dvec3(cut_.points[v]);
  }
  [[nodiscard]] glm::dvec3 point(std::uint32_t t, const glm::dvec3& weights) const noexcept {
    const Corners& corners = cut_.triangles[t];
    const glm::dvec3 linear = linear_point(cut_, t, weights);
    glm::dvec3 moved = linear;
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t v = corners[static_cast<std::size_t>(i)];
      const glm::dvec3 normal(normals_[v]);
      moved += 0.5 * weights[i] * glm::dot(glm::dvec3(cut_.points[v]) - linear, normal) * normal;
    }
    return moved;
  }
  [[nodiscard]] double area(std::uint32_t t) const noexcept { return area_of(cut_, t); }
  [[nodiscard]] std::uint32_t parts(std::uint32_t) const noexcept { return 1; }
  [[nodiscard]] NearestSurface nearest(const glm::dvec3& p, std::uint32_t hint) const {
    const NearestPoint nearest = nearest_triangle(cut_, tree_, p, hint);
    const glm::dvec3 there = point(nearest.triangle, nearest.weights);
    return {glm::distance(p, there), there, nearest.triangle};
  }

 private:
  CutSurface<float> cut_;
  LargeArray<glm::vec3> normals_;
  TriangleTree<float> tree_;
};

/// Distances of faces, raised by several threads.
void raise(float& value, double to) {
  std::atomic_ref<float> shared(value);
  const auto candidate = static_cast<float>(to);
  float before = shared.load(std::memory_order_relaxed);
  while (before < candidate &&
         !shared.compare_exchange_weak(before, candidate, std::memory_order_relaxed)) {
  }
}

VertexLabels raised(const VertexLabels& labels, int levels) {
  VertexLabels result(labels.size());
  std::ranges::transform(labels, result.begin(), [levels](std::uint8_t label) {
    return static_cast<std::uint8_t>(std::min(label + levels, kHighestLabel));
  });
  return result;
}

LimitDistance measure(const MeasuredMesh& mesh, const LimitSurface& limit, std::size_t faces,
                      Sweep& sweep) {
  LimitDistance result;
  result.of_faces.assign(faces, 0.0f);
  const CutSurface<float>& cut = mesh.cut();
  LargeArray<float> of_vertices(mesh.point_count());
  result.to_limit = measure_directed(
      mesh, limit,
      [&](std::size_t v, const NearestSurface& there) {
        of_vertices[v] = static_cast<float>(there.distance);
      },
      [&](std::uint32_t t, const NearestSurface& there) {
        raise(result.of_faces[cut.faces[t]], there.distance);
      },
      sweep);
  sweep.each(cut.triangles.size(), [&](std::size_t t) {
    for (const std::uint32_t v : cut.triangles[t]) {
      raise(result.of_faces[cut.faces[t]], of_vertices[v]);
    }
  });
  const auto raise_nearest = [&](std::size_t, const NearestSurface& there) {
    raise(result.of_faces[cut.faces[there.triangle]], there.distance);
  };
  result.from_limit = measure_directed(limit, mesh, raise_nearest, raise_nearest, sweep);
  return result;
}

tl::unexpected<Error> cancelled() {
  return fail(ErrorKind::kCancelled, "Measuring was cancelled.");
}

}  // namespace

Result<LimitDistance> measure_limit_distance(const ControlMesh& mesh, const VertexLabels& labels,
                                             const SubdivisionSettings& settings,
                                             const RefinedMesh& refined, Progress& progress,
                                             const LimitDistanceLimits& limits) {
  LIMN_EXPECTS(labels.size() == mesh.vertex_count());
  if (settings.scheme != RefinementScheme::kCatmullClark) {
    return fail(ErrorKind::kUsage,
                "Only the distance to the limit surface of Catmull-Clark can be measured.");
  }
  std::vector<std::uint64_t> scratch;
  Sweep sweep(progress, scratch);
  sweep.begin_stage("Sorting triangles", 0.0, 0.05, 30 * refined.face_count());
  MeasuredMesh measured(refined, sweep);

  SubdivisionSettings at_limit = settings;
  at_limit.points = SurfacePoints::kLimit;
  const double nothing = kNothing * mesh.bounds().diagonal();
  LimitDistance result;
  double done = 0.05;
  int levels = refined.polygon_count() > 0 ? 1 : 0;
  while ((refined.face_count() << (2 * levels)) < kFewestFaces) {
    ++levels;
  }
  for (int round = 0; levels < kHighestLabel; ++round, ++levels) {
    const VertexLabels finer = raised(labels, levels);
    // Six samples in each of two triangles, and a vertex, on either side.
    const std::uint64_t samples = 26 * predict_refinement(mesh, finer).faces;
    if (round > 1 && samples > limits.samples) {
      break;
    }
    const double until = done + 0.5 * (1.0 - done);
    const double refining = done + 0.1 * (until - done);
    PartOfMeasuring part(progress, done, refining);
    Result<RefinedMesh> points = refine(mesh, finer, at_limit, {.normals = true}, part);
    if (!points) {
      return tl::unexpected(std::move(points.error()));
    }
    LIMN_EXPECTS(points->origin == refined.origin);
    sweep.begin_stage("Measuring", refining, until, 2 * samples);
    done = until;
    const LimitSurface limit(std::move(*points), sweep);
    measured.set_parts(1u << levels);
    LimitDistance now = measure(measured, limit, refined.face_count(), sweep);
    if (sweep.is_cancelled()) {
      return cancelled();
    }
    now.is_settled = round > 0 &&
                     has_settled(result.to_limit, now.to_limit, limits.change, nothing) &&
                     has_settled(result.from_limit, now.from_limit, limits.change, nothing);
    result = std::move(now);
    if (result.is_settled) {
      break;
    }
  }
  for (DirectedDistance* directed : {&result.to_limit, &result.from_limit}) {
    directed->from += refined.origin;
    directed->to += refined.origin;
  }
  return result;
}

}  // namespace limn
