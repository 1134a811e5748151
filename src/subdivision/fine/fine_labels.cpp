// The levels around the demands are looked at with as many rings of faces as suffice, which is two
// unless legalisation has a long way to go.
#include "subdivision/fine/fine_labels.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "limn/contract.h"
#include "limn/subdivision/label_subdivision.h"
#include "subdivision/fine/demand_levels.h"

namespace limn {
namespace {

/// L(v) after the rule for non-quads, where a demand is a painting too.
VertexLabels labels_of_depths(const ControlMesh& mesh, std::span<const std::uint8_t> depths,
                              NonQuadRule rule) {
  VertexLabels labels = vertex_labels(mesh, depths);
  const bool is_painted = std::ranges::any_of(labels, [](std::uint8_t label) { return label > 0; });
  if (!is_painted && rule == NonQuadRule::kUniformFirstStep && !mesh.is_all_quads()) {
    std::ranges::fill(labels, std::uint8_t{1});
    return labels;
  }
  return apply_non_quad_rule(mesh, std::move(labels), rule);
}

std::shared_ptr<const FineLabels> packed(const DemandLevels& levels, std::size_t face_count) {
  const QuadForest& forest = levels.forest();
  const std::uint32_t first = forest.first_node(1);
  auto fine = std::make_shared<FineLabels>();
  fine->first_nodes.assign(face_count, kNone);
  for (const ForestRoot& root : forest.roots()) {
    fine->first_nodes[root.face] = root.first_child - first;
    fine->faces.push_back(root.face);
  }
  fine->nodes.reserve(forest.nodes().size() - first);
  for (int level = 1; level < forest.level_count(); ++level) {
    for (std::uint32_t i = forest.first_node(level); i < forest.first_node(level + 1); ++i) {
      const ForestNode& node = forest.node(i);
      FineLabels::Node& packed = fine->nodes.emplace_back();
      for (std::size_t corner = 0; corner < 4; ++corner) {
        packed.labels[corner] = levels.label(level, node.vertices[corner]);
      }
      if (node.children != kNoChildren) {
        packed.first_child = node.first_child - first;
      }
    }
  }
  return fine;
}

}  // namespace

Result<LabelsWithDemands> legal_labels(const ControlMesh& mesh,
                                       std::span<const std::uint8_t> depths,
                                       const FineDemands& demands,
                                       const SubdivisionSettings& settings, Progress& progress) {
  LabelsWithDemands result;
  if (demands.empty()) {
    result.painted = apply_non_quad_rule(mesh, vertex_labels(mesh, depths), settings.non_quads);
  } else {
    LIMN_EXPECTS(std::ranges::all_of(
        demands.all(), [&](const FineDemand& demand) { return is_demand_on(mesh, demand); }));
    result.painted = labels_of_depths(mesh, depths, settings.non_quads);
    std::optional<DemandLevels> levels;
    int rings = 2;
    do {
      levels.emplace(mesh, demands, result.painted, rings);
      rings *= 2;
    } while (!levels->close());
    for (const std::uint32_t v : levels->needed_vertices()) {
      result.painted[v] = std::max<std::uint8_t>(result.painted[v], 1);
    }
    if (settings.non_quads == NonQuadRule::kWherePainted) {
      result.painted =
          apply_non_quad_rule(mesh, std::move(result.painted), NonQuadRule::kWherePainted);
    }
    result.fine = packed(*levels, mesh.face_count());
  }
  Result<Legalisation> legal = legalise(mesh, result.painted, settings, progress);
  if (!legal) {
    return tl::unexpected(std::move(legal.error()));
  }
  result.legal = *std::move(legal);
  return result;
}

}  // namespace limn
