#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "limn/subdivision/settings.h"
#include "subdivision/child_labels.h"

// How much becomes of a face or an edge is a function of its labels alone. Internal to this folder.
namespace limn {

/// Labels run from 0 to kMaxDepth, and the uniform first step adds one.
inline constexpr std::size_t kLabels = kMaxDepth + 2;

using QuadLabels = std::array<std::uint8_t, 4>;

/// What a face of given labels becomes in the end.
struct FaceCounts {
  std::uint32_t quads = 0;   ///< 0 for illegal labels.
  std::uint32_t inside = 0;  ///< Vertices strictly inside, neither at its corners nor on its edges.
};

/// Counts for every quadruple of labels and every pair. One corner needs at most
/// 4^(kMaxDepth + 1) < 2^24 quads, so 32 bits hold all of them.
class LabelCounts {
 public:
  /// The one table, made on first use.
  [[nodiscard]] static const LabelCounts& table();

  [[nodiscard]] const FaceCounts& face(const QuadLabels& labels) const noexcept {
    return faces_[((labels[0] * kLabels + labels[1]) * kLabels + labels[2]) * kLabels + labels[3]];
  }
  /// Vertices strictly between the ends of an edge with labels a and b.
  [[nodiscard]] std::uint32_t edge(std::uint8_t a, std::uint8_t b) const noexcept {
    return edges_[a * kLabels + b];
  }
  /// Of a face with three or more sides and any labels that are positive throughout, split into
  /// one quad per corner.
  template <class Labels>
  [[nodiscard]] FaceCounts split(const Labels& labels) const noexcept;

 private:
  LabelCounts();
  FaceCounts count(const QuadLabels& labels) const;

  std::vector<FaceCounts> faces_;
  std::array<std::uint32_t, kLabels * kLabels> edges_{};
};

/// The label of the face point of a split face (0 too where the face is a Y-element).
template <class Labels>
[[nodiscard]] std::uint8_t face_point_label(const Labels& labels) noexcept {
  std::uint8_t label = 0;
  const std::size_t n = labels.size();
  for (std::size_t i = 0; i < n; ++i) {
    label = least_positive(label, edge_point_label(labels[i], labels[i + 1 == n ? 0 : i + 1]));
  }
  return label;
}

/// The labels of the quad that a split leaves at corner i, from there counter-clockwise.
template <class Labels>
[[nodiscard]] QuadLabels child_labels(const Labels& labels, std::size_t i,
                                      std::uint8_t face_point) noexcept {
  const std::size_t n = labels.size();
  const std::uint8_t before = labels[i == 0 ? n - 1 : i - 1];
  const std::uint8_t after = labels[i + 1 == n ? 0 : i + 1];
  return {lowered(labels[i]), edge_point_label(labels[i], after), face_point,
          edge_point_label(before, labels[i])};
}

template <class Labels>
FaceCounts LabelCounts::split(const Labels& labels) const noexcept {
  FaceCounts counts{0, 1};
  const std::uint8_t centre = face_point_label(labels);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const QuadLabels child = child_labels(labels, i, centre);
    const FaceCounts& part = face(child);
    counts.quads += part.quads;
    counts.inside += part.inside + edge(child[1], centre);
  }
  return counts;
}

}  // namespace limn
