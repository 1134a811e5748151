// Choosing depths by tolerance and by budget, and the refinement that they lead to, as the program
// does both: labels, legalisation, refinement into memory it has, and the check for cracks. All on
// as many threads as there are.
#include <memory>
#include <string>

#include "cases.h"
#include "limn/contract.h"
#include "limn/document/refinement.h"
#include "limn/painting/auto_depth/budget.h"
#include "limn/painting/auto_depth/tolerance.h"
#include "meshes.h"

namespace limn::bench {
namespace {

constexpr const char* kMesh = "asteroid_98k";

/// A question to be answered: one of both.
struct Choice {
  std::string name;
  double tolerance = 0.0;  ///< In diagonals.
  std::uint64_t budget = 0;
};

SubdivisionSettings settings() {
  SubdivisionSettings settings;
  settings.points = SurfacePoints::kLimit;
  return settings;
}

FaceDepths choose(const ControlMesh& mesh, const Choice& choice) {
  IgnoreProgress progress;
  if (choice.budget > 0) {
    auto found = depths_for_budget(mesh, settings(), {{choice.budget}, {}}, progress);
    LIMN_EXPECTS(found.has_value());
    return std::move(found->chosen.depths);
  }
  const double distance = choice.tolerance * mesh.bounds().diagonal();
  auto found = depths_for_tolerance(mesh, settings(), {&distance, 1}, progress);
  LIMN_EXPECTS(found.has_value());
  return std::move(found->depths);
}

void time_choice(benchmark::State& state, const Choice& choice) {
  const ControlMesh& mesh = control_mesh(kMesh);
  FaceDepths depths;
  time_run(state, [&] { depths = choose(mesh, choice); });
  state.counters["control_faces"] = static_cast<double>(mesh.face_count());
  state.counters["deepest"] = depths.deepest();
}

void time_refinement(benchmark::State& state, const Choice& choice) {
  const ControlMesh& mesh = control_mesh(kMesh);
  const FaceDepths depths = choose(mesh, choice);
  IgnoreProgress progress;
  RefinementOptions options;
  options.settings = settings();
  RefinementSource source;
  std::size_t faces = 0;
  const auto refine = [&] {
    const auto labels = derive_labels(mesh, depths.values(), options.settings, progress);
    LIMN_EXPECTS(labels.has_value());
    const auto refined = source.derive(mesh, *labels, options, progress);
    LIMN_EXPECTS(refined.has_value() && refined->cracks.is_watertight());
    faces = refined->mesh->face_count();
  };
  refine();
  time_run(state, refine);
  if (choice.budget > 0 && faces > choice.budget) {
    fail_run(state, "over the budget");
  }
  state.counters["faces"] = static_cast<double>(faces);
}

}  // namespace

void register_choosing(Extent extent) {
  const int repetitions = extent == Extent::kQuick ? 3 : 5;
  for (const Choice& choice :
       {Choice{"tolerance_1e-4", 1e-4}, Choice{"tolerance_3e-5", 3e-5},
        Choice{"tolerance_1e-5", 1e-5}, Choice{"budget_200k", 0.0, 200'000},
        Choice{"budget_500k", 0.0, 500'000}, Choice{"budget_1M", 0.0, 1'000'000}}) {
    const std::string name = std::string("choosing/") + kMesh + "/" + choice.name;
    add_case(name + "/choose", repetitions,
             [=](benchmark::State& state) { time_choice(state, choice); });
    add_case(name + "/refine", repetitions,
             [=](benchmark::State& state) { time_refinement(state, choice); });
  }
}

}  // namespace limn::bench
