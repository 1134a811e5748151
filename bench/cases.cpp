#include "cases.h"

#include <chrono>
#include <utility>

namespace limn::bench {
namespace {

bool failed = false;

}  // namespace

void add_case(const std::string& name, int repetitions,
              std::function<void(benchmark::State&)> run) {
  // NOLINTNEXTLINE(clang-analyzer-cplusplus.NewDeleteLeaks): Google Benchmark keeps it.
  benchmark::RegisterBenchmark(name.c_str(), std::move(run))
      ->Iterations(1)
      ->Repetitions(repetitions)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
}

void time_run(benchmark::State& state, const std::function<void()>& work, int parts) {
  using Clock = std::chrono::steady_clock;
  while (state.KeepRunning()) {
    const Clock::time_point start = Clock::now();
    work();
    state.SetIterationTime(std::chrono::duration<double>(Clock::now() - start).count() / parts);
  }
}

void fail_run(benchmark::State& state, const std::string& why) {
  failed = true;
  state.SkipWithError(why.c_str());
}

bool has_failed() {
  return failed;
}

}  // namespace limn::bench
