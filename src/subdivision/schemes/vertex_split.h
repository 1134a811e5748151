#pragma once

#include <cstddef>
#include <cstdint>

#include "subdivision/schemes/boundary_edges.h"
#include "subdivision/schemes/level_mesh.h"

// Internal to this folder: the connectivity of Doo-Sabin and its kin.
namespace limn {

/// The vertices that take the place of the old ones: one per corner of a face, with its
/// half-edge's number; two on every boundary edge; and the corners that stay (marked_corners.h).
class VertexSplit {
 public:
  explicit VertexSplit(const LevelMesh& from);

  [[nodiscard]] const BoundaryEdges& boundary() const noexcept { return boundary_; }
  /// On boundary half-edge h, near its start or its end.
  [[nodiscard]] std::uint32_t near_start(std::uint32_t h) const noexcept {
    return inner_ + 2 * boundary_.ranks[from_->edges[h]];
  }
  [[nodiscard]] std::uint32_t near_end(std::uint32_t h) const noexcept { return near_start(h) + 1; }
  /// The marked corners in growing order, and the new vertex of the first.
  [[nodiscard]] const LargeArray<std::uint32_t>& corners() const noexcept { return corners_; }
  [[nodiscard]] std::uint32_t first_corner() const noexcept {
    return inner_ + 2 * static_cast<std::uint32_t>(boundary_.half_edges.size());
  }
  [[nodiscard]] std::size_t vertex_count() const noexcept {
    return first_corner() + corners_.size();
  }

 private:
  const LevelMesh* from_;
  std::uint32_t inner_;
  BoundaryEdges boundary_;
  LargeArray<std::uint32_t> corners_;
};

/// An n-gon for each face, then a quad for each edge in the order of its first half-edge, then a
/// k-gon for each vertex with k faces inside, k + 2 at a boundary, one more at a corner that stays.
/// A vertex inside between two faces gets none.
[[nodiscard]] LevelFaces split_vertices(const LevelMesh& from);
[[nodiscard]] std::size_t vertex_split_vertices(const LevelMesh& from);
void connect_vertex_split(const LevelMesh& from, LevelMesh& to);

}  // namespace limn
