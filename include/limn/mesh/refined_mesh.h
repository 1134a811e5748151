#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "limn/mesh/creases.h"
#include "limn/mesh/halfedge_mesh.h"
#include "limn/mesh/large_array.h"

namespace limn {

class ControlMesh;

/// An edge of a refined mesh that is still sharp. Boundary edges are not listed.
struct RefinedCrease {
  std::array<std::uint32_t, 2> vertices{};
  float sharpness = 0.0f;

  [[nodiscard]] bool operator==(const RefinedCrease&) const = default;
};

/// A vertex of a refined mesh that is still a corner by a sharpness of its own.
struct RefinedCorner {
  std::uint32_t vertex = 0;
  float sharpness = 0.0f;

  [[nodiscard]] bool operator==(const RefinedCorner&) const = default;
};

/// How many edges of a refined mesh a boundary edge of its control mesh has become.
struct RefinedBoundaryEdge {
  std::uint32_t control_edge = 0;
  std::uint32_t pieces = 0;

  [[nodiscard]] bool operator==(const RefinedBoundaryEdge&) const = default;
};

/// The result of an adaptive subdivision: quads, the non-quad control faces that stayed as they
/// were, and where each came from.
///
/// Vertices 0..control vertex count - 1 are the control mesh's, in its order. Faces are numbered
/// quads first, then the others.
///
/// Positions are single precision relative to `origin`. Most meshes lie close enough to the world's
/// origin for that to be their origin too, and then positions are plain world coordinates. Where
/// the rounding of world coordinates to float could move a vertex by more than 3e-7 of the control
/// mesh's diagonal, which is to say where its bounds reach further than some five diagonals from
/// the world's origin, `origin` is the centre of those bounds. So a vertex is never further than
/// that from where it belongs (diagonals below 1e-36, the end of float's range, excepted).
struct RefinedMesh {
  glm::dvec3 origin{0.0};                  ///< World position that `positions` are relative to.
  LargeArray<glm::vec3> positions;         ///< In the control mesh's units, along its axes.
  LargeArray<std::uint8_t> vertex_levels;  ///< Level k at which the vertex was made or last moved:
                                           ///< its position is P_k of uniform Catmull-Clark.

  LargeArray<std::array<std::uint32_t, 4>> quads;  ///< Counter-clockwise vertex indices.
  LargeArray<std::uint32_t> polygon_offsets{0};  ///< Faces that are no quads: prefix sums of sides,
  LargeArray<std::uint32_t> polygon_vertices;    ///< and their vertices.

  LargeArray<std::uint32_t> face_control_faces;  ///< For every face the control face it lies in.
  LargeArray<std::uint8_t> face_levels;          ///< For every face the level it was made at.

  /// Normals of the limit surface, of length 1 (0 where it has no tangent plane), one per vertex;
  /// empty unless asked for.
  LargeArray<glm::vec3> normals;

  /// Texture coordinates, where the control mesh has them: points of the texture plane, and for
  /// each corner of the quads and of the other faces the point it has. All empty where it has none.
  LargeArray<glm::vec2> uvs;
  LargeArray<std::array<std::uint32_t, 4>> quad_uvs;
  LargeArray<std::uint32_t> polygon_uvs;

  /// What is still sharp, with the sharpness that remains at the level an edge or vertex was made.
  std::vector<RefinedCrease> creases;
  std::vector<RefinedCorner> corners;
  /// Of those control faces alone that labels of finer levels were given for, ascending: of other
  /// boundary edges the levels of the ends tell.
  std::vector<RefinedBoundaryEdge> boundary_edges;
  /// By what rules it goes on: how sharpness wears off, and what becomes of boundary corners, where
  /// there is a boundary.
  CreasingMethod creasing = CreasingMethod::kUniform;
  std::optional<CornerRule> corner_rule;

  [[nodiscard]] std::size_t vertex_count() const noexcept { return positions.size(); }
  [[nodiscard]] std::size_t polygon_count() const noexcept { return polygon_offsets.size() - 1; }
  [[nodiscard]] std::size_t face_count() const noexcept { return quads.size() + polygon_count(); }
  /// World position of vertex v, in the control mesh's frame.
  [[nodiscard]] glm::dvec3 position(std::size_t v) const noexcept {
    return origin + glm::dvec3(positions[v]);
  }
  /// Vertices of face f, quads and others alike.
  [[nodiscard]] std::span<const std::uint32_t> face(std::size_t f) const noexcept;
  /// Bytes of the elements of all arrays: what a prediction foretells.
  [[nodiscard]] std::size_t bytes() const noexcept;
};

/// The refined mesh as a half-edge mesh with the same vertex and face numbers, in world
/// coordinates.
[[nodiscard]] HalfedgeMesh to_halfedge_mesh(const RefinedMesh& mesh);

/// The refined mesh as a control mesh with the same vertex and face numbers, in world coordinates.
/// It carries on what is still sharp, the rules and the texture coordinates, and from
/// `control`, which it was refined from, the names of faces and the loose vertices.
[[nodiscard]] std::shared_ptr<const ControlMesh> to_control_mesh(
    const RefinedMesh& mesh, const ControlMesh* control = nullptr);

}  // namespace limn
