// Candidates wait in a heap. Whoever a relabel concerns is put in anew with the rank it has now; an
// entry whose rank is not that of its vertex any more counts for nothing.
#include "subdivision/fine/level_legalisation.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <queue>
#include <tuple>

#include "subdivision/legality_problem.h"

namespace limn {
namespace {

class Level {
 public:
  Level(std::span<const ForestNode> quads, std::vector<std::uint8_t>& labels)
      : quads_(quads), labels_(&labels), first_quads_(labels.size() + 1, 0) {
    for (const ForestNode& quad : quads) {
      for (const std::uint32_t v : quad.vertices) {
        ++first_quads_[v + 1];
      }
    }
    std::partial_sum(first_quads_.begin(), first_quads_.end(), first_quads_.begin());
    quads_around_.resize(first_quads_.back());
    std::vector<std::uint32_t> next(first_quads_.begin(), first_quads_.end() - 1);
    for (std::uint32_t q = 0; q < quads.size(); ++q) {
      for (const std::uint32_t v : quads[q].vertices) {
        quads_around_[next[v]++] = q;
      }
    }
  }

  [[nodiscard]] bool is_illegal(std::uint32_t q) const { return is_illegal_mask(mask_of(q)); }

  void queue_candidates(std::uint32_t q) {
    for (const std::uint32_t v : quads_[q].vertices) {
      if ((*labels_)[v] == 0) {
        if (const Rank rank = rank_of(v); std::get<0>(rank) > 0) {
          queue_.push(rank);
        }
      }
    }
  }

  void raise_all() {
    while (!queue_.empty()) {
      const Rank rank = queue_.top();
      queue_.pop();
      const std::uint32_t v = ~std::get<3>(rank);
      if ((*labels_)[v] > 0 || rank_of(v) != rank) {
        continue;
      }
      (*labels_)[v] = 1;
      for (const std::uint32_t q : around(v)) {
        queue_candidates(q);
      }
    }
  }

 private:
  /// Whether it mends any, how many more it mends than it makes, faces it adds (fewer first), and
  /// its number (lower first).
  using Rank = std::tuple<int, int, int, std::uint32_t>;

  [[nodiscard]] std::span<const std::uint32_t> around(std::uint32_t v) const {
    return std::span(quads_around_).subspan(first_quads_[v], first_quads_[v + 1] - first_quads_[v]);
  }
  [[nodiscard]] unsigned mask_of(std::uint32_t q) const {
    unsigned mask = 0;
    for (unsigned i = 0; i < 4; ++i) {
      mask |= static_cast<unsigned>((*labels_)[quads_[q].vertices[i]] > 0) << i;
    }
    return mask;
  }
  [[nodiscard]] Rank rank_of(std::uint32_t v) const {
    int mended = 0;
    int made = 0;
    int added = 0;
    for (const std::uint32_t q : around(v)) {
      const unsigned before = mask_of(q);
      unsigned after = before;
      for (unsigned i = 0; i < 4; ++i) {
        after |= static_cast<unsigned>(quads_[q].vertices[i] == v) << i;
      }
      mended += is_illegal_mask(before) ? 1 : 0;
      made += is_illegal_mask(after) ? 1 : 0;
      added += static_cast<int>(added_faces_of(after)) - static_cast<int>(added_faces_of(before));
    }
    return {mended > 0 ? 1 : 0, mended - made, -added, ~v};
  }

  std::span<const ForestNode> quads_;
  std::vector<std::uint8_t>* labels_;
  std::vector<std::uint32_t> first_quads_;  ///< Prefix sums of quads around vertices.
  std::vector<std::uint32_t> quads_around_;
  std::priority_queue<Rank> queue_;
};

}  // namespace

void legalise_level(std::span<const ForestNode> quads, std::vector<std::uint8_t>& labels) {
  Level level(quads, labels);
  for (std::uint32_t q = 0; q < quads.size(); ++q) {
    if (level.is_illegal(q)) {
      level.queue_candidates(q);
    }
  }
  level.raise_all();
}

}  // namespace limn
