// What a quad is to its edges: their runs of numbers, and which of them it writes. A face with
// another number of sides is numbered like a split node: the edges inside it first, from the middle
// of each side to the centre, then what lies inside the quads at its corners, one after the other.
#include "subdivision/root_nodes.h"

#include <algorithm>

#include "subdivision/label_counts.h"
#include "subdivision/patch_gather.h"

namespace limn {
namespace {

/// A control edge as one of its faces sees it.
struct ControlSide {
  EdgeRun run;          ///< From the face's corner on.
  bool is_own = false;  ///< The face writes the vertices on it.
  bool is_lifted = false;
};

/// Whether the face point of a corner's face makes the midpoint of a side with greatest label 1
/// move once more: this needs a label beyond 1 at both ends of another side.
bool has_moving_centre(const RefinementPlan& plan, std::uint32_t corner) {
  if (corner == kNone) {
    return false;
  }
  const std::uint32_t f = plan.cage.face_of(corner);
  return plan.greatest[f] > 1 && face_point_label(FaceLabels(plan.cage, plan.labels, f)) > 0;
}

/// The side that leaves a corner; a and b are the labels at its ends.
[[gnu::always_inline]] inline ControlSide side_at(const RefinementPlan& plan, std::uint32_t corner,
                                                  std::uint8_t a, std::uint8_t b) {
  ControlSide side;
  if (a == 0 && b == 0) {
    return side;
  }
  const std::uint32_t twin = plan.cage.twin(corner);
  const auto [first, second] = std::minmax(corner, twin);
  side.run = {plan.numbering->first_on_edge(plan.cage.topology->corner_edges[corner]), 1};
  if (corner != first) {
    side.run = side.run.reversed(plan.counts->edge(a, b));
  }
  const bool may_lift = std::max(a, b) == 1 && plan.greatest_of_all > 1;
  const bool by_first = may_lift && has_moving_centre(plan, first);
  const bool by_second = may_lift && has_moving_centre(plan, second);
  side.is_own = (corner == first) != (by_second && !by_first);
  side.is_lifted = side.is_own && (by_first || by_second);
  return side;
}

void give_corner(RootNode& root, std::size_t corner, bool goes_on) {
  (goes_on ? root.node.owned_corners : root.resting_corners) |= bit(corner);
}

}  // namespace

bool writes_side(const RefinementPlan& plan, std::uint32_t corner) {
  const std::vector<std::uint32_t>& vertices = plan.cage.topology->corner_vertices;
  return side_at(plan, corner, plan.labels[vertices[corner]],
                 plan.labels[vertices[plan.cage.next(corner)]])
      .is_own;
}

void set_quad_root(const RefinementPlan& plan, std::uint32_t f, Node& node) {
  const std::uint32_t first = plan.cage.first_corner(f);
  std::copy_n(plan.cage.topology->corner_vertices.begin() + first, 4, node.corners.begin());
  node.quad = plan.numbering->first_face(f);
  if (plan.greatest[f] == 0) {
    return;
  }
  node.inside = plan.numbering->first_inside(f);
  for (std::uint32_t i = 0; i < 4; ++i) {
    node.labels[i] = plan.labels[node.corners[i]];
  }
  for (std::uint32_t i = 0; i < 4; ++i) {
    const ControlSide side = side_at(plan, first + i, node.labels[i], node.labels[(i + 1) % 4]);
    node.sides[i] = side.run;
    node.owned_sides |= bit(i, side.is_own);
    node.lifted_sides |= bit(i, side.is_lifted);
    node.owned_corners |= bit(i, plan.owns(first + i));
  }
}

RootCursor::RootCursor(const RefinementPlan& plan, std::uint32_t f, RootDetail detail)
    : plan_(&plan),
      f_(f),
      first_(plan.cage.first_corner(f)),
      labels_(plan.cage, plan.labels, f),
      detail_(detail),
      next_quad_(plan.numbering->first_face(f)) {
  if (labels_.size() == 4) {
    return;
  }
  const auto n = static_cast<std::uint32_t>(labels_.size());
  centre_ = plan.numbering->first_inside(f);
  centre_label_ = face_point_label(labels_);
  next_inner_ = centre_ + 1;
  next_vertex_ = next_inner_;
  std::uint32_t last_inner = next_vertex_;
  for (std::uint32_t i = 0; i < n; ++i) {
    last_inner = next_vertex_;
    next_vertex_ += plan.counts->edge(child_labels(labels_, i, centre_label_)[1], centre_label_);
  }
  RootNode before = start(n - 1);
  following_ = start(0);
  join(n - 1, before, following_, last_inner);
}

const RootNode* RootCursor::next() {
  const auto n = static_cast<std::uint32_t>(labels_.size());
  const std::uint32_t i = next_++;
  if (n == 4) {
    if (i > 0) {
      return nullptr;
    }
    if (detail_ == RootDetail::kAll) {
      set_quad_root(*plan_, f_, root_.node);
    } else {
      for (std::uint32_t corner = 0; corner < 4; ++corner) {
        root_.node.labels[corner] = labels_[corner];
      }
    }
    return &root_;
  }
  if (i == n) {
    return nullptr;
  }
  root_ = following_;
  following_ = start(i + 1 == n ? 0 : i + 1);
  next_inner_ += join(i, root_, following_, next_inner_);
  Node& node = root_.node;
  node.inside = next_vertex_;
  node.quad = next_quad_;
  const FaceCounts& part = plan_->counts->face(node.labels);
  next_vertex_ += part.inside;
  next_quad_ += part.quads;
  if (plan_->owns(first_ + i)) {
    give_corner(root_, 0, node.labels[0] > 0);
  }
  if (i == 0) {
    give_corner(root_, 2, centre_label_ > 0);
  }
  return &root_;
}

/// The root at corner i without what its neighbours have a part in.
RootNode RootCursor::start(std::uint32_t i) const {
  RootNode root;
  root.polygon_corner = first_ + i;
  root.node.level = 1;
  root.node.labels = child_labels(labels_, i, centre_label_);
  root.node.corners[0] = plan_->cage.topology->corner_vertices[first_ + i];
  root.node.corners[2] = centre_;
  return root;
}

/// Side i of a polygon and the edge from its midpoint to the centre, which the roots at its ends
/// have in common. Returns how many vertices that edge has inside.
std::uint32_t RootCursor::join(std::uint32_t i, RootNode& here, RootNode& after,
                               std::uint32_t first_inner) const {
  const LabelCounts& counts = *plan_->counts;
  const ControlSide side =
      side_at(*plan_, first_ + i, labels_[i], labels_[i + 1 == labels_.size() ? 0 : i + 1]);
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
  after.node.sides[2] = here.node.sides[1].reversed(inner);
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

void gather_patch(const RefinementPlan& plan, std::uint32_t f, const RootNode& root, Patch& patch) {
  if (root.polygon_corner == kNone) {
    gather_quad(plan.cage, *plan.rings, f, patch);
  } else {
    gather_polygon_corner(plan.cage, *plan.rings, f, root.polygon_corner, patch);
  }
}

}  // namespace limn
