#include "peers/subdivider.h"

#include <map>
#include <tuple>

#include "limn/contract.h"

namespace limn::bench {

std::unique_ptr<Subdivider> make_subdivider(std::string_view program, const ControlMesh& mesh,
                                            Rules rules) {
  if (program == "limn") {
    return make_limn(mesh, rules);
  }
  if (program == "opensubdiv") {
    return make_opensubdiv(mesh, rules);
  }
  if (program == "openmesh") {
    return make_openmesh(mesh, rules);
  }
  LIMN_EXPECTS(program == "cgal");
  return make_cgal(mesh, rules);
}

Subdivider& cached_subdivider(const std::string& program, const Work& work) {
  static std::map<std::tuple<std::string, std::string, Rules>, std::unique_ptr<Subdivider>>
      programs;
  std::unique_ptr<Subdivider>& made = programs[{program, work.mesh, work.rules}];
  if (made == nullptr) {
    made = make_subdivider(program, control_mesh(work.mesh), work.rules);
  }
  return *made;
}

}  // namespace limn::bench
