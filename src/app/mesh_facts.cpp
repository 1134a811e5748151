// The angles are kept sorted, so that dragging the threshold costs a binary search.
#include "app/mesh_facts.h"

#include <algorithm>

#include "limn/mesh/open_edges.h"
#include "limn/painting/selection.h"

namespace limn::app {

namespace {

std::size_t count_over(const std::vector<double>& sorted, double threshold) {
  const auto first = std::upper_bound(sorted.begin(), sorted.end(), threshold + kDihedralTolerance);
  return static_cast<std::size_t>(sorted.end() - first);
}

}  // namespace

void MeshFacts::update(const std::shared_ptr<const ControlMesh>& mesh, double dihedral_threshold) {
  if (mesh_ != mesh) {
    const bool is_same_surface = mesh_ != nullptr && &mesh_->topology() == &mesh->topology();
    mesh_ = mesh;
    statistics_ = mesh_statistics(*mesh);
    creases_ = count_creases(*mesh);
    if (!is_same_surface) {
      t_junctions_ = find_t_junctions(*mesh).size();
      sorted_angles_ = face_dihedral_angles(*mesh);
      std::sort(sorted_angles_.begin(), sorted_angles_.end());
      sorted_edge_angles_ = edge_dihedral_angles(*mesh);
      std::sort(sorted_edge_angles_.begin(), sorted_edge_angles_.end());
    }
  }
  dihedral_faces_ = count_over(sorted_angles_, dihedral_threshold);
  dihedral_edges_ = count_over(sorted_edge_angles_, dihedral_threshold);
}

}  // namespace limn::app
