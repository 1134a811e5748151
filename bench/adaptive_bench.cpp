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

constexpr const char* kMesh = "asteroid_246k";

struct Painting {
  Layout layout;
  int percent;
  int depth;
};

std::string name_of(const Painting& painting) {
  return std::string(painting.layout == Layout::kPatches ? "patches" : "scattered") + "/" +
         std::to_string(painting.percent) + "/" + std::to_string(painting.depth);
}

VertexLabels labels_of(const Painting& painting) {
  const ControlMesh& mesh = control_mesh(kMesh);
  IgnoreProgress progress;
  const Result<Legalisation> legal = legal_labels(
      mesh, paint(mesh, painting.layout, painting.percent / 100.0, painting.depth), {}, progress);
  LIMN_EXPECTS(legal.has_value());
  return legal->labels;
}

void refine_painting(benchmark::State& state, const VertexLabels& labels, bool into_retained) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const ControlMesh& mesh = control_mesh(kMesh);
  return_free_memory();
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
  const RefinementPrediction prediction = predict_refinement(mesh, labels);
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
  struct Paintings {
    Layout layout;
    int percent;
    int deepest;  // The result stays at some millions of faces.
  };
  for (const auto& [layout, percent, deepest] : {Paintings{Layout::kPatches, 1, 5},
                                                 {Layout::kPatches, 5, 4},
                                                 {Layout::kPatches, 20, 3},
                                                 {Layout::kScattered, 1, 5},
                                                 {Layout::kScattered, 5, 3},
                                                 {Layout::kScattered, 20, 2}}) {
    for (int depth = quick ? deepest : 1; depth <= deepest; ++depth) {
      const Painting painting{layout, percent, depth};
      // The labels are found when the case first runs, and kept for its other runs.
      const auto labels = std::make_shared<VertexLabels>();
      for (const bool into_retained : {false, true}) {
        add_case("adaptive/" + name_of(painting) + (into_retained ? "/limn_retained" : "/limn"),
                 quick ? 3 : 5, [=](benchmark::State& state) {
                   if (labels->empty()) {
                     *labels = labels_of(painting);
                   }
                   refine_painting(state, *labels, into_retained);
                 });
      }
    }
  }
}

}  // namespace limn::bench
