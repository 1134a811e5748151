#pragma once

#include <memory>
#include <span>
#include <vector>

#include "limn/mesh/control_mesh.h"
#include "limn/painting/mirror.h"

namespace limn::app {

/// What the painting tools need to know of a control mesh, worked out when it is first asked for
/// and kept as long as the surface is the same.
class MeshAids {
 public:
  /// Of every edge, in degrees.
  [[nodiscard]] std::span<const double> edge_angles(const std::shared_ptr<const ControlMesh>& mesh);
  [[nodiscard]] const FaceMirror& mirror(const std::shared_ptr<const ControlMesh>& mesh,
                                         const MirrorAxes& axes);

 private:
  void follow(const std::shared_ptr<const ControlMesh>& mesh);

  std::shared_ptr<const ControlMesh> mesh_;
  std::vector<double> edge_angles_;
  FaceMirror mirror_;
};

}  // namespace limn::app
