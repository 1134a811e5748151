#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "limn/mesh/control_mesh.h"
#include "limn/mesh/statistics.h"
#include "limn/painting/crease_palette.h"

namespace limn::app {

/// What the panels show of a control mesh, worked out once per mesh and threshold.
class MeshFacts {
 public:
  /// Brings everything up to date; does nothing where mesh and threshold are those of last time.
  void update(const std::shared_ptr<const ControlMesh>& mesh, double dihedral_threshold);

  [[nodiscard]] const MeshStatistics& statistics() const noexcept { return statistics_; }
  /// Faces with an edge over the threshold.
  [[nodiscard]] std::size_t dihedral_faces() const noexcept { return dihedral_faces_; }
  /// Edges over the threshold.
  [[nodiscard]] std::size_t dihedral_edges() const noexcept { return dihedral_edges_; }
  [[nodiscard]] const CreaseCounts& creases() const noexcept { return creases_; }
  [[nodiscard]] std::size_t t_junctions() const noexcept { return t_junctions_; }

 private:
  std::shared_ptr<const ControlMesh> mesh_;
  MeshStatistics statistics_;
  std::vector<double> sorted_angles_;  ///< Of faces.
  std::vector<double> sorted_edge_angles_;
  std::size_t dihedral_faces_ = 0;
  std::size_t dihedral_edges_ = 0;
  CreaseCounts creases_{};
  std::size_t t_junctions_ = 0;
};

}  // namespace limn::app
