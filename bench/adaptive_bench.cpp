// Adaptive refinement of the largest asteroid, from legal labels to the refined mesh. Told per
// output face beside uniform refinement of the same mesh, it shows whether the cost follows the
// output.
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <tbb/global_control.h>

#include "cases.h"
#include "limn/contract.h"
#include "limn/subdivision/label_subdivision.h"
#include "memory.h"
#include "meshes.h"
#include "paintings.h"

namespace limn::bench {
namespace {

void refine_painting(benchmark::State& state, const VertexLabels& labels, bool into_retained) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const ControlMesh& mesh = control_mesh(kLargestMesh);
  return_free_memory();
  const RefinementPrediction prediction = predict_refinement(mesh, labels);
  warm_free_memory(2 * prediction.bytes);
  IgnoreProgress progress;
  Refiner refiner;
  RefinedMesh result;
  const auto refine = [&] {
    LIMN_EXPECTS(refiner.refine(mesh, labels, {}, {}, progress, result).has_value());
  };
  if (into_retained) {
    refine();
  }
  time_run(state, refine);
  if (result.face_count() != prediction.faces || result.vertex_count() != prediction.vertices) {
    fail_run(state, "not the counts that were foretold");
  }
  state.counters["faces"] = static_cast<double>(result.face_count());
  state.counters["vertices"] = static_cast<double>(result.vertex_count());
  state.counters["result_bytes"] = static_cast<double>(result.bytes());
}

}  // namespace

void register_adaptive(Extent extent) {
  const bool quick = extent == Extent::kQuick;
  for (Painting painting : deepest_paintings()) {
    const int deepest = painting.depth;
    for (painting.depth = quick ? deepest : 1; painting.depth <= deepest; ++painting.depth) {
      // The labels are found when a case first needs them, and kept.
      const auto labels = std::make_shared<VertexLabels>();
      for (const bool into_retained : {false, true}) {
        add_case("adaptive/" + path_of(painting) + (into_retained ? "/limn_retained" : "/limn"),
                 quick ? 3 : 5, [=](benchmark::State& state) {
                   if (labels->empty()) {
                     *labels = legal_labels_of(control_mesh(kLargestMesh), painting);
                   }
                   refine_painting(state, *labels, into_retained);
                 });
      }
    }
  }
}

}  // namespace limn::bench
