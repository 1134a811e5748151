#pragma once

#include <algorithm>
#include <cstdint>

#include "limn/subdivision/labels.h"
#include "subdivision/fine/fine_labels.h"
#include "subdivision/numbering.h"

// Down the quadtrees of control faces, where labels are given or follow. Internal to the library.
namespace limn {

/// A face of some level with its labels, which stop after so many levels as the walk does.
struct WalkNode {
  QuadLabels labels{};
  std::uint32_t given = kNone;  ///< Its FineLabels::Node; kNone: labels below follow from its own.
  int level = 0;

  [[nodiscard]] bool is_uniform(std::uint8_t label) const noexcept {
    return labels == QuadLabels{label, label, label, label};
  }
  [[nodiscard]] FacePattern pattern() const noexcept {
    return quad_pattern(labels[0], labels[1], labels[2], labels[3]);
  }
  /// The only corner that is positive, in a Y-element.
  [[nodiscard]] std::uint32_t positive_corner() const noexcept {
    return static_cast<std::uint32_t>(
        std::ranges::find_if(labels, [](std::uint8_t label) { return label > 0; }) -
        labels.begin());
  }
};

class FineWalk {
 public:
  /// Refinement stops after so many levels. `fine` may be null: all labels follow.
  FineWalk(const FineLabels* fine, int levels) : fine_(fine), levels_(levels) {}

  /// A control face that is a quad. `labels` of the control mesh are held to the levels.
  [[nodiscard]] WalkNode root(const FaceLabels& labels) const noexcept {
    return {{labels[0], labels[1], labels[2], labels[3]}, kNone, 0};
  }
  /// The child at corner i of a control face, which splits, or has a Y-element there.
  [[nodiscard]] WalkNode child_of_root(std::uint32_t face, const FaceLabels& labels,
                                       std::uint32_t i) const noexcept {
    const std::uint32_t turn = labels.size() == 4 ? i : 0;
    WalkNode child;
    child.level = 1;
    child.labels = turned(child_labels(labels, i, face_point_label(labels)), turn);
    const std::uint32_t first = fine_ != nullptr ? fine_->first_node(face) : kNone;
    if (first != kNone) {
      child.given = first + i;
      child.labels = held(child);
    }
    return child;
  }
  /// Child i of a node of level 1 or more.
  [[nodiscard]] WalkNode child(const WalkNode& node, std::uint32_t i) const noexcept {
    WalkNode child;
    child.level = node.level + 1;
    if (node.given != kNone && fine_->nodes[node.given].first_child != kNone) {
      child.given = fine_->nodes[node.given].first_child + i;
      child.labels = held(child);
    } else {
      child.labels = turned(child_labels(node.labels, i, face_point_label(node.labels)), i);
    }
    return child;
  }
  /// Whether labels of all that lies in a node follow from its own.
  [[nodiscard]] bool follows(const WalkNode& node) const noexcept {
    return node.given == kNone || fine_->nodes[node.given].first_child == kNone;
  }

 private:
  [[nodiscard]] static QuadLabels turned(const QuadLabels& from_corner, std::uint32_t by) noexcept {
    QuadLabels labels;
    for (std::uint32_t k = 0; k < 4; ++k) {
      labels[(by + k) % 4] = from_corner[k];
    }
    return labels;
  }
  [[nodiscard]] QuadLabels held(const WalkNode& node) const noexcept {
    QuadLabels labels = fine_->nodes[node.given].labels;
    for (std::uint8_t& label : labels) {
      label = static_cast<std::uint8_t>(std::clamp(levels_ - node.level, 0, int{label}));
    }
    return labels;
  }

  const FineLabels* fine_;
  int levels_;
};

}  // namespace limn
