// Where labels follow from a node's own, the tables know what becomes of it.
#include "subdivision/fine/fine_counts.h"

#include <algorithm>

#include "limn/contract.h"
#include "subdivision/label_counts.h"

namespace limn {
namespace {

class Counter {
 public:
  explicit Counter(const FineWalk& walk) : walk_(walk), table_(LabelCounts::table()) {}

  /// Vertices strictly inside side i of a node.
  [[nodiscard]] std::uint32_t side(const WalkNode& node, std::uint32_t i) const {
    const std::uint8_t a = node.labels[i];
    const std::uint8_t b = node.labels[(i + 1) % 4];
    if (walk_.follows(node) || (a == 0 && b == 0)) {
      return table_.edge(a, b);
    }
    return 1 + half(node, i, i) + half(node, i, (i + 1) % 4);
  }

  void add(const WalkNode& node, FineFaceCounts& counts) const {
    if (walk_.follows(node)) {
      const FaceCounts& all = table_.face(node.labels);
      LIMN_EXPECTS(all.quads > 0);  // Else the labels are illegal.
      counts.quads += all.quads;
      counts.inside += all.inside;
      reach(node.level + *std::ranges::max_element(node.labels), counts);
      return;
    }
    switch (node.pattern()) {
      case FacePattern::kStays:
        ++counts.quads;
        reach(node.level, counts);
        break;
      case FacePattern::kY:
        counts.quads += 2;
        ++counts.inside;
        reach(node.level + 1, counts);
        add(walk_.child(node, node.positive_corner()), counts);
        break;
      case FacePattern::kSplit:
        ++counts.inside;
        for (std::uint32_t i = 0; i < 4; ++i) {
          const WalkNode child = walk_.child(node, i);
          counts.inside += side(child, (i + 1) % 4);
          add(child, counts);
        }
        break;
      case FacePattern::kIllegal:
        LIMN_EXPECTS(!"legal labels");
    }
  }

 private:
  /// Inside the half of side i at a corner of it. A corner that is zero has none there.
  [[nodiscard]] std::uint32_t half(const WalkNode& node, std::uint32_t i,
                                   std::uint32_t corner) const {
    return node.labels[corner] == 0 ? 0 : side(walk_.child(node, corner), i);
  }
  static void reach(int level, FineFaceCounts& counts) {
    counts.deepest = static_cast<std::uint8_t>(std::max<int>(counts.deepest, level));
  }

  const FineWalk& walk_;
  const LabelCounts& table_;
};

}  // namespace

FineCounts::FineCounts(const Cage& cage, std::span<const std::uint8_t> labels,
                       const FineLabels& fine, int levels)
    : numbers_(cage.face_count(), kNone) {
  const FineWalk walk(&fine, levels);
  const Counter counter(walk);
  for (const std::uint32_t f : fine.faces) {
    const FaceLabels face(cage, labels, f);
    const auto n = static_cast<std::uint32_t>(face.size());
    numbers_[f] = static_cast<std::uint32_t>(faces_.size());
    first_sides_.push_back(static_cast<std::uint32_t>(sides_.size()));
    sides_.resize(sides_.size() + n, 0);
    FineFaceCounts& counts = faces_.emplace_back();
    std::uint32_t* const sides = sides_.data() + first_sides_.back();
    const bool is_y = n == 4 && walk.root(face).pattern() == FacePattern::kY;
    std::uint32_t positive = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
      positive += face[i] > 0 ? 1 : 0;
    }
    if (positive == 0) {
      counts.quads = 1;
      continue;
    }
    LIMN_EXPECTS(n == 4 ? walk.root(face).pattern() != FacePattern::kIllegal : positive == n);
    counts.quads = is_y ? 2 : 0;
    counts.inside = 1;
    counts.deepest = 1;
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t after = i + 1 == n ? 0 : i + 1;
      if (face[i] > 0 || face[after] > 0) {
        ++sides[i];
      }
      if (is_y && face[i] == 0) {
        continue;
      }
      const WalkNode child = walk.child_of_root(f, face, i);
      const std::uint32_t turn = n == 4 ? i : 0;
      sides[i] += counter.side(child, turn);
      sides[i == 0 ? n - 1 : i - 1] += counter.side(child, (turn + 3) % 4);
      if (!is_y) {
        counts.inside += counter.side(child, (turn + 1) % 4);
      }
      counter.add(child, counts);
    }
  }
}

}  // namespace limn
