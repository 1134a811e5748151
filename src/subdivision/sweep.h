#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
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
  /// `scratch` is kept between runs, so that numbering allocates once.
  Sweep(Progress& progress, std::vector<std::uint64_t>& scratch)
      : progress_(&progress), scratch_(&scratch) {}

  /// The loops that follow visit about `items` items in all, and take the overall fraction from
  /// `from` to `to`. `stage` outlives them.
  void begin_stage(std::string_view stage, double from, double to, std::uint64_t items) {
    stage_ = stage;
    from_ = from;
    to_ = to;
    items_ = std::max<std::uint64_t>(items, 1);
    done_ = 0;
    report();
  }

  [[nodiscard]] bool is_cancelled() const noexcept { return is_cancelled_; }

  /// Calls `body(i)` for every i in 0..n - 1, in any order, from any thread.
  template <class Body>
  void each(std::size_t n, const Body& body) {
    ranges(n, kSlab, kBlock, 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        body(i);
      }
    });
  }

  /// Numbers items with one parallel count and one parallel assignment: item i takes
  /// `sizes(i)[k]` consecutive numbers of each kind k, the first items from `start` on;
  /// `assign(i, firsts)` is told the first of them and returns `sizes(i)`. Returns where the
  /// numbers end, or `start` if cancelled.
  template <std::size_t K, class Sizes, class Assign>
  std::array<std::uint64_t, K> number(std::size_t n, const std::array<std::uint64_t, K>& start,
                                      const Sizes& sizes, const Assign& assign) {
    const std::size_t blocks = (n + kBlock - 1) / kBlock;
    scratch_->resize(blocks * K);
    const auto first_of = [this](std::size_t block, std::size_t k) -> std::uint64_t& {
      return (*scratch_)[block * K + k];
    };
    const auto end_of = [n](std::size_t block) { return std::min(n, (block + 1) * kBlock); };
    ranges(blocks, kSlab / kBlock, 1, kBlock, [&](std::size_t begin, std::size_t end) {
      for (std::size_t block = begin; block < end; ++block) {
        std::array<std::uint64_t, K> sum{};
        for (std::size_t i = block * kBlock; i < end_of(block); ++i) {
          advance(sum, sizes(i));
        }
        for (std::size_t k = 0; k < K; ++k) {
          first_of(block, k) = sum[k];
        }
      }
    });
    std::array<std::uint64_t, K> next = start;
    for (std::size_t block = 0; block < blocks && !is_cancelled_; ++block) {
      for (std::size_t k = 0; k < K; ++k) {
        const std::uint64_t size = std::exchange(first_of(block, k), next[k]);
        next[k] += size;
      }
    }
    ranges(blocks, kSlab / kBlock, 1, kBlock, [&](std::size_t begin, std::size_t end) {
      for (std::size_t block = begin; block < end; ++block) {
        std::array<std::uint64_t, K> first{};
        for (std::size_t k = 0; k < K; ++k) {
          first[k] = first_of(block, k);
        }
        for (std::size_t i = block * kBlock; i < end_of(block); ++i) {
          advance(first, assign(i, std::as_const(first)));
        }
      }
    });
    return is_cancelled_ ? start : next;
  }

  /// Calls `body(first, last)` for ranges that make up 0..n - 1, of about `grain` items each, and
  /// reports whenever about `slab` are done. An item counts as `weight` of the stage's items.
  template <class Body>
  void ranges(std::size_t n, std::size_t slab, std::size_t grain, std::uint64_t weight,
              const Body& body) {
    for (std::size_t begin = 0; begin < n && !is_cancelled_; begin += slab) {
      const std::size_t end = std::min(n, begin + slab);
      if (end - begin <= grain) {
        body(begin, end);
      } else {
        parallel_ranges(begin, end, grain, body);
      }
      done_ += (end - begin) * weight;
      report();
    }
  }

 private:
  /// Items between two reports: a few milliseconds of work on one thread.
  static constexpr std::size_t kSlab = std::size_t{1} << 18;
  /// Items one thread takes at a time.
  static constexpr std::size_t kBlock = std::size_t{1} << 11;

  template <std::size_t K>
  static void advance(std::array<std::uint64_t, K>& sum, const std::array<std::uint64_t, K>& size) {
    for (std::size_t k = 0; k < K; ++k) {
      sum[k] += size[k];
    }
  }

  void report() {
    const double share = std::min(1.0, static_cast<double>(done_) / static_cast<double>(items_));
    if (!is_cancelled_ && !progress_->report(from_ + (to_ - from_) * share, stage_)) {
      is_cancelled_ = true;
    }
  }

  Progress* progress_;
  std::vector<std::uint64_t>* scratch_;
  std::string_view stage_;
  double from_ = 0.0;
  double to_ = 1.0;
  std::uint64_t items_ = 1;
  std::uint64_t done_ = 0;
  bool is_cancelled_ = false;
};

}  // namespace limn
