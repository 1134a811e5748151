// limn_bench [--quick] [options of Google Benchmark]
// Measures Limn and its peers in one program. scripts/bench.sh runs it and writes the report.
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include <benchmark/benchmark.h>

#include "cases.h"
#include "machine.h"
#include "memory.h"

namespace {

/// Google Benchmark's arguments: our defaults, then those given, which win.
std::vector<std::string> with_defaults(int argc, char** argv, bool& quick) {
  std::vector<std::string> arguments{argv[0], "--benchmark_enable_random_interleaving=true",
                                     "--benchmark_display_aggregates_only=true"};
  for (int i = 1; i < argc; ++i) {
    if (std::string_view(argv[i]) == "--quick") {
      quick = true;
    } else {
      arguments.emplace_back(argv[i]);
    }
  }
  return arguments;
}

}  // namespace

int main(int argc, char** argv) {
  using limn::bench::Extent;
  limn::bench::settle_allocator();
  constexpr int kPeakArguments = 5;
  if (argc == kPeakArguments && std::string_view(argv[1]) == "--measure-peak") {
    return limn::bench::print_peak(argv[2], {argv[3], std::atoi(argv[4])});
  }

  bool quick = false;
  std::vector<std::string> arguments = with_defaults(argc, argv, quick);
  std::vector<char*> pointers;
  for (std::string& argument : arguments) {
    pointers.push_back(argument.data());
  }
  int count = static_cast<int>(pointers.size());
  benchmark::Initialize(&count, pointers.data());
  if (benchmark::ReportUnrecognizedArguments(count, pointers.data())) {
    return 2;
  }
  limn::bench::describe_machine();
  const Extent extent = quick ? Extent::kQuick : Extent::kAll;
  limn::bench::register_bounds(extent);
  limn::bench::register_agreement(extent);
  limn::bench::register_uniform(extent);
  limn::bench::register_memory(extent);
  limn::bench::register_adaptive(extent);
#ifdef LIMN_BENCH_PICKING
  limn::bench::register_picking(extent);
#endif
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return limn::bench::has_failed() ? 1 : 0;
}
