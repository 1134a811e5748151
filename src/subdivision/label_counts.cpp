// Filled in the order of the greatest label, since children have smaller ones.
#include "subdivision/label_counts.h"

#include <algorithm>

#include "limn/subdivision/labels.h"

namespace limn {

const LabelCounts& LabelCounts::table() {
  static const LabelCounts counts;
  return counts;
}

LabelCounts::LabelCounts() : faces_(kLabels * kLabels * kLabels * kLabels) {
  const auto most = static_cast<std::uint8_t>(kLabels - 1);
  for (std::uint8_t a = 0; a <= most; ++a) {
    for (std::uint8_t b = 0; b <= a; ++b) {
      if (a > 0) {
        const std::uint8_t middle = edge_point_label(a, b);
        edges_[a * kLabels + b] = 1 + edge(lowered(a), middle) + edge(middle, lowered(b));
        edges_[b * kLabels + a] = edges_[a * kLabels + b];
      }
    }
  }
  for (std::uint8_t greatest = 0; greatest <= most; ++greatest) {
    for (std::uint8_t a = 0; a <= greatest; ++a) {
      for (std::uint8_t b = 0; b <= greatest; ++b) {
        for (std::uint8_t c = 0; c <= greatest; ++c) {
          for (std::uint8_t d = 0; d <= greatest; ++d) {
            if (std::max({a, b, c, d}) == greatest) {
              faces_[((a * kLabels + b) * kLabels + c) * kLabels + d] = count({a, b, c, d});
            }
          }
        }
      }
    }
  }
}

FaceCounts LabelCounts::count(const QuadLabels& labels) const {
  switch (quad_pattern(labels[0], labels[1], labels[2], labels[3])) {
    case FacePattern::kStays:
      return {1, 0};
    case FacePattern::kY: {
      const auto at = static_cast<std::size_t>(
          std::ranges::find_if(labels, [](int label) { return label > 0; }) - labels.begin());
      const FaceCounts& child = face(child_labels(labels, at, 0));
      return {child.quads + 2, child.inside + 1};
    }
    case FacePattern::kSplit:
      return split(labels);
    case FacePattern::kIllegal:
      break;
  }
  return {0, 0};
}

}  // namespace limn
