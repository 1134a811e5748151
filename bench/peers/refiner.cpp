#include "peers/refiner.h"

#include <map>
#include <utility>

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

Refiner& cached_refiner(const std::string& program, const std::string& mesh) {
  static std::map<std::pair<std::string, std::string>, std::unique_ptr<Refiner>> refiners;
  std::unique_ptr<Refiner>& refiner = refiners[{program, mesh}];
  if (refiner == nullptr) {
    refiner = make_refiner(program, control_mesh(mesh));
  }
  return *refiner;
}

}  // namespace limn::bench
