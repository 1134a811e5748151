#pragma once

#include <cstddef>
#include <functional>

namespace limn::trust {

struct ChildRun {
  bool has_ended = false;  ///< By itself, without a signal.
  bool result = false;     ///< What the work said.
  double seconds = 0.0;
  std::size_t peak_bytes = 0;  ///< Beyond what a child has that does nothing.
};

/// Does `work` in a process of its own and measures that.
[[nodiscard]] ChildRun run_in_child(const std::function<bool()>& work);

}  // namespace limn::trust
