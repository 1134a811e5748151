// The sides of a control boundary edge a -> b of control face f form a path from a to b along faces
// of f: starting at a, each step follows the one single side that leaves the vertex along a face of
// f. A path counts only if
//   - it reaches b and passes no other control vertex,
//   - every vertex on its way has two faces or more (a point of an edge has both its sub-faces),
//   and
//   - it has as many sides as the labels of a and b make of an edge, or as many as the refined mesh
//   says where labels of finer levels were given.
// The labels are recovered from `vertex_levels`: a vertex that was ever positive has moved in just
// as many steps; one that moved once had label 1 or 0, which only differs for an edge whose two
// ends both moved once: it then has one side or two. Triangles alone are Loop's, or have not been
// refined at all: there an edge has two sides for each level of its face.
#include "subdivision/boundary_paths.h"

#include <algorithm>

#include "subdivision/child_labels.h"
#include "subdivision/surroundings.h"

namespace limn {
namespace {

constexpr auto kNoSide = static_cast<std::size_t>(-1);

std::uint64_t edges_between(std::uint8_t a, std::uint8_t b) {
  if (a == 0 && b == 0) {
    return 1;
  }
  const std::uint8_t middle = edge_point_label(a, b);
  return edges_between(lowered(a), middle) + edges_between(middle, lowered(b));
}

bool is_all_triangles(const RefinedMesh& mesh) {
  return mesh.quads.empty() && mesh.polygon_vertices.size() == 3 * mesh.polygon_count();
}

}  // namespace

void BoundaryPaths::find(const ControlMesh& control, const RefinedMesh& refined,
                         std::span<const Side> singles) {
  is_on_path_.assign(singles.size(), 0);
  faces_around_.clear();
  if (singles.empty() || control.is_closed()) {
    return;
  }
  const Meshes meshes{&control, &refined, singles};
  const FlatTopology& topology = control.topology();
  auto told = refined.boundary_edges.begin();
  for (std::uint32_t e = 0; e < topology.edge_corners.size(); ++e) {
    const auto [corner, twin] = topology.edge_corners[e];
    const bool is_told = told != refined.boundary_edges.end() && told->control_edge == e;
    if (twin == kNone) {
      follow(meshes, {topology.corner_vertices[corner],
                      topology.corner_vertices[next_corner(topology, corner)],
                      topology.corner_faces[corner], is_told ? told->pieces : 0});
    }
    told += is_told ? 1 : 0;
  }
}

/// Marks the sides of the path for a control edge, if it is whole.
void BoundaryPaths::follow(const Meshes& meshes, const ControlEdge& edge) {
  path_.clear();
  const std::uint8_t label_from = meshes.refined->vertex_levels[edge.from];
  const std::uint8_t label_to = meshes.refined->vertex_levels[edge.to];
  std::uint64_t most = edges_between(label_from, label_to);
  std::uint64_t least = std::max(label_from, label_to) <= 1 ? 1 : most;
  if (edge.pieces > 0) {
    most = least = edge.pieces;
  } else if (is_all_triangles(*meshes.refined)) {
    const std::size_t side = side_from(meshes, edge.from, edge.face);
    if (side == kNoSide) {
      return;
    }
    most = least = std::uint64_t{1} << meshes.refined->face_levels[meshes.singles[side].face];
  }
  std::uint32_t at = edge.from;
  do {
    const std::size_t side = side_from(meshes, at, edge.face);
    if (side == kNoSide || path_.size() == most) {
      return;
    }
    // Between two sides of one face a vertex may have no other.
    if (!path_.empty() && meshes.singles[path_.back()].face == meshes.singles[side].face &&
        has_one_face(*meshes.refined, at)) {
      return;
    }
    path_.push_back(side);
    at = meshes.singles[side].to;
    if (at != edge.to && at < meshes.control->vertex_count()) {
      return;
    }
  } while (at != edge.to);
  if (path_.size() >= least) {
    for (const std::size_t side : path_) {
      is_on_path_[side] = 1;
    }
  }
}

/// The only unmarked single side that leaves v along the control face; none if there are more.
std::size_t BoundaryPaths::side_from(const Meshes& meshes, std::uint32_t v,
                                     std::uint32_t control_face) const {
  std::size_t found = kNoSide;
  const auto first = std::ranges::lower_bound(meshes.singles, v, {}, &Side::from);
  for (auto side = static_cast<std::size_t>(first - meshes.singles.begin());
       side < meshes.singles.size() && meshes.singles[side].from == v; ++side) {
    if (meshes.refined->face_control_faces[meshes.singles[side].face] == control_face &&
        is_on_path_[side] == 0) {
      if (found != kNoSide) {
        return kNoSide;
      }
      found = side;
    }
  }
  return found;
}

bool BoundaryPaths::has_one_face(const RefinedMesh& refined, std::uint32_t v) {
  if (faces_around_.empty()) {
    faces_around_.assign(refined.vertex_count(), 0);
    for (const std::array<std::uint32_t, 4>& quad : refined.quads) {
      for (const std::uint32_t corner : quad) {
        ++faces_around_[corner];
      }
    }
    for (const std::uint32_t corner : refined.polygon_vertices) {
      ++faces_around_[corner];
    }
  }
  return faces_around_[v] < 2;
}

}  // namespace limn
