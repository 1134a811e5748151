#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "limn/mesh/halfedge_mesh.h"

namespace limn {

/// The result of an adaptive subdivision: quads, the non-quad control faces that stayed as they
/// were, and where each came from.
///
/// Vertices 0..control vertex count - 1 are the control mesh's, in its order. Faces are numbered
/// quads first, then the others.
struct RefinedMesh {
  std::vector<glm::vec3> positions;         ///< In the control mesh's units and frame.
  std::vector<std::uint8_t> vertex_levels;  ///< Level k at which the vertex was made or last moved:
                                            ///< its position is P_k of uniform Catmull-Clark.

  std::vector<std::array<std::uint32_t, 4>> quads;  ///< Counter-clockwise vertex indices.
  std::vector<std::uint32_t> polygon_offsets{
      0};                                       ///< Faces that are no quads: prefix sums of sides,
  std::vector<std::uint32_t> polygon_vertices;  ///< and their vertices.

  std::vector<std::uint32_t> face_control_faces;  ///< For every face the control face it lies in.
  std::vector<std::uint8_t> face_levels;          ///< For every face the level it was made at.

  [[nodiscard]] std::size_t vertex_count() const noexcept { return positions.size(); }
  [[nodiscard]] std::size_t polygon_count() const noexcept { return polygon_offsets.size() - 1; }
  [[nodiscard]] std::size_t face_count() const noexcept { return quads.size() + polygon_count(); }
  /// Vertices of face f, quads and others alike.
  [[nodiscard]] std::span<const std::uint32_t> face(std::size_t f) const noexcept;
  /// Bytes of the elements of all arrays: what a prediction foretells.
  [[nodiscard]] std::size_t bytes() const noexcept;
};

/// The refined mesh as a half-edge mesh with the same vertex and face numbers.
[[nodiscard]] HalfedgeMesh to_halfedge_mesh(const RefinedMesh& mesh);

}  // namespace limn
