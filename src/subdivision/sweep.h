#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "limn/progress.h"
#include "subdivision/parallel_ranges.h"

// Internal to this folder.
namespace limn {

/// Runs the loops of a refinement in parallel and tells a Progress about it.
///
/// Loops are cut into slabs; between slabs the calling thread reports. Once told to stop, every
/// further loop does nothing, so that callers need to ask `is_cancelled` at stage ends only.
class Sweep {
 public:
  explicit Sweep(Progress& progress) : progress_(&progress) {}

  /// The loops that follow visit about `items` items in all, and take the overall fraction from
  /// `from` to `to`.
  void begin_stage(std::string stage, double from, double to, std::size_t items) {
    stage_ = std::move(stage);
    from_ = from;
    to_ = to;
    items_ = std::max<std::size_t>(items, 1);
    done_ = 0;
    report();
  }

  [[nodiscard]] bool is_cancelled() const noexcept { return is_cancelled_; }

  /// Calls `body(i)` for every i in 0..n - 1, in any order, from any thread.
  template <class Body>
  void each(std::size_t n, const Body& body) {
    each_slab(n, kSlab, 1, body);
  }

  /// Numbers items with one parallel count and one parallel assignment: item i takes
  /// `sizes(i)[k]` consecutive numbers of each kind k; `assign(i, firsts, totals)` is told the
  /// first of them and how many there are of each kind in all. Returns the totals, zeros if
  /// cancelled.
  template <std::size_t K, class Sizes, class Assign>
  std::array<std::uint32_t, K> number(std::size_t n, const Sizes& sizes, const Assign& assign) {
    const std::size_t blocks = (n + kBlock - 1) / kBlock;
    std::vector<std::array<std::uint32_t, K>> firsts(blocks);
    each_slab(blocks, kSlab / kBlock, kBlock, [&](std::size_t block) {
      std::array<std::uint32_t, K> sum{};
      const std::size_t end = std::min(n, (block + 1) * kBlock);
      for (std::size_t i = block * kBlock; i < end; ++i) {
        advance(sum, sizes(i));
      }
      firsts[block] = sum;
    });
    std::array<std::uint32_t, K> totals{};
    for (std::array<std::uint32_t, K>& first : firsts) {
      const std::array<std::uint32_t, K> size = std::exchange(first, totals);
      advance(totals, size);
    }
    each_slab(blocks, kSlab / kBlock, kBlock, [&](std::size_t block) {
      std::array<std::uint32_t, K> first = firsts[block];
      const std::size_t end = std::min(n, (block + 1) * kBlock);
      for (std::size_t i = block * kBlock; i < end; ++i) {
        assign(i, std::as_const(first), std::as_const(totals));
        advance(first, sizes(i));
      }
    });
    return is_cancelled_ ? std::array<std::uint32_t, K>{} : totals;
  }

 private:
  /// Items between two reports: a few milliseconds of work on one thread.
  static constexpr std::size_t kSlab = std::size_t{1} << 18;
  /// Items one thread takes at a time.
  static constexpr std::size_t kBlock = std::size_t{1} << 11;

  template <std::size_t K>
  static void advance(std::array<std::uint32_t, K>& sum, const std::array<std::uint32_t, K>& size) {
    for (std::size_t k = 0; k < K; ++k) {
      sum[k] += size[k];
    }
  }

  template <class Body>
  void each_slab(std::size_t n, std::size_t slab, std::size_t weight, const Body& body) {
    for (std::size_t begin = 0; begin < n && !is_cancelled_; begin += slab) {
      const std::size_t end = std::min(n, begin + slab);
      const std::size_t grain = std::max<std::size_t>(1, kBlock / weight);
      if (end - begin <= grain) {
        for (std::size_t i = begin; i < end; ++i) {
          body(i);
        }
      } else {
        parallel_ranges(begin, end, grain, [&](std::size_t first, std::size_t last) {
          for (std::size_t i = first; i < last; ++i) {
            body(i);
          }
        });
      }
      done_ += (end - begin) * weight;
      report();
    }
  }

  void report() {
    const double share = std::min(1.0, static_cast<double>(done_) / static_cast<double>(items_));
    if (!is_cancelled_ && !progress_->report(from_ + (to_ - from_) * share, stage_)) {
      is_cancelled_ = true;
    }
  }

  Progress* progress_;
  std::string stage_;
  double from_ = 0.0;
  double to_ = 1.0;
  std::size_t items_ = 1;
  std::size_t done_ = 0;
  bool is_cancelled_ = false;
};

}  // namespace limn
