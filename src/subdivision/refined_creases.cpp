// An edge is subdivided by the labels of its ends alone, so the refined edges on a control edge
// are found without a look at any face, unless labels of finer levels are given there.
#include "subdivision/refined_creases.h"

#include "subdivision/fine/fine_trees.h"
#include "subdivision/label_counts.h"
#include "subdivision/sharpness.h"

namespace limn {
namespace {

/// A piece of a control edge: an edge of the level-k mesh.
struct Piece {
  int level = 0;
  std::ptrdiff_t index = 0;  ///< Among the control edge's pieces of that level.
  std::array<std::uint32_t, 2> vertices{};
  std::array<std::uint8_t, 2> labels{};
  EdgeRun run;
};

void list_pieces(const SideSharpness& sharpness, const Piece& piece,
                 std::vector<RefinedCrease>& creases) {
  const float here = sharpness.at(piece.level, piece.index);
  if (!is_sharp(here)) {
    return;  // Nor are its parts.
  }
  const auto [a, b] = piece.labels;
  if (a == 0 && b == 0) {
    creases.push_back({piece.vertices, here});
    return;
  }
  const std::uint8_t label = edge_point_label(a, b);
  const std::uint32_t before = LabelCounts::table().edge(lowered(a), label);
  const std::uint32_t middle = piece.run.at(before);
  list_pieces(sharpness,
              {piece.level + 1,
               2 * piece.index,
               {piece.vertices[0], middle},
               {lowered(a), label},
               piece.run},
              creases);
  list_pieces(sharpness,
              {piece.level + 1,
               2 * piece.index + 1,
               {middle, piece.vertices[1]},
               {label, lowered(b)},
               piece.run.from(before + 1)},
              creases);
}

}  // namespace

void list_creases(const RefinementPlan& plan, RefinedMesh& result) {
  result.creases.clear();
  result.corners.clear();
  const Cage& cage = plan.cage;
  const FlatTopology& topology = *cage.topology;
  std::vector<EdgePiece> pieces;
  for (std::uint32_t e = 0; e < cage.creases->edge_sharpness.size(); ++e) {
    const auto [corner, other] = topology.edge_corners[e];
    if (other == kNone || !is_sharp(cage.edge_sharpness(e))) {
      continue;
    }
    const std::array<std::uint32_t, 2> ends = topology.edge_vertices[e];
    const std::uint32_t face = cage.face_of(corner);
    if (plan.fine != nullptr && plan.fine->has(face) &&
        (plan.labels[ends[0]] > 0 || plan.labels[ends[1]] > 0)) {
      const SideSharpness sharpness = plan.rings->sharpness(cage, corner);
      plan.fine->list_pieces(face, corner - cage.first_corner(face), pieces);
      for (const EdgePiece& piece : pieces) {
        if (const float left = sharpness.at(piece.level, piece.index); is_sharp(left)) {
          result.creases.push_back({piece.vertices, left});
        }
      }
      continue;
    }
    list_pieces(plan.rings->sharpness(cage, corner),
                {0,
                 0,
                 ends,
                 {plan.labels[ends[0]], plan.labels[ends[1]]},
                 {plan.numbering->first_on_edge(e), 1}},
                result.creases);
  }
  for (std::uint32_t v = 0; v < cage.creases->vertex_sharpness.size(); ++v) {
    const SideSharpness sharpness(cage.vertex_sharpness(v));
    if (const float left = sharpness.at(result.vertex_levels[v], 0); is_sharp(left)) {
      result.corners.push_back({v, left});
    }
  }
}

void list_boundary_edges(const RefinementPlan& plan, RefinedMesh& result) {
  result.boundary_edges.clear();
  if (plan.fine == nullptr) {
    return;
  }
  const Cage& cage = plan.cage;
  const FlatTopology& topology = *cage.topology;
  std::vector<EdgePiece> pieces;
  for (std::uint32_t e = 0; e < topology.edge_corners.size(); ++e) {
    const auto [corner, other] = topology.edge_corners[e];
    const std::uint32_t face = cage.face_of(corner);
    if (other == kNone && plan.fine->has(face)) {
      plan.fine->list_pieces(face, corner - cage.first_corner(face), pieces);
      result.boundary_edges.push_back({e, static_cast<std::uint32_t>(pieces.size())});
    }
  }
}

}  // namespace limn
