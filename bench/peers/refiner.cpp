#include "peers/refiner.h"

#include "limn/contract.h"

namespace limn::bench {

std::unique_ptr<Refiner> make_refiner(std::string_view program, const ControlMesh& mesh) {
  if (program == "limn") {
    return make_limn(mesh);
  }
  if (program == "opensubdiv") {
    return make_opensubdiv(mesh);
  }
  if (program == "openmesh") {
    return make_openmesh(mesh);
  }
  LIMN_EXPECTS(program == "cgal");
  return make_cgal(mesh);
}

}  // namespace limn::bench
