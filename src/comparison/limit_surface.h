#pragma once

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "comparison/directed_sampling.h"
#include "comparison/tree_surface.h"
#include "limn/mesh/large_array.h"
#include "limn/mesh/refined_mesh.h"

// Internal to this folder. Coordinates are relative to RefinedMesh::origin; groups are control
// faces.
namespace limn {

/// The refined mesh, to be measured.
class MeasuredMesh : public TreeSurface<float> {
 public:
  /// `mesh` must outlive this.
  MeasuredMesh(const RefinedMesh& mesh, Sweep& sweep)
      : TreeSurface(cut_surface(mesh, sweep), sweep), mesh_(&mesh) {}

  /// For every control face, into how many parts its triangles' sides are cut; 0: not looked at.
  void set_parts(std::vector<std::uint32_t> parts) { parts_ = std::move(parts); }

  [[nodiscard]] glm::dvec3 point(std::uint32_t t, const glm::dvec3& weights) const noexcept {
    return linear_point(t, weights);
  }
  [[nodiscard]] std::uint32_t group(std::uint32_t t) const noexcept {
    return mesh_->face_control_faces[face(t)];
  }
  [[nodiscard]] std::uint32_t parts(std::uint32_t t) const noexcept { return parts_[group(t)]; }
  [[nodiscard]] NearestSurface nearest(const glm::dvec3& p, std::uint32_t hint) const {
    const NearestPoint nearest = nearest_linear(p, hint);
    return {std::sqrt(nearest.square), linear_point(nearest.triangle, nearest.weights),
            nearest.triangle};
  }

 private:
  const RefinedMesh* mesh_;
  std::vector<std::uint32_t> parts_;
};

/// The limit surface, known by points and normals. Between these it is the linear triangle x, moved
/// half way to the mean of its projections on the corners' tangent planes, which is exact for
/// surfaces of second order:
///
///   x = sum w_i x_i,   s(x) = x + 1/2 sum w_i ((x_i - x) . n_i) n_i
///
/// The nearest point is looked for on the linear triangles, and moved with them.
class LimitSurface : public TreeSurface<float> {
 public:
  /// `points`: a refinement at SurfacePoints::kLimit, with normals. `is_looked_at`: for every
  /// control face.
  LimitSurface(RefinedMesh points, std::vector<bool> is_looked_at, Sweep& sweep);

  [[nodiscard]] glm::dvec3 point(std::uint32_t t, const glm::dvec3& weights) const noexcept;
  [[nodiscard]] std::uint32_t group(std::uint32_t t) const noexcept {
    return control_faces_[face(t)];
  }
  [[nodiscard]] std::uint32_t parts(std::uint32_t t) const noexcept {
    return is_looked_at_[group(t)] ? 1 : 0;
  }
  [[nodiscard]] NearestSurface nearest(const glm::dvec3& p, std::uint32_t hint) const;

 private:
  LargeArray<glm::vec3> normals_;
  LargeArray<std::uint32_t> control_faces_;
  std::vector<bool> is_looked_at_;
};

}  // namespace limn
