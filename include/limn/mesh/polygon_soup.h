#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace limn {

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
  std::string source;  ///< Path or name for messages; may be empty.

  [[nodiscard]] std::size_t face_count() const noexcept { return face_offsets.size() - 1; }
  [[nodiscard]] std::span<const std::uint32_t> face(std::size_t f) const noexcept {
    return std::span(face_vertices).subspan(face_offsets[f], face_offsets[f + 1] - face_offsets[f]);
  }
  void add_face(std::span<const std::uint32_t> corners) {
    face_vertices.insert(face_vertices.end(), corners.begin(), corners.end());
    face_offsets.push_back(static_cast<std::uint32_t>(face_vertices.size()));
  }
};

}  // namespace limn
