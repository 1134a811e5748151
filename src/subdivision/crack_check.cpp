// Edges with one face are boundary edges. Those of a control boundary edge a -> b of control face f
// form a path from a to b along faces of f: starting at a, each step follows the one boundary edge
// that leaves the vertex along a face of f. A path counts only if
//   - it reaches b and passes no other control vertex,
//   - every vertex on its way has two faces or more (a point of an edge has both its sub-faces),
//   and
//   - it has as many edges as the labels of a and b make of an edge.
// The labels are recovered from `vertex_levels`: a vertex that was ever positive has moved in just
// as many steps; one that moved once had label 1 or 0, which only differs for an edge whose two
// ends both moved once: it then has one edge or two. Whatever lies on no such path is a crack.
#include "limn/subdivision/crack_check.h"

#include <algorithm>

#include "subdivision/child_labels.h"
#include "subdivision/face_edges.h"
#include "subdivision/surroundings.h"

namespace limn {
namespace {

struct BoundaryEdge {
  std::uint32_t from;
  std::uint32_t to;
  std::uint32_t face;
  bool is_on_control_boundary = false;
};

std::uint64_t edges_between(std::uint8_t a, std::uint8_t b) {
  if (a == 0 && b == 0) {
    return 1;
  }
  const std::uint8_t middle = edge_point_label(a, b);
  return edges_between(lowered(a), middle) + edges_between(middle, lowered(b));
}

class BoundaryPaths {
 public:
  BoundaryPaths(const RefinedMesh& refined, std::vector<BoundaryEdge>& edges)
      : refined_(&refined), edges_(&edges), faces_around_(refined.vertex_count(), 0) {
    std::ranges::sort(edges, {}, &BoundaryEdge::from);
    for (std::size_t f = 0; f < refined.face_count(); ++f) {
      for (const std::uint32_t v : refined.face(f)) {
        ++faces_around_[v];
      }
    }
  }

  /// Marks the edges of the path for the boundary edge from a to b of a control face, if it is
  /// whole.
  void follow(std::uint32_t a, std::uint32_t b, std::uint32_t control_face,
              std::size_t control_vertices) {
    path_.clear();
    const std::uint8_t label_a = refined_->vertex_levels[a];
    const std::uint8_t label_b = refined_->vertex_levels[b];
    const std::uint64_t most = edges_between(label_a, label_b);
    const std::uint64_t least = std::max(label_a, label_b) <= 1 ? 1 : most;
    std::uint32_t at = a;
    do {
      BoundaryEdge* edge = edge_from(at, control_face);
      if (edge == nullptr || path_.size() == most) {
        return;
      }
      path_.push_back(edge);
      at = edge->to;
      if (at != b && (at < control_vertices || faces_around_[at] < 2)) {
        return;
      }
    } while (at != b);
    if (path_.size() >= least) {
      for (BoundaryEdge* edge : path_) {
        edge->is_on_control_boundary = true;
      }
    }
  }

 private:
  /// The only unmarked boundary edge that leaves v along the control face; null if there is none
  /// or more than one.
  BoundaryEdge* edge_from(std::uint32_t v, std::uint32_t control_face) {
    BoundaryEdge* found = nullptr;
    auto edge = std::ranges::lower_bound(*edges_, v, {}, &BoundaryEdge::from);
    for (; edge != edges_->end() && edge->from == v; ++edge) {
      if (refined_->face_control_faces[edge->face] == control_face &&
          !edge->is_on_control_boundary) {
        if (found != nullptr) {
          return nullptr;
        }
        found = &*edge;
      }
    }
    return found;
  }

  const RefinedMesh* refined_;
  std::vector<BoundaryEdge>* edges_;
  std::vector<std::uint32_t> faces_around_;
  std::vector<BoundaryEdge*> path_;
};

}  // namespace

CrackCheck check_cracks(const ControlMesh& control, const RefinedMesh& refined) {
  CrackCheck check;
  std::vector<bool> is_covered(control.face_count(), false);
  for (const std::uint32_t f : refined.face_control_faces) {
    is_covered[f] = true;
  }
  check.missing_control_faces = static_cast<std::size_t>(std::ranges::count(is_covered, false));

  std::vector<BoundaryEdge> boundary;
  for_each_edge(gather_face_sides(refined),
                [&](std::uint32_t low, std::span<const FaceSide> sides) {
                  if (sides.size() == 1) {
                    const FaceSide& side = sides.front();
                    boundary.push_back(side.is_from_low ? BoundaryEdge{low, side.high, side.face}
                                                        : BoundaryEdge{side.high, low, side.face});
                  } else if (sides.size() > 2 || sides[0].is_from_low == sides[1].is_from_low) {
                    ++check.nonmanifold_edges;
                  }
                });
  check.boundary_edges = boundary.size();
  if (boundary.empty()) {
    return check;
  }

  BoundaryPaths paths(refined, boundary);
  const FlatTopology& topology = control.topology();
  for (std::size_t e = 0; e < control.edge_count(); ++e) {
    if (topology.edge_corners[e][1] == kNone) {
      const std::uint32_t corner = topology.edge_corners[e][0];
      paths.follow(topology.corner_vertices[corner],
                   topology.corner_vertices[next_corner(topology, corner)],
                   topology.corner_faces[corner], control.vertex_count());
    }
  }
  for (const BoundaryEdge& edge : boundary) {
    if (edge.is_on_control_boundary) {
      ++check.control_boundary_edges;
    } else {
      check.crack_faces.push_back(edge.face);
    }
  }
  std::ranges::sort(check.crack_faces);
  std::vector<std::uint32_t>& faces = check.crack_faces;
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return check;
}

}  // namespace limn
