#pragma once

#include <cstdint>
#include <span>

#include "limn/mesh/large_array.h"
#include "subdivision/cage.h"
#include "subdivision/crease_rows.h"
#include "subdivision/limit_point.h"
#include "subdivision/sweep.h"

// The neighbourhoods that are no regular grid. Internal to this folder.
namespace limn {

/// A vertex and its neighbours along edges at successive levels: what grids cannot compute by
/// themselves around an irregular vertex.
class RingView {
 public:
  RingView() = default;
  RingView(const Point* points, std::size_t edges, int first_level, int last_level)
      : points_(points), edges_(edges), first_level_(first_level), last_level_(last_level) {}

  [[nodiscard]] bool exists() const noexcept { return points_ != nullptr; }
  [[nodiscard]] std::size_t edge_count() const noexcept { return edges_; }
  [[nodiscard]] const Point& centre(int level) const noexcept { return *at(level); }
  [[nodiscard]] const Point& edge(int level, std::size_t i) const noexcept {
    return at(level)[1 + i];
  }
  /// Where tables with limits were asked for.
  [[nodiscard]] LimitPoint limit() const noexcept {
    return {to_vec3(points_[-2]), to_vec3(points_[-1])};
  }

 private:
  /// Past the last level stands the last: such points are computed around, never used.
  [[nodiscard]] const Point* at(int level) const noexcept {
    const int kept = level < last_level_ ? level : last_level_;
    return points_ + static_cast<std::size_t>(kept - first_level_) * (edges_ + 1);
  }

  const Point* points_ = nullptr;
  std::size_t edges_ = 0;
  int first_level_ = 1;
  int last_level_ = 0;
};

class VertexRing;

/// Whether the points around a vertex are none of a regular grid: see RingTables.
[[nodiscard]] bool is_irregular(const Cage& cage, std::uint32_t v, const Fan& fan);

/// The rings of all irregular vertices that a refinement comes near, from level 1 on, and of the
/// centres of faces that are no quads, from level 1 on as well.
///
/// Irregular are interior vertices that have not four quads, boundary vertices that have not two,
/// ends of sharp edges, and sharp vertices.
class RingTables {
 public:
  /// From the greatest label of each face. Arrays of an earlier build are used again.
  /// `with_limits`: rings know their limits too.
  void build(Sweep& sweep, const Cage& cage, std::span<const std::uint8_t> greatest,
             bool with_limits);

  /// The ring around vertex v; none where v is regular or nothing around it is refined.
  [[nodiscard]] RingView of_vertex(const Cage& cage, std::uint32_t v) const noexcept;
  /// The ring around the centre of face f, which is no quad and refined: edge i leads to the point
  /// on side i.
  [[nodiscard]] RingView of_face(const Cage& cage, std::uint32_t f) const noexcept;

  /// The sharpness along the edge that leaves a corner, in its direction.
  [[nodiscard]] SideSharpness sharpness(const Cage& cage, std::uint32_t corner) const noexcept {
    return rows_.of_corner(cage, corner);
  }
  /// The centroid of any face.
  [[nodiscard]] Point centroid(const Cage& cage, std::uint32_t f) const noexcept {
    return cage.side_count(f) == 4 ? cage.centroid(f) : centroids_[f];
  }
  /// Makes `ring` that of any vertex, at level 0.
  void seed(const Cage& cage, std::uint32_t v, VertexRing& ring) const;

 private:
  void build_centroids(Sweep& sweep, const Cage& cage, std::span<const std::uint8_t> greatest);
  void list_vertices(const Cage& cage);
  void number_points(Sweep& sweep, const Cage& cage);
  void run_vertex(const Cage& cage, std::uint32_t v);
  void run_face(const Cage& cage, std::uint32_t f);

  LargeArray<std::uint32_t> vertices_;       ///< The irregular ones.
  LargeArray<std::uint32_t> vertex_firsts_;  ///< Into points_, kNone: no ring.
  LargeArray<std::uint8_t> vertex_levels_;   ///< The last level of each irregular vertex's ring.
  LargeArray<std::uint32_t> face_firsts_;    ///< Likewise for faces; empty where all are quads.
  LargeArray<std::uint8_t> face_levels_;
  LargeArray<Point> centroids_;  ///< Of the faces that are no quads.
  LargeArray<Point> points_;     ///< Before a ring's, where asked for, its limit's two.
  bool has_limits_ = false;
  CreaseRows rows_;
};

}  // namespace limn
