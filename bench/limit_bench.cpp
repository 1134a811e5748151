// What the limit costs on top of a refinement: uniform ones into a retained result, one thread.
#include <string>
#include <vector>

#include <tbb/global_control.h>

#include "cases.h"
#include "limn/contract.h"
#include "limn/subdivision/label_subdivision.h"
#include "memory.h"
#include "meshes.h"

namespace limn::bench {
namespace {

/// What is asked of a refinement.
struct Wish {
  std::string name;
  SurfacePoints points;
  bool normals;
};

void refine_to_limit(benchmark::State& state, const Work& work, const Wish& wish) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const ControlMesh& mesh = control_mesh(work.mesh);
  const VertexLabels labels(mesh.vertex_count(), static_cast<std::uint8_t>(work.levels));
  SubdivisionSettings settings;
  settings.points = wish.points;
  RefineLimits limits;
  limits.normals = wish.normals;
  IgnoreProgress progress;
  Refiner refiner;
  RefinedMesh result;
  const auto refine = [&] {
    LIMN_EXPECTS(refiner.refine(mesh, labels, settings, limits, progress, result).has_value());
  };
  return_free_memory();
  refine();
  time_run(state, refine);
  const Counts expected = uniform_counts(mesh, work);
  if (Counts{result.vertex_count(), result.face_count()} != expected ||
      result.normals.size() != (wish.normals ? expected.vertices : 0)) {
    fail_run(state, "not what was asked for");
  }
  state.counters["faces"] = static_cast<double>(expected.faces);
}

}  // namespace

void register_limit(Extent extent) {
  std::vector<Work> works = {large_works().front()};
  if (extent == Extent::kAll) {
    works.insert(works.end(), {{"creature", 6}, {"teapot", 5}});
  }
  const std::vector<Wish> wishes = {
      {"level", SurfacePoints::kLevel, false},
      {"level_and_normals", SurfacePoints::kLevel, true},
      {"limit", SurfacePoints::kLimit, false},
      {"limit_and_normals", SurfacePoints::kLimit, true},
  };
  for (const Work& work : works) {
    for (const Wish& wish : wishes) {
      add_case("limit/" + path_of(work) + "/" + wish.name, extent == Extent::kQuick ? 3 : 5,
               [=](benchmark::State& state) { refine_to_limit(state, work, wish); });
    }
  }
}

}  // namespace limn::bench
