// Other creases make another mesh of the same surface: what is kept here holds for it too.
#include "app/paint_tools/mesh_aids.h"

#include "limn/painting/selection.h"

namespace limn::app {

void MeshAids::follow(const std::shared_ptr<const ControlMesh>& mesh) {
  if (mesh_ == nullptr || &mesh_->topology() != &mesh->topology()) {
    edge_angles_.clear();
    mirror_ = {};
  }
  mesh_ = mesh;
}

std::span<const double> MeshAids::edge_angles(const std::shared_ptr<const ControlMesh>& mesh) {
  follow(mesh);
  if (edge_angles_.empty()) {
    edge_angles_ = edge_dihedral_angles(*mesh);
  }
  return edge_angles_;
}

const FaceMirror& MeshAids::mirror(const std::shared_ptr<const ControlMesh>& mesh,
                                   const MirrorAxes& axes) {
  follow(mesh);
  if (mirror_.axes() != axes) {
    mirror_ = FaceMirror(*mesh, axes);
  }
  return mirror_;
}

}  // namespace limn::app
