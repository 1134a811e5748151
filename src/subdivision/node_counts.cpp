// Filled in the order of the greatest label, since children have smaller ones.
#include "subdivision/node_counts.h"

#include <algorithm>

#include "limn/subdivision/labels.h"

namespace limn {
namespace {

/// Calls `visit` for the labels of each child that a node of these labels has.
template <class Visit>
void for_each_child(const QuadLabels& labels, const Visit& visit) {
  switch (quad_pattern(labels[0], labels[1], labels[2], labels[3])) {
    case FacePattern::kY: {
      const auto at = static_cast<std::size_t>(
          std::ranges::find_if(labels, [](int label) { return label > 0; }) - labels.begin());
      visit(child_labels(labels, at, 0));
      return;
    }
    case FacePattern::kSplit: {
      const std::uint8_t centre = face_point_label(labels);
      for (std::size_t i = 0; i < 4; ++i) {
        visit(child_labels(labels, i, centre));
      }
      return;
    }
    case FacePattern::kStays:
    case FacePattern::kIllegal:
      return;
  }
}

}  // namespace

SubtreeTable::SubtreeTable(std::uint8_t greatest)
    : label_count_(greatest + std::size_t{1}),
      counts_(label_count_ * label_count_ * label_count_ * label_count_) {
  for (std::uint8_t most = 0; most <= greatest; ++most) {
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      QuadLabels labels{};
      std::size_t rest = i;
      for (std::size_t k = 4; k-- > 0; rest /= label_count_) {
        labels[k] = static_cast<std::uint8_t>(rest % label_count_);
      }
      if (std::ranges::max(labels) == most) {
        counts_[i] = count(labels);
      }
    }
  }
}

SubtreeCounts SubtreeTable::count(const QuadLabels& labels) const {
  SubtreeCounts counts;
  counts.face = LabelCounts::table().face(labels);
  const auto [a, b, c, d] = labels;
  if (a == b && b == c && c == d && a <= kMostUniformLevels) {
    counts.nodes[a] = a > 0 ? 1 : 0;
    return counts;
  }
  counts.nodes[0] = 1;
  for_each_child(labels, [&](const QuadLabels& child) {
    const NodeCounts& part = of(child).nodes;
    std::ranges::transform(counts.nodes, part, counts.nodes.begin(), std::plus<>());
  });
  return counts;
}

}  // namespace limn
