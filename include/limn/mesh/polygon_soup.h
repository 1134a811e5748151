#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "limn/mesh/creases.h"

namespace limn {

/// An edge that a file wants sharp, named by its ends. They need not be an edge of the mesh.
struct CreaseTag {
  std::array<std::uint32_t, 2> vertices{};
  float sharpness = 0.0f;
};

/// A vertex that a file wants sharp. It need not be a vertex of the mesh.
struct CornerTag {
  std::uint32_t vertex = 0;
  float sharpness = 0.0f;
};

/// What a mesh file says, before anyone has asked whether it is a surface.
///
/// Face f has the corners `face_vertices[face_offsets[f] .. face_offsets[f + 1])`, indices into
/// `positions`, 0-based, in the file's order. `face_offsets` has one entry more than there are
/// faces and starts with 0. The two line arrays are either empty (a mesh made in memory) or hold
/// the 1-based source line of every vertex and face.
struct PolygonSoup {
  std::vector<glm::dvec3> positions;
  std::vector<std::uint32_t> face_offsets{0};
  std::vector<std::uint32_t> face_vertices;
  std::vector<std::uint32_t> vertex_lines;
  std::vector<std::uint32_t> face_lines;

  /// In the file's order: of several for one edge or vertex the last counts. Sharpness is finite.
  std::vector<CreaseTag> creases;
  std::vector<CornerTag> corners;
  CreasingMethod creasing = CreasingMethod::kUniform;
  std::optional<CornerRule> corner_rule;

  /// Texture coordinates, and for each corner in `face_vertices` the one it has. An index beyond
  /// `uvs` says that a corner has none; an empty `face_uvs` that no corner has.
  std::vector<glm::dvec2> uvs;
  std::vector<std::uint32_t> face_uvs;

  std::string source;  ///< Path or name for messages; may be empty.

  [[nodiscard]] std::size_t face_count() const noexcept { return face_offsets.size() - 1; }
  [[nodiscard]] std::span<const std::uint32_t> face(std::size_t f) const noexcept {
    return std::span(face_vertices).subspan(face_offsets[f], face_offsets[f + 1] - face_offsets[f]);
  }
  void add_face(std::span<const std::uint32_t> vertices) {
    face_vertices.insert(face_vertices.end(), vertices.begin(), vertices.end());
    face_offsets.push_back(static_cast<std::uint32_t>(face_vertices.size()));
  }
};

}  // namespace limn
