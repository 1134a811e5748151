#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

// Internal to this folder.
namespace limn {

/// A set of small integers that knows its least: bits, over bits that tell which words of bits are
/// not zero, and so on up to one word. Every operation looks at one word a level: four for sixteen
/// million.
class IndexSet {
 public:
  IndexSet() = default;
  /// An empty set of numbers below `size`.
  explicit IndexSet(std::size_t size) {
    std::size_t words = size;
    do {
      words = (words + 63) / 64;
      levels_.emplace_back(words, 0);
    } while (words > 1);
  }

  [[nodiscard]] bool has_room() const noexcept { return !levels_.empty(); }
  [[nodiscard]] bool empty() const noexcept { return levels_.back().front() == 0; }

  void insert(std::uint32_t i) noexcept {
    for (std::vector<std::uint64_t>& words : levels_) {
      const bool was_empty = words[i / 64] == 0;
      words[i / 64] |= std::uint64_t{1} << (i % 64);
      if (!was_empty) {
        return;
      }
      i /= 64;
    }
  }
  void erase(std::uint32_t i) noexcept {
    for (std::vector<std::uint64_t>& words : levels_) {
      words[i / 64] &= ~(std::uint64_t{1} << (i % 64));
      if (words[i / 64] != 0) {
        return;
      }
      i /= 64;
    }
  }
  /// The least element of a set that is not empty.
  [[nodiscard]] std::uint32_t first() const noexcept {
    std::uint32_t i = 0;
    for (std::size_t level = levels_.size(); level-- > 0;) {
      i = 64 * i + static_cast<std::uint32_t>(std::countr_zero(levels_[level][i]));
    }
    return i;
  }

 private:
  std::vector<std::vector<std::uint64_t>> levels_;  ///< The bits themselves first.
};

/// Why the greedy takes one vertex before another; the order of the enumerators' fields is the
/// order of their weight.
struct CandidateRank {
  bool is_near_leaf = false;  ///< Beside an illegal vertex of valence 1: before all others.
  std::uint32_t valence = 0;  ///< The highest first.
  std::uint32_t cost = 0;     ///< The lowest first.

  [[nodiscard]] bool operator==(const CandidateRank&) const = default;
  [[nodiscard]] bool is_before(const CandidateRank& other) const noexcept {
    if (is_near_leaf != other.is_near_leaf) {
      return is_near_leaf;
    }
    return valence != other.valence ? valence > other.valence : cost < other.cost;
  }
};

/// Illegal vertices in the greedy's order; among equals the lowest index is first.
///
/// Ranks with a valence and a cost below 8 have a set of vertices each, so that all but vertices of
/// many edges are moved in constant time. The others wait in a heap, which is corrected only when
/// it is asked.
class CandidateQueue {
 public:
  /// Where a vertex waits: the number of a set, or one of these.
  using Place = std::uint8_t;
  static constexpr Place kNowhere = 255;
  static constexpr Place kInHeap = 254;

  struct Candidate {
    CandidateRank rank;
    std::uint32_t vertex = 0;

    [[nodiscard]] bool is_before(const Candidate& other) const noexcept {
      return rank == other.rank ? vertex < other.vertex : rank.is_before(other.rank);
    }
  };

  explicit CandidateQueue(std::size_t vertices) : vertices_(vertices) {}

  /// Moves a vertex from where it waits to where `rank` puts it; returns that place. To be called
  /// whenever its rank changes.
  [[nodiscard]] Place move(std::uint32_t vertex, Place from, const CandidateRank& rank) {
    if (!has_set(rank)) {
      leave(vertex, from);
      heap_.push({rank, vertex});
      return kInHeap;
    }
    const Place to = set_of(rank);
    if (to != from) {
      leave(vertex, from);
      if (!sets_[to].has_room()) {
        sets_[to] = IndexSet(vertices_);
      }
      sets_[to].insert(vertex);
      filled_[to / 64] |= std::uint64_t{1} << (to % 64);
    }
    return to;
  }

  void leave(std::uint32_t vertex, Place from) noexcept {
    if (from < kSets) {
      sets_[from].erase(vertex);
      if (sets_[from].empty()) {
        filled_[from / 64] &= ~(std::uint64_t{1} << (from % 64));
      }
    }
  }

  /// The first candidate, if any. `is_current(candidate)` says whether a vertex in the heap still
  /// waits there with that rank.
  template <class IsCurrent>
  [[nodiscard]] std::optional<Candidate> first(const IsCurrent& is_current) {
    std::optional<Candidate> best;
    for (std::size_t half = 0; half < filled_.size() && !best; ++half) {
      if (filled_[half] != 0) {
        const auto set = static_cast<std::uint32_t>(64 * half) +
                         static_cast<std::uint32_t>(std::countr_zero(filled_[half]));
        best = Candidate{rank_of(set), sets_[set].first()};
      }
    }
    while (!heap_.empty() && !is_current(heap_.top())) {
      heap_.pop();
    }
    return !heap_.empty() && (!best || heap_.top().is_before(*best)) ? heap_.top() : best;
  }

 private:
  static constexpr std::uint32_t kSmall = 8;  ///< Valences and costs below have a set each.
  static constexpr std::uint32_t kSets = 2 * kSmall * kSmall;

  struct IsAfter {
    bool operator()(const Candidate& a, const Candidate& b) const noexcept {
      return b.is_before(a);
    }
  };

  [[nodiscard]] static bool has_set(const CandidateRank& rank) noexcept {
    return rank.valence < kSmall && rank.cost < kSmall;
  }
  /// Sets are numbered in the order of their ranks.
  [[nodiscard]] static Place set_of(const CandidateRank& rank) noexcept {
    return static_cast<Place>((rank.is_near_leaf ? 0 : kSmall * kSmall) +
                              (kSmall - 1 - rank.valence) * kSmall + rank.cost);
  }
  [[nodiscard]] static CandidateRank rank_of(std::uint32_t set) noexcept {
    const std::uint32_t within = set % (kSmall * kSmall);
    return {set < kSmall * kSmall, kSmall - 1 - within / kSmall, within % kSmall};
  }

  std::size_t vertices_;
  std::array<IndexSet, kSets> sets_;
  std::array<std::uint64_t, kSets / 64> filled_{};  ///< A bit for each set that is not empty.
  std::priority_queue<Candidate, std::vector<Candidate>, IsAfter> heap_;
};

}  // namespace limn
