#pragma once

#include <chrono>
#include <string>

#include "limn/subdivision/schemes/uniform.h"

namespace limn::cli {

/// Seconds since it was made.
class Stopwatch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// A level that was made, and how long that took.
struct SchemeLevel {
  int level = 0;
  SchemeCounts counts;
  double seconds = 0.0;
};

/// "level 2: 162 vertices, 480 edges, 320 faces, 0.031 ms".
[[nodiscard]] std::string level_text(const SchemeLevel& level);

}  // namespace limn::cli
