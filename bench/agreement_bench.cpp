// Whether the programs compute the same: vertex by vertex, whatever order they come in.
#include <string>
#include <vector>

#include "agreement.h"
#include "cases.h"
#include "peers/subdivider.h"

namespace limn::bench {
namespace {

void compare(benchmark::State& state, const std::string& program, const Work& work) {
  Subdivider& limn = cached_subdivider("limn", work);
  Subdivider& peer = cached_subdivider(program, work);
  double distance = 0.0;
  time_run(state, [&] {
    for (Subdivider* each : {&limn, &peer}) {
      each->prepare();
      each->refine(work.levels);
    }
    distance = largest_distance(limn.positions(), peer.positions());
  });
  const double relative = distance / control_mesh(work.mesh).bounds().diagonal();
  state.counters["distance"] = relative;
  if (limn.counts() != peer.counts() || !(relative <= kAgreement)) {
    fail_run(state, "not the vertices that Limn finds");
  }
  limn.release();
  peer.release();
}

}  // namespace

void register_agreement(Extent extent) {
  std::vector<Work> works = {{"asteroid_15k", 2}};
  if (extent == Extent::kAll) {
    works.insert(works.end(), {{"creature", 4}, {"mixed", 5}, {"teapot", 4}});
  }
  works.push_back({"asteroid_31k_triangles", 2, Rules::kLoop});
  for (const Work& work : works) {
    for (const std::string program : {"opensubdiv", "openmesh", "cgal"}) {
      if (program == "opensubdiv" || control_mesh(work.mesh).is_closed()) {
        add_case("agreement/" + path_of(work) + "/" + program, 1,
                 [=](benchmark::State& state) { compare(state, program, work); });
      }
    }
  }
}

}  // namespace limn::bench
