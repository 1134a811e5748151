#pragma once

#include <algorithm>
#include <cstddef>

#include "subdivision/parallel_ranges.h"

// Internal to this folder.
namespace limn {

/// Work cut into few long ranges of consecutive items. How it is cut depends on the number of items
/// alone, so what is kept for each lane is the same for any number of threads.
class Lanes {
 public:
  explicit Lanes(std::size_t items)
      : Lanes(items, std::clamp<std::size_t>(items / kItems, 1, kMost)) {}
  Lanes(std::size_t items, std::size_t count) : items_(items), count_(count) {}

  [[nodiscard]] std::size_t count() const noexcept { return count_; }
  [[nodiscard]] std::size_t begin(std::size_t lane) const noexcept {
    return items_ / count_ * lane + std::min(lane, items_ % count_);
  }
  [[nodiscard]] std::size_t end(std::size_t lane) const noexcept { return begin(lane + 1); }

  /// Calls `body(lane)` for every lane, from several threads at once.
  template <class Body>
  void each(const Body& body) const {
    if (count_ == 1) {
      body(0);
      return;
    }
    parallel_ranges(0, count_, 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t lane = first; lane < last; ++lane) {
        body(lane);
      }
    });
  }

 private:
  static constexpr std::size_t kItems = std::size_t{1} << 17;
  static constexpr std::size_t kMost = 16;

  std::size_t items_;
  std::size_t count_;
};

}  // namespace limn
