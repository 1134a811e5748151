#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace limn::detail {

/// Polygons as prefix sums of sides and corner vertices, as in PolygonSoup.
struct FaceArrays {
  std::span<const std::uint32_t> offsets;   ///< F + 1.
  std::span<const std::uint32_t> vertices;  ///< C.
  std::size_t vertex_count = 0;             ///< All of `vertices` lie below it.

  [[nodiscard]] std::size_t face_count() const noexcept { return offsets.size() - 1; }
};

/// Which corners share an undirected edge. Corner c names the edge from its vertex to the next of
/// its face.
struct CornerMatching {
  std::vector<std::uint32_t> twins;  ///< C, the other corner at the edge; kNone on a boundary and
                                     ///< at crowded edges: those with three or more corners, or
                                     ///< with one face on both sides.
  /// The corners of each crowded edge, rising, and prefix sums of their counts; edges in the order
  /// of their first corners.
  std::vector<std::uint32_t> crowded_corners;
  std::vector<std::uint32_t> crowded_offsets{0};

  [[nodiscard]] bool is_crowded() const noexcept { return !crowded_corners.empty(); }
};

/// Matches corners in linear time. No face may have the same vertex twice in a row.
[[nodiscard]] CornerMatching match_corners(const FaceArrays& faces);

/// Edges by number, and their corners.
struct EdgeMatching {
  std::vector<std::uint32_t> corner_edges;  ///< C.
  /// E, numbered as first met when walking the corners; second is kNone on a boundary.
  std::vector<std::array<std::uint32_t, 2>> edge_corners;

  /// The other corner at corner c's edge, or kNone.
  [[nodiscard]] std::uint32_t twin(std::uint32_t c) const noexcept {
    const auto& pair = edge_corners[corner_edges[c]];
    return pair[0] == c ? pair[1] : pair[0];
  }
};

[[nodiscard]] EdgeMatching number_edges(std::span<const std::uint32_t> twins);

/// The edges of a manifold. No edge may be crowded.
[[nodiscard]] EdgeMatching match_edges(const FaceArrays& faces);

/// The face of every corner.
[[nodiscard]] std::vector<std::uint32_t> corner_faces(std::span<const std::uint32_t> face_offsets);

}  // namespace limn::detail
