#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include <benchmark/benchmark.h>

#include "meshes.h"

namespace limn::bench {

/// How much is measured: all, or what a minute allows.
enum class Extent { kAll, kQuick };

// Every file of cases registers its own with Google Benchmark. The names are paths that the report
// reads: subject/.../program. All runs of all cases are made in random order.

/// `uniform/MESH/LEVELS/PROGRAM`: Limn and peers to the same finest mesh, and Limn and OpenSubdiv
/// for `more` meshes.
void register_uniform(Extent extent, std::span<const Work> more);
/// `loop/MESH/LEVELS/PROGRAM`: the same by Loop's scheme, on triangle meshes.
void register_loop(Extent extent);
/// `agreement/MESH/LEVELS/PROGRAM`: that they compute the same.
void register_agreement(Extent extent);
/// `memory/MESH/LEVELS/PROGRAM`, by Loop's scheme for triangle meshes, and
/// `memory/LAYOUT/PERCENT/DEPTH/limn`: peak memory.
void register_memory(Extent extent);
/// With this before a memory case's name the program measures that case alone, by `print_peak`,
/// which is false where there is no such case.
inline constexpr const char* kPeakOption = "--measure-peak=";
bool print_peak(std::string_view name);
/// `adaptive/LAYOUT/PERCENT/DEPTH/PROGRAM`: paintings of the largest asteroid.
void register_adaptive(Extent extent);
/// `cracks/MESH/LEVELS/PROGRAM` and `cracks/LAYOUT/PERCENT/DEPTH/PROGRAM`: the crack check.
void register_cracks(Extent extent);

/// `choosing/MESH/RULE/choose` and `/refine`: choosing depths, and the refinement it leads to.
void register_choosing(Extent extent);
/// `limit/MESH/LEVELS/WISH`: limit positions and normals on top of a refinement.
void register_limit(Extent extent);
/// `legalise/ILLEGAL/METHOD`: illegal vertices of painted tori, ten thousand to a million.
void register_legalisation(Extent extent);
/// `bounds/KIND/THREADS`: how fast the machine copies and hands out memory.
void register_bounds(Extent extent);
/// `picking/QUESTION`: what is under the pointer, on 399,424 quads. There with the program only.
void register_picking(Extent extent);

/// A case of `repetitions` runs, each of which times its work itself, by `time_run`.
void add_case(const std::string& name, int repetitions, std::function<void(benchmark::State&)> run);

/// Does `work` once with the clock running; the run's time is `1 / parts` of what it takes.
void time_run(benchmark::State& state, const std::function<void()>& work, int parts = 1);

/// Ends a run as failed: a program that computes something else has no time worth telling. The
/// program as a whole fails then.
void fail_run(benchmark::State& state, const std::string& why);
[[nodiscard]] bool has_failed();

}  // namespace limn::bench
