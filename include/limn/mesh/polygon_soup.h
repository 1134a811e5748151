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
#include "limn/mesh/face_names.h"
#include "limn/mesh/import_report.h"

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
/// faces and starts with 0. The two arrays of places are either empty (a mesh made in memory) or
/// hold where every vertex and face stands in the file: its line, from 1, or its byte, from 0.
struct PolygonSoup {
  std::vector<glm::dvec3> positions;
  std::vector<std::uint32_t> face_offsets{0};
  std::vector<std::uint32_t> face_vertices;
  std::vector<std::uint32_t> vertex_places;
  std::vector<std::uint32_t> face_places;
  PlaceUnit place_unit = PlaceUnit::kLine;

  /// In the file's order: of several for one edge or vertex the last counts. Sharpness is finite.
  std::vector<CreaseTag> creases;
  std::vector<CornerTag> corners;
  CreasingMethod creasing = CreasingMethod::kUniform;
  std::optional<CornerRule> corner_rule;

  /// Texture coordinates, and for each corner in `face_vertices` the one it has. An index beyond
  /// `uvs` says that a corner has none; an empty `face_uvs` that no corner has.
  std::vector<glm::dvec2> uvs;
  std::vector<std::uint32_t> face_uvs;

  std::size_t broken_uvs = 0;  ///< How many of `uvs` were no usable numbers and are 0 here.

  std::vector<std::uint32_t> face_depths;  ///< What is painted on each face, or empty; not checked.
  FaceNaming names;                        ///< Names of all faces, layer by layer, or none.

  std::vector<std::string> unused_data;  ///< For ImportReport::unused_data.
  std::string source;                    ///< Path or name for messages; may be empty.

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
