#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "subdivision/label_counts.h"

// How many nodes of which kind the quadtree of a patch has is a function of labels alone, too.
// Internal to this folder and to those who refine elsewhere.
namespace limn {

/// Nodes whose labels are all equal, and at most so great, are refined as grids: the numbers of
/// vertices and quads run row by row through them.
inline constexpr std::size_t kMostUniformLevels = 6;

/// Kinds of nodes: kind 0 is split or becomes a Y-element, kind a = 1..kMostUniformLevels is a
/// uniform node of label a. Resting quads are no nodes, but their parents'.
inline constexpr std::size_t kNodeKinds = kMostUniformLevels + 1;
using NodeCounts = std::array<std::uint32_t, kNodeKinds>;

/// What becomes of one quadruple of labels.
struct SubtreeCounts {
  FaceCounts face;
  NodeCounts nodes{};
};
static_assert(sizeof(SubtreeCounts) == (2 + kNodeKinds) * sizeof(std::uint32_t));

/// SubtreeCounts of all quadruples with labels 0..greatest: that of (a, b, c, d) stands at
/// ((a n + b) n + c) n + d, n = greatest + 1.
class SubtreeTable {
 public:
  /// Of labels 0 alone.
  SubtreeTable() : counts_(1) { counts_[0].face = {1, 0}; }
  explicit SubtreeTable(std::uint8_t greatest);

  [[nodiscard]] std::size_t label_count() const noexcept { return label_count_; }
  [[nodiscard]] const std::vector<SubtreeCounts>& all() const noexcept { return counts_; }
  [[nodiscard]] const SubtreeCounts& of(const QuadLabels& labels) const noexcept {
    return counts_[index(labels)];
  }

 private:
  [[nodiscard]] std::size_t index(const QuadLabels& labels) const noexcept {
    return ((labels[0] * label_count_ + labels[1]) * label_count_ + labels[2]) * label_count_ +
           labels[3];
  }
  [[nodiscard]] SubtreeCounts count(const QuadLabels& labels) const;

  std::size_t label_count_ = 1;
  std::vector<SubtreeCounts> counts_;
};

}  // namespace limn
