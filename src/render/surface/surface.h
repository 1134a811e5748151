#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "limn/mesh/control_mesh.h"
#include "limn/mesh/refined_mesh.h"

namespace limn::render {

/// Faces with the same number of sides, which lie one after the other in a Surface.
struct SurfaceGroup {
  std::uint32_t sides = 0;
  std::uint32_t first_face = 0;
  std::uint32_t face_count = 0;
  std::uint32_t first_corner = 0;

  [[nodiscard]] bool operator==(const SurfaceGroup&) const = default;
};

/// A polygon surface laid out for drawing: V vertices, F drawn faces grouped by number of sides,
/// C corners. Plain data without OpenGL, so it can be made on any thread.
///
/// Within a group faces keep the order of the mesh they come from.
struct Surface {
  glm::dvec3 origin{0.0};              ///< World position that `positions` are relative to.
  std::vector<glm::vec3> positions;    ///< V, mesh units.
  std::vector<glm::vec3> normals;      ///< V, unit length: of the limit surface where the mesh
                                       ///< has them, else area-weighted over the faces around.
  std::vector<std::uint32_t> corners;  ///< C, vertices of each drawn face in order.
  std::vector<SurfaceGroup> groups;    ///< By ascending number of sides.
  std::vector<std::uint32_t> face_control_faces;  ///< F, the control face each lies in.
  std::vector<std::uint8_t> face_levels;          ///< F, the level it was made at, 0..15.
  /// F, the depth demanded of each beyond its control face's, 0 for none; empty where nothing is.
  std::vector<std::uint8_t> face_demands;
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< Control surfaces only: every edge once.
  std::size_t control_face_count = 0;

  [[nodiscard]] std::size_t face_count() const noexcept { return face_control_faces.size(); }
};

/// The control mesh as a surface; its origin is the centre of its bounds.
[[nodiscard]] Surface make_surface(const ControlMesh& mesh);

/// A refined mesh as a surface, with the origin of its control mesh's surface so that both are
/// drawn with the same matrices. `control_face_count` is the number of control faces.
[[nodiscard]] Surface make_surface(const RefinedMesh& mesh, const glm::dvec3& origin,
                                   std::size_t control_face_count);

}  // namespace limn::render
