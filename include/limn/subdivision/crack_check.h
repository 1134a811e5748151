#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "limn/mesh/control_mesh.h"
#include "limn/mesh/refined_mesh.h"

namespace limn {

/// Whether a refined mesh is watertight where its control mesh is. Edges come from the faces alone;
/// for the boundary, `vertex_levels` of the control vertices say how many edges each control
/// boundary edge has become.
struct CrackCheck {
  std::size_t boundary_edges = 0;          ///< Edges with one face.
  std::size_t control_boundary_edges = 0;  ///< Of those, edges that lie on a control boundary edge.
  std::size_t nonmanifold_edges = 0;      ///< Edges with three or more faces, or two that disagree.
  std::size_t missing_control_faces = 0;  ///< Control faces of which no refined face is left.
  std::vector<std::uint32_t> crack_faces;  ///< Faces beside a boundary edge that should not be one.

  /// No T-junction, no hole, no doubled edge.
  [[nodiscard]] bool is_watertight() const noexcept {
    return nonmanifold_edges == 0 && missing_control_faces == 0 &&
           boundary_edges == control_boundary_edges;
  }
};

/// Checks all edges; linear in time up to sorting.
[[nodiscard]] CrackCheck check_cracks(const ControlMesh& control, const RefinedMesh& refined);

}  // namespace limn
