#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "limn/mesh/control_mesh.h"
#include "limn/mesh/refined_mesh.h"
#include "limn/progress.h"

namespace limn {

/// Whether a refined mesh is watertight where its control mesh is. Edges come from the faces alone;
/// for the boundary, `vertex_levels` of the control vertices say how many edges each control
/// boundary edge has become, and where all faces are triangles their levels do.
struct CrackCheck {
  std::size_t boundary_edges = 0;          ///< Edges with one face.
  std::size_t control_boundary_edges = 0;  ///< Of those, edges that lie on a control boundary edge.
  std::size_t nonmanifold_edges = 0;      ///< Edges with three or more faces, or two that disagree.
  std::size_t missing_control_faces = 0;  ///< Control faces of which no refined face is left.
  std::size_t unused_vertices = 0;  ///< Vertices that no face has. A piece missing at the boundary
                                    ///< may leave as many edges there as belong there, but not
                                    ///< without such vertices.
  std::vector<std::uint32_t> crack_faces;  ///< Faces beside a boundary edge that should not be one.

  /// No T-junction, no hole, no doubled edge.
  [[nodiscard]] bool is_watertight() const noexcept {
    return nonmanifold_edges == 0 && missing_control_faces == 0 && unused_vertices == 0 &&
           boundary_edges == control_boundary_edges;
  }
};

/// Checks all edges, in time linear in their number. Exact, whatever the faces are: that refinement
/// numbers its faces and vertices so that neighbours are near each other makes it fast, no more.
/// The result is the same for any number of threads. Indices are expected within their ranges.
[[nodiscard]] CrackCheck check_cracks(const ControlMesh& control, const RefinedMesh& refined);

/// `check_cracks` for those who do it again and again: it keeps its working memory, some 10 bytes a
/// face, and allocates nothing for a whole mesh of a size that it has seen.
class CrackChecker {
 public:
  CrackChecker();
  ~CrackChecker();
  CrackChecker(CrackChecker&&) noexcept;
  CrackChecker& operator=(CrackChecker&&) noexcept;

  /// Replaces the contents of `result`.
  void check(const ControlMesh& control, const RefinedMesh& refined, CrackCheck& result);
  /// The same under a progress; false where that asked to stop, and then `result` is unspecified.
  [[nodiscard]] bool check(const ControlMesh& control, const RefinedMesh& refined,
                           CrackCheck& result, Progress& progress);

 private:
  struct Workspace;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace limn
