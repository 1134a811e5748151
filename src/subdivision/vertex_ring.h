#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "limn/mesh/creases.h"
#include "subdivision/limit_point.h"
#include "subdivision/point.h"
#include "subdivision/sharpness.h"
#include "subdivision/vertex_rule.h"

// Internal to this folder.
namespace limn {

/// A vertex with its neighbours along edges e_i and the centroids c_i of the faces around it: what
/// one Catmull-Clark step turns into the same of the next level, for any valence, any face sizes,
/// boundaries, and semi-sharp creases and corners (algorithm.md's centroid form; DeRose, Kass &
/// Truong 1998; the rules of OpenSubdiv's Sdc::Scheme<SCHEME_CATMARK>).
///
/// n faces, counter-clockwise. Face i lies between edges i and i + 1. An interior vertex has n
/// edges (edge n is edge 0 again); a boundary vertex has n + 1, the first and the last on the
/// boundary. Meant to be kept and `reset`: it allocates only where a vertex has more faces than any
/// before.
///
/// To use one: `reset`, set centre, edges and centroids, and sharpness where there is any; then
/// `step` from level to level, reading the same accessors, and ask for the `limit` at any of them.
class VertexRing {
 public:
  /// Makes room for a vertex with n faces: nothing sharp but the boundary, points unset. n >= 1 at
  /// a boundary, and >= 2 inside.
  void reset(std::size_t faces, bool is_boundary);

  [[nodiscard]] std::size_t face_count() const noexcept { return centroids_.size(); }
  [[nodiscard]] bool is_boundary() const noexcept { return edges_.size() > centroids_.size(); }

  [[nodiscard]] Point& centre() noexcept { return centre_; }
  [[nodiscard]] std::span<Point> edges() noexcept { return edges_; }
  [[nodiscard]] std::span<Point> centroids() noexcept { return centroids_; }
  [[nodiscard]] const Point& centre() const noexcept { return centre_; }
  [[nodiscard]] std::span<const Point> edges() const noexcept { return edges_; }
  [[nodiscard]] std::span<const Point> centroids() const noexcept { return centroids_; }

  /// Of edge i; after a step, of its half at this vertex. Boundary edges are infinitely sharp
  /// whatever is said here. 0 or less is smooth, kInfiniteSharpness or more never wears off.
  [[nodiscard]] std::span<float> edge_sharpness() noexcept { return edge_sharpness_; }
  [[nodiscard]] std::span<const float> edge_sharpness() const noexcept { return edge_sharpness_; }
  [[nodiscard]] float& vertex_sharpness() noexcept { return vertex_sharpness_; }
  [[nodiscard]] float vertex_sharpness() const noexcept { return vertex_sharpness_; }
  /// For CreasingMethod::kChaikin alone, and only where edge i is semi-sharp: the mean sharpness of
  /// the other semi-sharp edges at the far end of edge i (infinitely sharp ones do not count), 0
  /// where there is none (SharpnessSum::mean_besides).
  [[nodiscard]] std::span<float> far_sharpness() noexcept { return far_sharpness_; }

  /// The ring of the same vertex one level down; sharpness wears off by `method`.
  /// A boundary vertex of one face is a corner where `corners` is kSharp.
  void step(CreasingMethod method, CornerRule corners);

  /// Steps until nothing is semi-sharp any more, which leaves the limit as it is and cheap to ask
  /// for.
  void step_until_worn(CreasingMethod method, CornerRule corners);

  /// The limit of the vertex, semi-sharp creases worn off first. The ring is left as it was, and
  /// the answer is the same at every level, which OpenSubdiv's is not where it takes a mask of
  /// another rule for an approximation: at darts (ends of infinitely sharp creases), and for the
  /// normals of creases and boundaries with other than one or two faces. Its answers tend to these
  /// from level to level.
  ///
  /// Normals: on a crease inside, that of the side counter-clockwise of its first edge, as in
  /// OpenSubdiv. At a corner the surface has no tangent plane in general: where sharp edges meet it
  /// is the normal of the face counter-clockwise of the first of them (OpenSubdiv's, where this
  /// is edge 0), the tip of a cone has its axis.
  [[nodiscard]] LimitPoint limit(CreasingMethod method, CornerRule corners) const;

 private:
  [[nodiscard]] bool is_smooth() const noexcept;
  [[nodiscard]] bool wears_off() const noexcept;
  void sharpen_boundary(CornerRule corners) noexcept;
  [[nodiscard]] Point smooth_centre() const noexcept;
  void add_moved_centre(double weight, VertexRule rule, const SharpEdges& sharp,
                        Point& sum) const noexcept;
  [[nodiscard]] WornOff worn_off(float child_vertex_sharpness) const noexcept;
  void step_smooth();
  void step_sharp(CreasingMethod method);
  void wear_off(CreasingMethod method);
  void step_centroids();

  [[nodiscard]] Point smooth_limit() const noexcept;
  [[nodiscard]] LimitPoint limit_without_wear() const;
  [[nodiscard]] LimitPoint dart_limit(std::size_t dart) const;
  [[nodiscard]] glm::dvec3 smooth_normal() const noexcept;
  [[nodiscard]] glm::dvec3 crease_normal(std::size_t first, std::size_t last) const noexcept;

  Point centre_{};
  std::vector<Point> edges_;
  std::vector<Point> centroids_;
  std::vector<float> edge_sharpness_;
  std::vector<float> far_sharpness_;
  std::vector<float> child_sharpness_;  // Of a step in progress.
  float vertex_sharpness_ = 0.0f;
};

}  // namespace limn
