// Uniform refinement by Limn and peers. Each run starts with no memory but that of the control
// meshes, unless the contender is one that keeps its memory: that one refines once before the clock
// starts.
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <tbb/global_control.h>

#include "agreement.h"
#include "cases.h"
#include "memory.h"
#include "meshes.h"
#include "peers/refiner.h"

namespace limn::bench {
namespace {

/// A program and the conditions it runs under.
struct Contender {
  std::string name;
  std::string program;
  std::size_t threads = 1;
  Pages pages = Pages::kOwnChoice;
  bool keeps_memory = false;
};

const std::vector<Contender> kLimn = {
    {"limn", "limn"},
    {"limn_2_threads", "limn", 2},
};
const std::vector<Contender> kLimnElsewise = {
    {"limn_small_pages", "limn", 1, Pages::kSmall},
};
const std::vector<Contender> kOpenSubdiv = {
    {"opensubdiv", "opensubdiv"},
};
const std::vector<Contender> kOpenSubdivElsewise = {
    {"opensubdiv_huge_pages", "opensubdiv", 1, Pages::kHuge},
    {"opensubdiv_kept_memory", "opensubdiv", 1, Pages::kOwnChoice, true},
};
const std::vector<Contender> kOthers = {
    {"openmesh", "openmesh"},
    {"cgal", "cgal"},
};

struct Work {
  std::string mesh;
  int levels;
};

/// A program with a control mesh in its form, made when first needed.
Refiner& cached_refiner(const std::string& program, const std::string& mesh) {
  static std::map<std::pair<std::string, std::string>, std::unique_ptr<Refiner>> refiners;
  std::unique_ptr<Refiner>& refiner = refiners[{program, mesh}];
  if (refiner == nullptr) {
    refiner = make_refiner(program, control_mesh(mesh));
  }
  return *refiner;
}

void refine_uniformly(benchmark::State& state, const Contender& contender, const Work& work) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    contender.threads);
  Refiner& refiner = cached_refiner(contender.program, work.mesh);
  const Counts expected = uniform_counts(control_mesh(work.mesh), work.levels);
  return_free_memory();
  const PageScope pages(contender.pages);
  std::optional<KeepMemory> keep;
  if (contender.keeps_memory) {
    keep.emplace();
  }
  refiner.prepare();
  if (contender.keeps_memory) {
    refiner.refine(work.levels);
    refiner.recycle();
  }
  for (auto _ : state) {
    state.SetIterationTime(seconds_of([&] { refiner.refine(work.levels); }));
  }
  if (refiner.counts() != expected) {
    fail_run(state, "not the counts of uniform Catmull-Clark");
  }
  state.counters["faces"] = static_cast<double>(expected.faces);
  state.counters["vertices"] = static_cast<double>(expected.vertices);
  state.counters["result_bytes"] = static_cast<double>(refiner.result_bytes());
  state.counters["threads"] = static_cast<double>(contender.threads);
  refiner.release();
}

void add(const Work& work, const std::vector<Contender>& contenders, int repetitions) {
  for (const Contender& contender : contenders) {
    add_case("uniform/" + work.mesh + "/" + std::to_string(work.levels) + "/" + contender.name,
             repetitions, [contender, work](benchmark::State& state) {
               refine_uniformly(state, contender, work);
             });
  }
}

/// The large meshes, all to 3,932,160 faces.
const std::vector<Work> kLarge = {{"asteroid_15k", 4}, {"asteroid_61k", 3}, {"asteroid_246k", 2}};

/// Bundled meshes that are closed, to about a million faces (the creature to 4.6 million).
const std::vector<Work> kClosed = {{"creature", 6}, {"mixed", 7}, {"cube", 8}};
/// Those with boundaries, where OpenMesh has other rules.
const std::vector<Work> kOpen = {{"teapot", 5}, {"torus_open", 6}};

}  // namespace

void register_uniform(Extent extent) {
  const bool quick = extent == Extent::kQuick;
  const int repetitions = quick ? 3 : 7;
  const int repetitions_of_slow = quick ? 1 : 3;
  for (const Work& work : kLarge) {
    add(work, kLimn, repetitions);
    add(work, kOpenSubdiv, repetitions);
    if (!quick) {
      add(work, kOthers, repetitions_of_slow);
    }
  }
  add(kLarge.front(), kLimnElsewise, repetitions);
  if (quick) {
    return;
  }
  add(kLarge.front(), kOpenSubdivElsewise, repetitions);
  for (const Work& work : kClosed) {
    add(work, kLimn, repetitions);
    add(work, kOpenSubdiv, repetitions);
    add(work, kOthers, repetitions_of_slow);
  }
  for (const Work& work : kOpen) {
    add(work, kLimn, repetitions);
    add(work, kOpenSubdiv, repetitions);
  }
}

void register_agreement(Extent extent) {
  const std::vector<Work> works =
      extent == Extent::kQuick
          ? std::vector<Work>{{"asteroid_15k", 2}}
          : std::vector<Work>{{"asteroid_15k", 2}, {"creature", 4}, {"mixed", 5}, {"teapot", 4}};
  for (const Work& work : works) {
    for (const std::string program : {"opensubdiv", "openmesh", "cgal"}) {
      if (program != "opensubdiv" && !control_mesh(work.mesh).is_closed()) {
        continue;
      }
      add_case("agreement/" + work.mesh + "/" + std::to_string(work.levels) + "/" + program, 1,
               [=](benchmark::State& state) {
                 Refiner& limn = cached_refiner("limn", work.mesh);
                 Refiner& peer = cached_refiner(program, work.mesh);
                 double distance = 0.0;
                 for (auto _ : state) {
                   state.SetIterationTime(seconds_of([&] {
                     for (Refiner* refiner : {&limn, &peer}) {
                       refiner->prepare();
                       refiner->refine(work.levels);
                     }
                     distance = largest_distance(limn.positions(), peer.positions());
                   }));
                 }
                 const double relative = distance / control_mesh(work.mesh).bounds().diagonal();
                 state.counters["distance"] = relative;
                 if (limn.counts() != peer.counts() || !(relative <= kAgreement)) {
                   fail_run(state, "not the vertices that Limn finds");
                 }
                 limn.release();
                 peer.release();
               });
    }
  }
}

void register_memory(Extent extent) {
  const std::vector<std::string> programs =
      extent == Extent::kQuick ? std::vector<std::string>{"limn", "opensubdiv"}
                               : std::vector<std::string>{"limn", "opensubdiv", "openmesh", "cgal"};
  for (const Work& work : kLarge) {
    for (const std::string& program : programs) {
      add_case("memory/" + work.mesh + "/" + std::to_string(work.levels) + "/" + program, 1,
               [=](benchmark::State& state) {
                 std::size_t peak = 0;
                 for (auto _ : state) {
                   state.SetIterationTime(
                       seconds_of([&] { peak = measure_peak(program, work.mesh, work.levels); }));
                 }
                 if (peak == 0) {
                   fail_run(state, "peak memory could not be measured");
                 }
                 state.counters["peak_bytes"] = static_cast<double>(peak);
                 state.counters["faces"] = static_cast<double>(
                     uniform_counts(control_mesh(work.mesh), work.levels).faces);
               });
    }
  }
}

}  // namespace limn::bench
