// What a quad is to its edges: their runs of numbers, and which of them it writes. A face with
// another number of sides is numbered like a split node: the edges inside it first, from the middle
// of each side to the centre, then what lies inside the quads at its corners, one after the other.
#include "subdivision/root_nodes.h"

#include <algorithm>

#include "subdivision/label_counts.h"
#include "subdivision/patch_gather.h"

namespace limn {
namespace {

class RootLister {
 public:
  RootLister(const RefinementPlan& plan, std::uint32_t f)
      : plan_(&plan),
        f_(f),
        first_(plan.cage.first_corner(f)),
        labels_(plan.cage, plan.labels, f) {}

  [[nodiscard]] RootNode quad() const {
    const FlatTopology& topology = *plan_->cage.topology;
    RootNode root;
    Node& node = root.node;
    for (std::uint32_t i = 0; i < 4; ++i) {
      node.corners[i] = topology.corner_vertices[first_ + i];
      node.labels[i] = labels_[i];
    }
    node.quad = plan_->numbering->first_face(f_);
    if (plan_->greatest[f_] == 0) {
      return root;
    }
    node.inside = plan_->numbering->first_inside(f_);
    for (std::uint32_t i = 0; i < 4; ++i) {
      const Side side = control_side(i);
      node.sides[i] = side.run;
      node.owned_sides |= bit(i, side.is_own);
      node.lifted_sides |= bit(i, side.is_lifted);
      node.owned_corners |= bit(i, plan_->vertex_owners[node.corners[i]] == first_ + i);
    }
    return root;
  }

  void polygon(std::vector<RootNode>& roots) const {
    const LabelCounts& counts = LabelCounts::table();
    const auto n = static_cast<std::uint32_t>(labels_.size());
    const std::uint8_t centre_label = face_point_label(labels_);
    const std::uint32_t centre = plan_->numbering->first_inside(f_);
    roots.resize(n);
    std::uint32_t next_vertex = centre + 1;
    for (std::uint32_t i = 0; i < n; ++i) {
      roots[i].polygon_corner = first_ + i;
      roots[i].node.level = 1;
      roots[i].node.labels = child_labels(labels_, i, centre_label);
      roots[i].node.corners[0] = plan_->cage.topology->corner_vertices[first_ + i];
      roots[i].node.corners[2] = centre;
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      next_vertex += join(i, roots[i], roots[i + 1 == n ? 0 : i + 1], next_vertex);
    }
    std::uint32_t next_quad = plan_->numbering->first_face(f_);
    for (std::uint32_t i = 0; i < n; ++i) {
      Node& node = roots[i].node;
      node.inside = next_vertex;
      node.quad = next_quad;
      const FaceCounts& part = counts.face(node.labels);
      next_vertex += part.inside;
      next_quad += part.quads;
      if (plan_->vertex_owners[node.corners[0]] == first_ + i) {
        give_corner(roots[i], 0, node.labels[0] > 0);
      }
    }
    give_corner(roots[0], 2, centre_label > 0);
  }

 private:
  /// A control edge as the face sees it.
  struct Side {
    EdgeRun run;          ///< From the face's corner on.
    bool is_own = false;  ///< The face writes the vertices on it.
    bool is_lifted = false;
  };

  static void give_corner(RootNode& root, std::size_t corner, bool goes_on) {
    (goes_on ? root.node.owned_corners : root.resting_corners) |= bit(corner);
  }

  /// Whether the face point of a corner's face makes the midpoint of a side with greatest label 1
  /// move once more: this needs a label beyond 1 at both ends of another side.
  [[nodiscard]] bool has_moving_centre(std::uint32_t corner) const {
    if (corner == kNone) {
      return false;
    }
    const std::uint32_t f = plan_->cage.face_of(corner);
    return plan_->greatest[f] > 1 &&
           face_point_label(FaceLabels(plan_->cage, plan_->labels, f)) > 0;
  }

  [[nodiscard]] Side control_side(std::uint32_t i) const {
    const FlatTopology& topology = *plan_->cage.topology;
    const std::uint8_t a = labels_[i];
    const std::uint8_t b = labels_[i + 1 == labels_.size() ? 0 : i + 1];
    Side side;
    if (a == 0 && b == 0) {
      return side;
    }
    const std::uint32_t corner = first_ + i;
    const std::uint32_t edge = topology.corner_edges[corner];
    const auto [first, second] = topology.edge_corners[edge];
    const std::uint32_t start = plan_->numbering->first_on_edge(edge);
    side.run = corner == first ? EdgeRun{start, 1}
                               : EdgeRun{start + LabelCounts::table().edge(a, b) - 1, 0u - 1u};
    const bool may_lift = std::max(a, b) == 1 && plan_->greatest_of_all > 1;
    const bool by_first = may_lift && has_moving_centre(first);
    const bool by_second = may_lift && has_moving_centre(second);
    side.is_own = (corner == first) != (by_second && !by_first);
    side.is_lifted = side.is_own && (by_first || by_second);
    return side;
  }

  /// Side i of a polygon and the edge from its midpoint to the centre, which the roots at its ends
  /// have in common. Returns how many vertices that edge has inside.
  std::uint32_t join(std::uint32_t i, RootNode& here, RootNode& after,
                     std::uint32_t first_inner) const {
    const LabelCounts& counts = LabelCounts::table();
    const Side side = control_side(i);
    const std::uint8_t middle_label = here.node.labels[1];
    const std::uint8_t centre_label = here.node.labels[2];
    const std::uint32_t half = counts.edge(here.node.labels[0], middle_label);
    const std::uint32_t midpoint = side.run.at(half);
    here.node.corners[1] = midpoint;
    here.node.sides[0] = side.run;
    here.node.owned_sides |= bit(0, side.is_own);
    after.node.corners[3] = midpoint;
    after.node.sides[3] = side.run.from(half + 1);
    after.node.owned_sides |= bit(3, side.is_own);
    if (side.is_own) {
      const bool goes_on = here.node.labels[0] > 0 || side.is_lifted;
      if (!goes_on && after.node.labels[0] > 0) {
        give_corner(after, 3, true);
      } else {
        give_corner(here, 1, goes_on);
      }
    }

    const std::uint32_t inner = counts.edge(middle_label, centre_label);
    here.node.sides[1] = {first_inner, 1};
    after.node.sides[2] = {first_inner + inner - 1, 0u - 1u};
    const bool may_lift = std::max(middle_label, centre_label) == 1;
    const bool by_first = may_lift && face_point_label(here.node.labels) > 0;
    const bool by_second = may_lift && face_point_label(after.node.labels) > 0;
    if (by_second && !by_first) {
      after.node.owned_sides |= bit(2);
      after.node.lifted_sides |= bit(2);
    } else {
      here.node.owned_sides |= bit(1);
      here.node.lifted_sides |= bit(1, by_first);
    }
    return inner;
  }

  const RefinementPlan* plan_;
  std::uint32_t f_;
  std::uint32_t first_;
  FaceLabels labels_;
};

}  // namespace

void list_roots(const RefinementPlan& plan, std::uint32_t f, std::vector<RootNode>& roots) {
  roots.clear();
  const RootLister lister(plan, f);
  if (plan.cage.side_count(f) == 4) {
    roots.push_back(lister.quad());
  } else {
    lister.polygon(roots);
  }
}

void outline_roots(const RefinementPlan& plan, std::uint32_t f, std::vector<RootNode>& roots) {
  if (plan.cage.side_count(f) != 4) {
    list_roots(plan, f, roots);
    return;
  }
  const FaceLabels labels(plan.cage, plan.labels, f);
  roots.assign(1, RootNode{});
  for (std::size_t i = 0; i < 4; ++i) {
    roots.front().node.labels[i] = labels[i];
  }
}

Patch gather_patch(const RefinementPlan& plan, std::uint32_t f, const RootNode& root) {
  Patch patch;
  if (root.polygon_corner == kNone) {
    gather_quad(plan.cage, *plan.rings, f, patch);
  } else {
    gather_polygon_corner(plan.cage, *plan.rings, f, root.polygon_corner, patch);
  }
  return patch;
}

}  // namespace limn
