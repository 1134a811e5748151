// Both methods of legalisation on tori of which 5 % of the faces are painted at random: ten
// thousand illegal vertices to a million.
#include <cmath>
#include <memory>
#include <string>

#include <benchmark/benchmark.h>

#include "cases.h"
#include "legalisation_table.h"
#include "limn/contract.h"
#include "limn/subdivision/legalisation.h"
#include "limn/subdivision/prediction.h"
#include "memory.h"

namespace limn::bench {
namespace {

struct Painted {
  ControlMesh mesh;
  VertexLabels labels;
  std::size_t illegal = 0;
};

using Legalise = Result<Legalisation> (*)(const ControlMesh&, VertexLabels, NonQuadRule, Progress&);

void legalise(benchmark::State& state, const Painted& painted, Legalise method) {
  return_free_memory();
  IgnoreProgress progress;
  Result<Legalisation> result;
  time_run(state, [&] {
    result = method(painted.mesh, painted.labels, NonQuadRule::kWherePainted, progress);
    LIMN_EXPECTS(result.has_value());
  });
  if (!illegal_faces(painted.mesh, result->labels, LegalisationMethod::kLookAhead).empty()) {
    fail_run(state, "illegal faces are left");
  }
  state.counters["illegal"] = static_cast<double>(painted.illegal);
  state.counters["steps"] = static_cast<double>(result->steps.size());
  state.counters["faces"] =
      static_cast<double>(predict_refinement(painted.mesh, result->labels).faces);
}

}  // namespace

void register_legalisation(Extent extent) {
  const bool quick = extent == Extent::kQuick;
  struct Size {
    const char* illegal;
    std::uint32_t torus;  ///< Whose painting has about as many illegal vertices.
  };
  for (const Size size : {Size{"10k", 194}, Size{"32k", 345}, Size{"100k", 612}, Size{"316k", 1088},
                          Size{"1M", 1935}}) {
    if (quick && size.torus > 1000) {
      continue;
    }
    // Made when a case first needs it.
    const auto painted = std::make_shared<std::unique_ptr<Painted>>();
    const auto add = [&](const std::string& name, Legalise method) {
      add_case("legalise/" + std::string(size.illegal) + "/" + name, quick ? 3 : 5,
               [=](benchmark::State& state) {
                 if (*painted == nullptr) {
                   ControlMesh mesh = torus(size.torus);
                   VertexLabels labels = random_labels(mesh, 0.05, 1);
                   const std::size_t illegal = illegal_vertices(mesh, labels).size();
                   *painted = std::make_unique<Painted>(
                       Painted{std::move(mesh), std::move(labels), illegal});
                 }
                 legalise(state, **painted, method);
               });
    };
    add("greedy", legalise_greedy);
    add("look_ahead", legalise_look_ahead);
  }
}

}  // namespace limn::bench
