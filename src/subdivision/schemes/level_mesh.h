#pragma once

#include <cstddef>
#include <cstdint>

#include <glm/vec3.hpp>

#include "limn/mesh/control_mesh.h"
#include "limn/mesh/creases.h"
#include "limn/mesh/large_array.h"
#include "subdivision/point.h"

// Internal to this folder.
namespace limn {

/// The faces of a level. Half-edge h runs from vertex `corners[h]` to the next one's in its face.
struct LevelFaces {
  std::uint32_t sides = 0;           ///< Of every face; 0 where they differ.
  LargeArray<std::uint32_t> starts;  ///< F + 1, prefix sums of sides; empty unless they differ.
  LargeArray<std::uint32_t> corners;
  LargeArray<std::uint32_t> control_faces;  ///< F.

  [[nodiscard]] std::size_t count() const noexcept { return control_faces.size(); }
  [[nodiscard]] std::uint32_t first(std::size_t f) const noexcept {
    return sides == 0 ? starts[f] : static_cast<std::uint32_t>(f) * sides;
  }
};

/// A mesh between two steps of a scheme.
struct LevelMesh {
  int level = 0;
  LevelFaces faces;
  LargeArray<std::uint32_t> twins;  ///< The half-edge on the other side; kNone at a boundary.
  LargeArray<std::uint32_t> edges;  ///< Of every half-edge, its number.
  LargeArray<std::uint32_t> half_edge_faces;  ///< Empty where all faces have as many sides.
  /// Of every vertex a half-edge that starts there; at a boundary vertex the one on the boundary.
  LargeArray<std::uint32_t> vertex_starts;
  std::size_t edge_count = 0;
  LargeArray<Point> points;  ///< Relative to RefinedMesh::origin.

  /// One per edge and per vertex, or empty: nothing is sharp but the boundary.
  LargeArray<float> edge_sharpness;
  LargeArray<float> vertex_sharpness;
  CreasingMethod creasing = CreasingMethod::kUniform;

  [[nodiscard]] std::size_t vertex_count() const noexcept { return points.size(); }
  [[nodiscard]] std::size_t half_edge_count() const noexcept { return faces.corners.size(); }
  [[nodiscard]] bool has_creases() const noexcept {
    return !edge_sharpness.empty() || !vertex_sharpness.empty();
  }
  [[nodiscard]] std::uint32_t face_of(std::uint32_t h) const noexcept {
    return faces.sides == 0 ? half_edge_faces[h] : h / faces.sides;
  }
  [[nodiscard]] std::uint32_t next(std::uint32_t h) const noexcept {
    const std::uint32_t f = face_of(h);
    return h + 1 == faces.first(f + 1) ? faces.first(f) : h + 1;
  }
  [[nodiscard]] std::uint32_t previous(std::uint32_t h) const noexcept {
    const std::uint32_t f = face_of(h);
    return h == faces.first(f) ? faces.first(f + 1) - 1 : h - 1;
  }
  [[nodiscard]] std::uint32_t start(std::uint32_t h) const noexcept { return faces.corners[h]; }
  [[nodiscard]] std::uint32_t end(std::uint32_t h) const noexcept { return faces.corners[next(h)]; }
  /// Of the two half-edges of an edge, one: it gives the edge its direction.
  [[nodiscard]] bool is_first(std::uint32_t h) const noexcept { return h < twins[h]; }
  [[nodiscard]] bool is_boundary_vertex(std::uint32_t v) const noexcept {
    return twins[vertex_starts[v]] == kNone;
  }
  /// Of the edge, boundary edges being infinitely sharp.
  [[nodiscard]] float sharpness(std::uint32_t h) const noexcept {
    if (twins[h] == kNone) {
      return kInfiniteSharpness;
    }
    return edge_sharpness.empty() ? 0.0f : edge_sharpness[edges[h]];
  }

  /// Calls `visit(h)` for the half-edges that start at vertex v, counter-clockwise, from
  /// vertex_starts[v] on. Returns the half-edge that arrives by the other boundary edge, or kNone
  /// inside.
  template <class Visit>
  std::uint32_t around(std::uint32_t v, const Visit& visit) const {
    const std::uint32_t first = vertex_starts[v];
    std::uint32_t h = first;
    do {
      visit(h);
      const std::uint32_t arriving = previous(h);
      h = twins[arriving];
      if (h == kNone) {
        return arriving;
      }
    } while (h != first);
    return kNone;
  }
};

/// Level 0, with points relative to `origin`.
[[nodiscard]] LevelMesh level_of(const ControlMesh& mesh, const glm::dvec3& origin);

/// Matches the faces' half-edges: twins, edges and vertex_starts. For splits that do not know them
/// in closed form.
void connect(std::size_t vertices, LevelMesh& mesh);

/// The face of every half-edge, where faces differ.
void number_half_edge_faces(LevelMesh& mesh);

}  // namespace limn
