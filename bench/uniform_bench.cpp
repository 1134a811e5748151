// Uniform refinement by Limn and peers. Each run starts with no memory but that of the control
// meshes, unless the contender is one that keeps its memory: that one refines once before the clock
// starts.
#include <optional>
#include <vector>

#include <tbb/global_control.h>

#include "cases.h"
#include "memory.h"
#include "meshes.h"
#include "peers/subdivider.h"

namespace limn::bench {
namespace {

/// Where the memory of a refinement comes from.
enum class Memory {
  kFresh,            ///< From the system, while the clock runs.
  kKeptByProgram,    ///< The program refines into what it has from the time before.
  kKeptByAllocator,  ///< The program has no way to; the allocator gives nothing back.
};

/// A program and the conditions it runs under.
struct Contender {
  std::string name;
  std::string program;
  std::size_t threads = 1;
  Memory memory = Memory::kFresh;
  Pages pages = Pages::kOwnChoice;
};

const std::vector<Contender> kLimn = {
    {"limn", "limn"},
    {"limn_retained", "limn", 1, Memory::kKeptByProgram},
    {"limn_2_threads", "limn", 2},
    {"limn_retained_2_threads", "limn", 2, Memory::kKeptByProgram},
};
/// Loop's scheme makes a new result each time.
const std::vector<Contender> kLimnLoop = {
    {"limn", "limn"},
    {"limn_2_threads", "limn", 2},
};
const std::vector<Contender> kLimnElsewise = {
    {"limn_small_pages", "limn", 1, Memory::kFresh, Pages::kSmall},
};
const std::vector<Contender> kOpenSubdiv = {
    {"opensubdiv", "opensubdiv"},
};
const std::vector<Contender> kOpenSubdivElsewise = {
    {"opensubdiv_huge_pages", "opensubdiv", 1, Memory::kFresh, Pages::kHuge},
    {"opensubdiv_kept_memory", "opensubdiv", 1, Memory::kKeptByAllocator},
};
const std::vector<Contender> kOthers = {
    {"openmesh", "openmesh"},
    {"cgal", "cgal"},
};

/// No less than the programs take for an output face.
constexpr std::size_t kLimnBytes = 48;
constexpr std::size_t kPeerBytes = 176;

void refine_uniformly(benchmark::State& state, const Contender& contender, const Work& work) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    contender.threads);
  Subdivider& program = cached_subdivider(contender.program, work);
  const Counts expected = uniform_counts(control_mesh(work.mesh), work);
  return_free_memory();
  warm_free_memory(expected.faces * (contender.program == "limn" ? kLimnBytes : kPeerBytes));
  const PageScope pages(contender.pages);
  std::optional<KeepMemory> keep;
  if (contender.memory == Memory::kKeptByAllocator) {
    keep.emplace();
  }
  program.prepare();
  if (contender.memory != Memory::kFresh) {
    program.refine(work.levels);
    program.recycle();
  }
  std::size_t allocations = 0;
  time_run(state, [&] {
    const std::size_t before = allocation_count();
    program.refine(work.levels);
    allocations = allocation_count() - before;
  });
  if (program.counts() != expected) {
    fail_run(state, "not the counts of uniform refinement");
  }
  state.counters["faces"] = static_cast<double>(expected.faces);
  state.counters["vertices"] = static_cast<double>(expected.vertices);
  state.counters["allocations"] = static_cast<double>(allocations);
  state.counters["result_bytes"] = static_cast<double>(program.result_bytes());
  program.release();
}

/// `uniform/...` for Catmull-Clark, `loop/...` for Loop.
void add(const Work& work, const std::vector<Contender>& contenders, int repetitions) {
  const std::string group = work.rules == Rules::kLoop ? "loop/" : "uniform/";
  for (const Contender& contender : contenders) {
    add_case(
        group + path_of(work) + "/" + contender.name, repetitions,
        [contender, work](benchmark::State& state) { refine_uniformly(state, contender, work); });
  }
}

/// Bundled meshes that are closed, to about a million faces (the creature to 4.6 million).
const std::vector<Work> kClosed = {{"creature", 6}, {"mixed", 7}, {"cube", 8}};
/// Those with boundaries, where OpenMesh has other rules.
const std::vector<Work> kOpen = {{"teapot", 5}, {"torus_open", 6}};

/// What paintings of depth 1 are measured by.
const Work kShallow = {kLargestMesh, 1};

}  // namespace

void register_uniform(Extent extent, std::span<const Work> more) {
  const bool quick = extent == Extent::kQuick;
  const int repetitions = quick ? 3 : 7;
  const int repetitions_of_slow = quick ? 1 : 3;
  for (const Work& work : large_works()) {
    add(work, kLimn, repetitions);
    add(work, kOpenSubdiv, repetitions);
    if (!quick) {
      add(work, kOthers, repetitions_of_slow);
    }
  }
  add(kShallow, kLimn, repetitions);
  add(large_works().front(), kLimnElsewise, repetitions);
  for (const Work& work : more) {
    add(work, kLimn, repetitions);
    add(work, kOpenSubdiv, repetitions);
  }
  if (quick) {
    return;
  }
  add(large_works().front(), kOpenSubdivElsewise, repetitions);
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

void register_loop(Extent extent) {
  const bool quick = extent == Extent::kQuick;
  for (const Work& work : loop_works()) {
    add(work, kLimnLoop, quick ? 3 : 7);
    add(work, kOpenSubdiv, quick ? 3 : 7);
    if (!quick) {
      add(work, kOthers, 3);
    }
  }
}

}  // namespace limn::bench
