#pragma once

#include <cstddef>
#include <map>

#include "limn/mesh/control_mesh.h"

namespace limn {

/// The counts a modeller looks at first.
struct MeshStatistics {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::map<std::size_t, std::size_t> faces_by_sides;  ///< Number of sides -> number of faces.
  std::size_t boundary_edges = 0;
  std::size_t boundary_loops = 0;
  std::size_t components = 0;
  long euler_characteristic = 0;  ///< V - E + F.
  std::size_t highest_valence = 0;

  std::size_t crease_edges = 0;    ///< With a sharpness of their own.
  std::size_t sharp_vertices = 0;  ///< Likewise.
  std::size_t uv_points = 0;       ///< Points of the texture plane.
  std::size_t uv_seams = 0;        ///< Edges at which the two faces name different points.
};

/// Counts everything in time linear in the size of the mesh.
[[nodiscard]] MeshStatistics mesh_statistics(const ControlMesh& mesh);

}  // namespace limn
