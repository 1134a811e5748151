#pragma once

#include <cstdio>
#include <string>

namespace limn::trust {

/// Prints what was measured of promises, a line each: the promise, the figure, the bound and
/// whether it is kept, parted by tabs.
class Promises {
 public:
  void tell(const std::string& promise, const std::string& figure, const std::string& bound,
            bool is_kept) {
    std::printf("%s\t%s\t%s\t%s\n", promise.c_str(), figure.c_str(), bound.c_str(),
                is_kept ? "kept" : "BROKEN");
    std::fflush(stdout);
    are_kept_ = are_kept_ && is_kept;
  }
  /// What the program is to return.
  [[nodiscard]] int exit_code() const noexcept { return are_kept_ ? 0 : 1; }

 private:
  bool are_kept_ = true;
};

}  // namespace limn::trust
