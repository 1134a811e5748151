// The angles are kept sorted, so that dragging the threshold costs a binary search.
#include "app/mesh_facts.h"

#include <algorithm>

#include "limn/painting/selection.h"

namespace limn::app {

void MeshFacts::update(const std::shared_ptr<const ControlMesh>& mesh, double dihedral_threshold) {
  if (mesh_ != mesh) {
    mesh_ = mesh;
    statistics_ = mesh_statistics(*mesh);
    sorted_angles_ = face_dihedral_angles(*mesh);
    std::sort(sorted_angles_.begin(), sorted_angles_.end());
  }
  const auto first_over =
      std::upper_bound(sorted_angles_.begin(), sorted_angles_.end(), dihedral_threshold);
  dihedral_faces_ = static_cast<std::size_t>(sorted_angles_.end() - first_over);
}

}  // namespace limn::app
