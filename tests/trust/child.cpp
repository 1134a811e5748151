#include "child.h"

#include <algorithm>
#include <chrono>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace limn::trust {
namespace {

struct Ended {
  int status = 0;
  std::size_t peak_bytes = 0;
};

Ended run(const std::function<bool()>& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::_exit(work() ? 0 : 1);
  }
  Ended ended;
  rusage usage{};
  ::wait4(child, &ended.status, 0, &usage);
  ended.peak_bytes = static_cast<std::size_t>(usage.ru_maxrss) * 1024;
  return ended;
}

}  // namespace

ChildRun run_in_child(const std::function<bool()>& work) {
  const std::size_t idle = run([] { return true; }).peak_bytes;
  const auto start = std::chrono::steady_clock::now();
  const Ended ended = run(work);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  const bool has_ended = WIFEXITED(ended.status) && WEXITSTATUS(ended.status) <= 1;
  return {has_ended, has_ended && WEXITSTATUS(ended.status) == 0, time.count(),
          std::max(ended.peak_bytes, idle) - idle};
}

}  // namespace limn::trust
