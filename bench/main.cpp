// limn_bench [--quick] [--mesh=FILE.obj:LEVELS...] [options of Google Benchmark]
// limn_bench --legalisation-tables
// Measures Limn and its peers in one program. scripts/bench.sh runs it and writes the report.
#include <algorithm>
#include <charconv>
#include <iostream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include <benchmark/benchmark.h>

#include "cases.h"
#include "legalisation_table.h"
#include "limn/error.h"
#include "limn/subdivision/settings.h"
#include "machine.h"
#include "memory.h"

namespace {

using namespace limn::bench;  // NOLINT(google-build-using-namespace)

struct Arguments {
  Extent extent = Extent::kAll;
  std::vector<Work> meshes;
  std::vector<std::string> others;  ///< Google Benchmark's.
};

/// A mesh given as FILE:LEVELS.
limn::Result<Work> read_mesh(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  int levels = 0;
  if (colon != std::string::npos) {
    std::from_chars(text.data() + colon + 1, text.data() + text.size(), levels);
  }
  if (levels < 1 || levels > limn::kMaxDepth) {
    return limn::fail(limn::ErrorKind::kUsage, "--mesh wants FILE.obj:LEVELS, not " + text);
  }
  return add_control_mesh(text.substr(0, colon)).map([&](const std::string& name) {
    return Work{name, levels};
  });
}

/// Our arguments, and for Google Benchmark our defaults, then what was given, which wins.
limn::Result<Arguments> read_arguments(int argc, char** argv) {
  Arguments arguments;
  arguments.others = {argv[0], "--benchmark_enable_random_interleaving=true",
                      "--benchmark_display_aggregates_only=true"};
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--quick") {
      arguments.extent = Extent::kQuick;
    } else if (constexpr std::string_view kMesh = "--mesh="; argument.starts_with(kMesh)) {
      const limn::Result<Work> work = read_mesh(argument.substr(kMesh.size()));
      if (!work) {
        return tl::unexpected(work.error());
      }
      arguments.meshes.push_back(*work);
    } else {
      arguments.others.push_back(argument);
    }
  }
  return arguments;
}

/// A line for each case: its median.
class MedianReporter final : public benchmark::ConsoleReporter {
 public:
  MedianReporter() : ConsoleReporter(OO_None) {}

  void ReportRuns(const std::vector<Run>& runs) override {  // NOLINT: Google Benchmark's name.
    std::vector<Run> medians;
    std::ranges::copy_if(runs, std::back_inserter(medians), [](const Run& run) {
      return run.run_type == Run::RT_Aggregate ? run.aggregate_name == "median"
                                               : run.repetitions <= 1;
    });
    if (!medians.empty()) {
      ConsoleReporter::ReportRuns(medians);
    }
  }
};

void register_all(const Arguments& arguments) {
  register_bounds(arguments.extent);
  register_agreement(arguments.extent);
  register_uniform(arguments.extent, arguments.meshes);
  register_loop(arguments.extent);
  register_memory(arguments.extent);
  register_adaptive(arguments.extent);
  register_limit(arguments.extent);
  register_cracks(arguments.extent);
  register_choosing(arguments.extent);
  register_legalisation(arguments.extent);
#ifdef LIMN_BENCH_PICKING
  register_picking(arguments.extent);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  settle_allocator();
  if (argc == 2 && std::string_view(argv[1]).starts_with(kPeakOption)) {
    return print_peak(argv[1] + std::string_view(kPeakOption).size()) ? 0 : 2;
  }

  if (argc == 2 && std::string_view(argv[1]) == "--legalisation-tables") {
    return write_legalisation_tables(std::cout) ? 0 : 1;
  }

  limn::Result<Arguments> arguments = read_arguments(argc, argv);
  if (!arguments) {
    std::cerr << "limn_bench: " << limn::to_string(arguments.error()) << "\n";
    return 2;
  }
  std::vector<char*> pointers;
  for (std::string& argument : arguments->others) {
    pointers.push_back(argument.data());
  }
  int count = static_cast<int>(pointers.size());
  benchmark::Initialize(&count, pointers.data());
  if (benchmark::ReportUnrecognizedArguments(count, pointers.data())) {
    return 2;
  }
  describe_machine();
  register_all(*arguments);
  MedianReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  benchmark::Shutdown();
  return has_failed() ? 1 : 0;
}
