#pragma once

#include <cstdint>
#include <vector>

#include "limn/subdivision/fine_labels.h"
#include "subdivision/label_counts.h"

namespace limn {

/// The labels of faces of finer levels, around all places where they are not those that follow from
/// the level before. Internal to the library.
class FineLabels {
 public:
  /// A face of some level.
  struct Node {
    QuadLabels labels{};
    std::uint32_t first_child = kNone;  ///< Of four, child i at corner i; kNone: labels of what
                                        ///< lies in it follow from its own.
  };

  /// The first of its nodes of level 1, one for each corner; kNone where labels of all levels
  /// follow from those of the control mesh, in the face and around it.
  [[nodiscard]] std::uint32_t first_node(std::uint32_t control_face) const noexcept {
    return first_nodes[control_face];
  }

  std::vector<std::uint32_t> first_nodes;
  std::vector<Node> nodes;
  std::vector<std::uint32_t> faces;  ///< Those control faces that have nodes, ascending.
};

}  // namespace limn
