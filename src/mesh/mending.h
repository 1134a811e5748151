#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/edge_matching.h"

namespace limn::detail {

/// Faces of a soup on their way to a manifold.
struct WorkingFaces {
  std::vector<std::uint32_t> offsets{0};
  std::vector<std::uint32_t> vertices;
  std::vector<std::uint32_t> uvs;  ///< One per corner, or empty; goes wherever its corner goes.
  std::size_t vertex_count = 0;

  [[nodiscard]] FaceArrays arrays() const noexcept { return {offsets, vertices, vertex_count}; }
};

/// How to make neighbours run along their common edge in opposite directions.
struct Orientation {
  std::vector<std::uint8_t> is_flipped;  ///< F, 1 where the face has to be reversed.
  std::size_t flipped_faces = 0;
  /// A face whose neighbours cannot all agree, or kNone.
  std::uint32_t one_sided_face;
};

/// Floods each component over its edges and flips the smaller side, by number of faces; of two
/// equal sides the one without the component's first face.
[[nodiscard]] Orientation orient(const FaceArrays& faces, const EdgeMatching& edges);

/// Reverses the flagged faces, each about its first corner, and renumbers the matching's corners.
void flip_faces(const std::vector<std::uint8_t>& is_flipped, WorkingFaces& faces,
                EdgeMatching& edges);

/// Gives every fan of faces around a vertex a vertex of its own and renumbers the vertices: those
/// in use keep their order, copies come last.
struct Fans {
  std::vector<std::uint32_t> vertex_sources;  ///< For every new vertex the old one.
  std::size_t split_vertices = 0;             ///< Copies made.
  std::size_t isolated_vertices = 0;          ///< Old vertices in no face.
};

/// `faces` must be oriented; their vertices are rewritten. The matching stays as it is.
[[nodiscard]] Fans separate_fans(WorkingFaces& faces, const EdgeMatching& edges);

}  // namespace limn::detail
