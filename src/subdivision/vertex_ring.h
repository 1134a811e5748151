#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "limn/mesh/creases.h"
#include "subdivision/point.h"

// Internal to this folder.
namespace limn {

/// Where a vertex of the surface ends up, and the direction out of the surface there.
struct LimitPoint {
  glm::dvec3 position{0.0};
  glm::dvec3 normal{0.0};  ///< Of length 1; 0 where the surface has no tangent plane.
};

/// A vertex with its neighbours along edges e_i and the centroids c_i of the faces around it: what
/// one Catmull-Clark step turns into the same of the next level, for any valence, any face sizes,
/// boundaries, and semi-sharp creases and corners (algorithm.md's centroid form; DeRose, Kass &
/// Truong 1998; the rules of OpenSubdiv's Sdc::Scheme<SCHEME_CATMARK>).
///
/// n faces, counter-clockwise. Face i lies between edges i and i + 1. An interior vertex has n
/// edges (edge n is edge 0 again); a boundary vertex has n + 1, the first and the last on the
/// boundary. Meant to be kept and `reset`: it allocates only where a vertex has more faces than any
/// before.
class VertexRing {
 public:
  /// Makes room for a vertex with n faces; all sharpness 0, points unset. n >= 1, at a boundary,
  /// and
  /// >= 2 inside.
  void reset(std::size_t faces, bool is_boundary);

  [[nodiscard]] std::size_t face_count() const noexcept { return centroids_.size(); }
  [[nodiscard]] bool is_boundary() const noexcept { return edges_.size() > centroids_.size(); }

  [[nodiscard]] Point& centre() noexcept { return centre_; }
  [[nodiscard]] std::span<Point> edges() noexcept { return edges_; }
  [[nodiscard]] std::span<Point> centroids() noexcept { return centroids_; }
  /// Of edge i, boundary edges aside (these are sharp whatever is said here).
  [[nodiscard]] std::span<float> edge_sharpness() noexcept { return edge_sharpness_; }
  [[nodiscard]] float& vertex_sharpness() noexcept { return vertex_sharpness_; }

  /// The ring of the same vertex one level down; sharpness wears off by `method`.
  /// A boundary vertex of one face is a corner where `corners` is kSharp.
  void step(CreasingMethod method, CornerRule corners);

  /// The limit of the vertex, semi-sharp creases worn off first. The ring is left as it was. A
  /// normal on a crease is that of one side, the one OpenSubdiv takes.
  [[nodiscard]] LimitPoint limit(CreasingMethod method, CornerRule corners) const;

 private:
  Point centre_{};
  std::vector<Point> edges_;
  std::vector<Point> centroids_;
  std::vector<float> edge_sharpness_;
  float vertex_sharpness_ = 0.0f;
};

}  // namespace limn
