#pragma once

#include <cstdint>
#include <span>

#include "limn/mesh/large_array.h"
#include "subdivision/cage.h"
#include "subdivision/sweep.h"

// Which numbers everything has in the refined mesh, before anything is made. Internal to this
// folder.
namespace limn {

class FineCounts;

/// Totals of a refinement.
struct RefinedCounts {
  std::uint64_t quads = 0;
  std::uint64_t vertices = 0;
  std::uint64_t polygons = 0;  ///< Faces that are no quads and stay.
  std::uint64_t polygon_sides = 0;
};

/// The cage's vertices keep their numbers. Then, face by face, come the vertices on the sides whose
/// first corner (FlatTopology::edge_corners) is the face's, then those inside; quads come face by
/// face.
class Numbering {
 public:
  /// Labels as the refinement sees them, one per vertex of the cage, legal.
  /// `fine`: what becomes of faces of which labels of finer levels are given; null for none.
  /// Arrays of an earlier build are used again.
  RefinedCounts build(Sweep& sweep, const Cage& cage, std::span<const std::uint8_t> labels,
                      const FineCounts* fine);

  /// How many levels down each face goes, the greatest label at its corners unless labels of finer
  /// levels are given: 0 where it stays as it is.
  [[nodiscard]] std::span<const std::uint8_t> greatest() const noexcept { return greatest_; }

  /// First quad of a face; where it is a polygon that stays, its number among these.
  [[nodiscard]] std::uint32_t first_face(std::size_t f) const noexcept { return faces_[f]; }
  [[nodiscard]] std::uint32_t first_polygon_side(std::size_t f) const noexcept {
    return polygon_sides_[f];
  }
  /// First vertex inside a face; unset where the face stays.
  [[nodiscard]] std::uint32_t first_inside(std::size_t f) const noexcept { return insides_[f]; }
  /// First vertex on an edge, from the vertex of its first corner on; unset where it is not split.
  [[nodiscard]] std::uint32_t first_on_edge(std::size_t e) const noexcept { return edges_[e]; }
  void prefetch_edge(std::size_t e) const noexcept { __builtin_prefetch(&edges_[e]); }

 private:
  LargeArray<std::uint32_t> faces_;
  LargeArray<std::uint32_t> polygon_sides_;  ///< Empty where all are quads.
  LargeArray<std::uint32_t> insides_;
  LargeArray<std::uint32_t> edges_;
  LargeArray<std::uint8_t> greatest_;
};

/// The labels at a face's corners, as a range of any length.
class FaceLabels {
 public:
  FaceLabels(const Cage& cage, std::span<const std::uint8_t> labels, std::size_t f)
      : labels_(labels.data()),
        vertices_(cage.topology->corner_vertices.data() + cage.first_corner(f)),
        size_(cage.side_count(f)) {}
  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] std::uint8_t operator[](std::size_t i) const noexcept {
    return labels_[vertices_[i]];
  }

 private:
  const std::uint8_t* labels_;
  const std::uint32_t* vertices_;
  std::size_t size_;
};

}  // namespace limn
