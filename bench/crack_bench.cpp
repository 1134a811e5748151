// The check for cracks of refined meshes, uniform and painted, in memory that it keeps, as the
// window does after every stroke. It knows nothing of how the mesh was numbered.
#include <tbb/global_control.h>

#include "cases.h"
#include "limn/contract.h"
#include "limn/subdivision/crack_check.h"
#include "limn/subdivision/label_subdivision.h"
#include "meshes.h"
#include "paintings.h"

namespace limn::bench {
namespace {

void check_for_cracks(benchmark::State& state, const ControlMesh& control,
                      const VertexLabels& labels, std::size_t threads) {
  IgnoreProgress progress;
  const Result<RefinedMesh> refined = refine(control, labels, {}, {}, progress);
  LIMN_EXPECTS(refined.has_value());
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  CrackChecker checker;
  CrackCheck found;
  checker.check(control, *refined, found);
  time_run(state, [&] { checker.check(control, *refined, found); });
  if (!found.is_watertight()) {
    fail_run(state, "cracks");
  }
  state.counters["faces"] = static_cast<double>(refined->face_count());
}

}  // namespace

void register_cracks(Extent extent) {
  const int repetitions = extent == Extent::kQuick ? 3 : 5;
  for (const std::size_t threads : {1U, 2U}) {
    const std::string name = threads == 1 ? "/limn_retained" : "/limn_retained_2_threads";
    for (const Work& work : large_works()) {
      add_case("cracks/" + path_of(work) + name, repetitions, [=](benchmark::State& state) {
        const ControlMesh& control = control_mesh(work.mesh);
        check_for_cracks(
            state, control,
            VertexLabels(control.vertex_count(), static_cast<std::uint8_t>(work.levels)), threads);
      });
    }
    for (const Painting& painting : deepest_paintings()) {
      add_case("cracks/" + path_of(painting) + name, repetitions, [=](benchmark::State& state) {
        const ControlMesh& control = control_mesh(kLargestMesh);
        check_for_cracks(state, control, legal_labels_of(control, painting), threads);
      });
    }
  }
}

}  // namespace limn::bench
