#pragma once

#include <cstdint>
#include <span>

#include <glm/vec3.hpp>

#include "limn/mesh/control_mesh.h"
#include "limn/subdivision/labels.h"
#include "subdivision/flat_array.h"

// One level of a refinement as flat arrays. Internal to this folder.
namespace limn {

/// `Level::twins` across a boundary edge of the control mesh.
inline constexpr std::uint32_t kBoundary = 0xFFFFFFFFu;
/// `Level::twins` towards a face of the level-k mesh that this level does not hold.
inline constexpr std::uint32_t kMissing = 0xFFFFFFFEu;

/// The part of the level-k mesh (k uniform steps) that the refinement still needs: the faces whose
/// parent was split, and the virtual faces beside Y-elements that stand in vertex rings only.
///
/// A corner is a (face, side) pair and stands for the half-edge from its vertex to the next one of
/// its face. From level 1 on all faces are quads and corner 4 f + i is side i of face f. Vertices
/// are numbered for this level alone; `vertex_outputs` says where they go.
struct Level {
  int number = 0;  ///< k
  FlatArray<std::uint32_t> corner_vertices;
  FlatArray<std::uint32_t> twins;  ///< Opposite corner, kBoundary or kMissing.

  FlatArray<std::uint32_t> face_control_faces;
  FlatArray<std::uint8_t> face_is_virtual;  ///< 1: never emitted, all its labels are 0.

  FlatArray<glm::dvec3> positions;  ///< P_k, relative to the refined mesh's origin.
  FlatArray<std::uint8_t> labels;
  FlatArray<std::uint32_t> vertex_outputs;  ///< Vertex of the RefinedMesh; kNone for a virtual one.
  /// The corner at which the counter-clockwise walk around the vertex starts; at a boundary vertex
  /// the one on the boundary edge that leaves it. kNone for a virtual vertex, which has no ring.
  FlatArray<std::uint32_t> vertex_corners;

  [[nodiscard]] std::size_t corner_count() const noexcept { return corner_vertices.size(); }
  [[nodiscard]] std::size_t face_count() const noexcept { return face_control_faces.size(); }
  [[nodiscard]] std::size_t vertex_count() const noexcept { return positions.size(); }
};

/// How corners go around the faces of an all-quad level.
struct QuadSides {
  [[nodiscard]] static std::uint32_t next(std::uint32_t c) noexcept {
    return (c & ~3u) | ((c + 1) & 3u);
  }
  [[nodiscard]] static std::uint32_t previous(std::uint32_t c) noexcept {
    return (c & ~3u) | ((c + 3) & 3u);
  }
  [[nodiscard]] static std::uint32_t face(std::uint32_t c) noexcept { return c >> 2; }
  [[nodiscard]] static std::uint32_t side(std::uint32_t c) noexcept { return c & 3u; }
  [[nodiscard]] static std::uint32_t first(std::size_t f) noexcept {
    return static_cast<std::uint32_t>(4 * f);
  }
  [[nodiscard]] static std::uint32_t sides(std::size_t) noexcept { return 4; }
};

/// The same for a control mesh with other polygons.
struct PolygonSides {
  std::span<const std::uint32_t> face_offsets;
  std::span<const std::uint32_t> corner_faces;

  [[nodiscard]] std::uint32_t next(std::uint32_t c) const noexcept {
    const std::uint32_t f = corner_faces[c];
    return c + 1 == face_offsets[f + 1] ? face_offsets[f] : c + 1;
  }
  [[nodiscard]] std::uint32_t previous(std::uint32_t c) const noexcept {
    const std::uint32_t f = corner_faces[c];
    return c == face_offsets[f] ? face_offsets[f + 1] - 1 : c - 1;
  }
  [[nodiscard]] std::uint32_t face(std::uint32_t c) const noexcept { return corner_faces[c]; }
  [[nodiscard]] std::uint32_t side(std::uint32_t c) const noexcept {
    return c - face_offsets[corner_faces[c]];
  }
  [[nodiscard]] std::uint32_t first(std::size_t f) const noexcept { return face_offsets[f]; }
  [[nodiscard]] std::uint32_t sides(std::size_t f) const noexcept {
    return face_offsets[f + 1] - face_offsets[f];
  }
};

/// The control mesh as level 0, with positions relative to `origin`.
[[nodiscard]] Level seed_level(const ControlMesh& mesh, const VertexLabels& labels,
                               const glm::dvec3& origin);

}  // namespace limn
