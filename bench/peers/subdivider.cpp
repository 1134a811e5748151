#include "peers/subdivider.h"

#include <map>
#include <utility>

#include "limn/contract.h"

namespace limn::bench {

std::unique_ptr<Subdivider> make_subdivider(std::string_view program, const ControlMesh& mesh) {
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

Subdivider& cached_subdivider(const std::string& program, const std::string& mesh) {
  static std::map<std::pair<std::string, std::string>, std::unique_ptr<Subdivider>> programs;
  std::unique_ptr<Subdivider>& made = programs[{program, mesh}];
  if (made == nullptr) {
    made = make_subdivider(program, control_mesh(mesh));
  }
  return *made;
}

}  // namespace limn::bench
