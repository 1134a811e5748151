#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "limn/mesh/control_mesh.h"
#include "limn/subdivision/fine_demands.h"
#include "limn/subdivision/labels.h"
#include "subdivision/fine/quad_forest.h"

// The levels of the uniform meshes around demands, and their labels. Internal to this folder.
namespace limn {

/// Parts of the levels: at each the faces that have a demand on them or within them, with so many
/// rings of faces around.
class DemandLevels {
 public:
  /// `labels` are the control mesh's, after the rule for non-quads.
  DemandLevels(const ControlMesh& mesh, const FineDemands& demands, const VertexLabels& labels,
               int rings);

  /// Labels of all levels but the control mesh's, from the deepest up: legal, and such that each
  /// level has what the next one needs. False if faces that are not here may be concerned.
  [[nodiscard]] bool close();
  /// Control vertices that must not be 0 for the sake of level 1, in no order.
  [[nodiscard]] std::vector<std::uint32_t> needed_vertices() const;

  [[nodiscard]] const QuadForest& forest() const noexcept { return forest_; }
  [[nodiscard]] std::uint8_t label(int level, std::uint32_t vertex) const noexcept {
    return labels_[static_cast<std::size_t>(level)][vertex];
  }

 private:
  void apply(std::span<const FineDemand> demands, int level);
  void descend(std::span<const FineDemand> demands, int level, int rings);
  void need(int level);
  [[nodiscard]] bool is_settled(int level) const;

  QuadForest forest_;
  std::vector<std::vector<std::uint8_t>> labels_;     ///< By level and vertex.
  std::vector<std::vector<std::uint8_t>> inherited_;  ///< What they would be without demands.
  std::vector<std::uint32_t> demand_nodes_;  ///< Of each demand, at the deepest level that has it.
};

}  // namespace limn
