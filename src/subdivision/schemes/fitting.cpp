#include "limn/contract.h"
#include "limn/mesh/triangulate.h"
#include "limn/subdivision/schemes/uniform.h"

namespace limn {

Fitting fitting_for(FaceKinds kinds) noexcept {
  LIMN_EXPECTS(kinds != FaceKinds::kAny);
  return kinds == FaceKinds::kTriangles ? Fitting::kTriangulate : Fitting::kOneCatmullClarkStep;
}

std::shared_ptr<const ControlMesh> make_fit(const ControlMesh& mesh, Fitting fitting) {
  if (fitting == Fitting::kTriangulate) {
    return triangulated(mesh);
  }
  IgnoreProgress nobody;
  SchemeSettings settings;
  settings.scheme = Scheme::kCatmullClark;
  settings.corners = mesh.attributes().corners.value_or(CornerRule::kSharp);
  const Result<RefinedMesh> quads = subdivide(mesh, settings, {}, nobody);
  LIMN_EXPECTS(quads.has_value());
  return to_control_mesh(*quads, &mesh);
}

}  // namespace limn
