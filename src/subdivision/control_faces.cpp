// A quad is the root of one patch. A face with another number of sides takes its first step here,
// from rings alone, and each of the quads it leaves is the root of a patch at level 1.
#include "subdivision/control_faces.h"

#include <algorithm>

#include "subdivision/label_counts.h"
#include "subdivision/patch_gather.h"
#include "subdivision/patch_limits.h"

namespace limn {
namespace {

/// A control edge as one of its faces sees it.
struct ControlSide {
  EdgeRun run;          ///< From the face's corner on.
  bool is_own = false;  ///< The face writes the vertices on it.
  bool is_lifted = false;
};

/// Whether the face point makes the midpoint of a side with greatest label 1 move once more.
bool lifts(const RefinementPlan& plan, std::uint32_t corner) {
  if (corner == kNone) {
    return false;
  }
  // A positive face point needs a label beyond 1 at both ends of another side.
  const std::uint32_t f = plan.cage.face_of(corner);
  return plan.greatest[f] > 1 && face_point_label(FaceLabels(plan.cage, plan.labels, f)) > 0;
}

/// The side that leaves a corner; a and b are the labels at its ends. Inlined, since a result of
/// small members that goes through memory is waited for.
[[gnu::always_inline]] inline ControlSide side_at(const RefinementPlan& plan, std::uint32_t corner,
                                                  std::uint8_t a, std::uint8_t b) {
  const FlatTopology& topology = *plan.cage.topology;
  ControlSide side;
  if (a == 0 && b == 0) {
    return side;
  }
  const std::uint32_t twin = plan.cage.twin(corner);
  const auto [first, second] = std::minmax(corner, twin);
  side.run = {plan.numbering->first_on_edge(topology.corner_edges[corner]), 1};
  if (corner != first) {
    side.run = {side.run.first + LabelCounts::table().edge(a, b) - 1, 0u - 1u};
  }
  const bool may_lift = std::max(a, b) == 1 && plan.greatest_of_all > 1;
  const bool by_first = may_lift && lifts(plan, first);
  const bool by_second = may_lift && lifts(plan, second);
  side.is_own = (corner == first) != (by_second && !by_first);
  side.is_lifted = side.is_own && (by_first || by_second);
  return side;
}

void refine_quad(const RefinementPlan& plan, std::uint32_t f, const RefinedArrays& arrays) {
  const Cage& cage = plan.cage;
  const std::uint32_t first = cage.first_corner(f);
  Node node;
  for (std::uint32_t i = 0; i < 4; ++i) {
    node.corners[i] = cage.topology->corner_vertices[first + i];
  }
  node.quad = plan.numbering->first_face(f);
  if (plan.greatest[f] == 0) {
    arrays.quads[node.quad] = node.corners;
    if (arrays.face_levels != nullptr) {
      arrays.face_control_faces[node.quad] = f;
      arrays.face_levels[node.quad] = 0;
    }
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
  Patch patch;
  gather_quad(cage, *plan.rings, f, patch);
  refine_patch(patch, node, f, arrays);
}

/// One side of a split face that is no quad, and the edge from its midpoint to the centre.
struct PolygonSide {
  std::uint8_t label = 0;  ///< Of the midpoint.
  std::uint32_t midpoint = 0;
  EdgeRun first_half;
  EdgeRun second_half;
  EdgeRun inner;  ///< From the midpoint on.
  std::uint32_t inner_count = 0;
  bool is_own = false;
  bool goes_with_first = false;  ///< Who writes the midpoint: the child at the side's first corner,
  bool goes_with_second = false;  ///< at its second, or neither: it rests at level 1.
  bool is_inner_lifted = false;
  bool is_inner_second = false;  ///< The inner edge is the second child's.
};

class PolygonRefinement {
 public:
  PolygonRefinement(const RefinementPlan& plan, std::uint32_t f, const RefinedArrays& arrays)
      : plan_(&plan),
        arrays_(&arrays),
        f_(f),
        first_(plan.cage.first_corner(f)),
        labels_(plan.cage, plan.labels, f),
        centre_label_(face_point_label(labels_)),
        inside_(plan.numbering->first_inside(f)) {}

  void run() {
    const LabelCounts& counts = LabelCounts::table();
    const auto n = static_cast<std::uint32_t>(labels_.size());
    std::uint32_t next_vertex = inside_ + 1;
    for (std::uint32_t i = 0; i < n; ++i) {
      next_vertex += counts.edge(child_labels(labels_, i, centre_label_)[1], centre_label_);
    }
    std::uint32_t next_quad = plan_->numbering->first_face(f_);
    const std::uint32_t last_inner =
        counts.edge(child_labels(labels_, n - 1, centre_label_)[1], centre_label_);
    PolygonSide before = side(n - 1, next_vertex - last_inner);
    std::uint32_t next_inner = inside_ + 1;
    for (std::uint32_t i = 0; i < n; ++i) {
      const PolygonSide here = side(i, next_inner);
      next_inner += here.inner_count;
      const FaceCounts part = write_child(i, before, here, next_vertex, next_quad);
      next_vertex += part.inside;
      next_quad += part.quads;
      before = here;
    }
  }

 private:
  PolygonSide side(std::uint32_t i, std::uint32_t inner_first) const {
    const LabelCounts& counts = LabelCounts::table();
    const auto n = static_cast<std::uint32_t>(labels_.size());
    const std::uint32_t after = i + 1 == n ? 0 : i + 1;
    const ControlSide control = side_at(*plan_, first_ + i, labels_[i], labels_[after]);
    PolygonSide side;
    side.label = edge_point_label(labels_[i], labels_[after]);
    const std::uint32_t half = counts.edge(lowered(labels_[i]), side.label);
    side.midpoint = control.run.at(half);
    side.first_half = control.run;
    side.second_half = control.run.from(half + 1);
    side.inner = {inner_first, 1};
    side.inner_count = counts.edge(side.label, centre_label_);
    side.is_own = control.is_own;
    side.goes_with_first = lowered(labels_[i]) > 0 || control.is_lifted;
    side.goes_with_second = !side.goes_with_first && lowered(labels_[after]) > 0;
    if (std::max(side.label, centre_label_) == 1) {
      const bool by_first = face_point_label(child_labels(labels_, i, centre_label_)) > 0;
      const bool by_second = face_point_label(child_labels(labels_, after, centre_label_)) > 0;
      side.is_inner_lifted = by_first || by_second;
      side.is_inner_second = by_second && !by_first;
    }
    return side;
  }

  /// The quad between sides `before` and `here`.
  FaceCounts write_child(std::uint32_t i, const PolygonSide& before, const PolygonSide& here,
                         std::uint32_t next_vertex, std::uint32_t next_quad) const {
    const std::uint32_t corner = first_ + i;
    const std::uint32_t vertex = plan_->cage.topology->corner_vertices[corner];
    Node node;
    node.level = 1;
    node.labels = child_labels(labels_, i, centre_label_);
    node.corners = {vertex, here.midpoint, inside_, before.midpoint};
    node.sides = {here.first_half, here.inner,
                  EdgeRun{before.inner.at(before.inner_count - 1), 0u - 1u}, before.second_half};
    node.inside = next_vertex;
    node.quad = next_quad;
    node.owned_sides =
        static_cast<std::uint8_t>(bit(0, here.is_own) | bit(1, !here.is_inner_second) |
                                  bit(2, before.is_inner_second) | bit(3, before.is_own));
    node.lifted_sides =
        static_cast<std::uint8_t>(bit(1, here.is_inner_lifted && !here.is_inner_second) |
                                  bit(2, before.is_inner_lifted && before.is_inner_second));

    Patch patch;
    gather_polygon_corner(plan_->cage, *plan_->rings, f_, corner, patch);
    if (plan_->owns(corner)) {
      if (node.labels[0] > 0) {
        node.owned_corners |= bit(0);
      } else {
        put(vertex, patch, {0, 0});
      }
    }
    if (here.is_own) {
      if (here.goes_with_first) {
        node.owned_corners |= bit(1);
      } else if (!here.goes_with_second) {
        put(here.midpoint, patch, {1, 0});
      }
    }
    if (before.is_own && before.goes_with_second) {
      node.owned_corners |= bit(3);
    }
    if (i == 0) {
      if (centre_label_ > 0) {
        node.owned_corners |= bit(2);
      } else {
        put(inside_, patch, {1, 1});
      }
    }
    refine_patch(patch, node, f_, *arrays_);
    return LabelCounts::table().face(node.labels);
  }

  /// A vertex that rests at level 1.
  void put(std::uint32_t vertex, const Patch& patch, const GridPlace& place) const {
    const PatchGrid grid{{patch.grid.data(), 4, 1}, 1, 0, 0, 15, 15};
    arrays_->put(vertex, patch.grid[4 * place.y + place.x + 5], 1);
    if (arrays_->takes_limits()) {
      arrays_->put_limit(vertex, limit_in_patch(patch, grid, place));
    }
  }

  const RefinementPlan* plan_;
  const RefinedArrays* arrays_;
  std::uint32_t f_;
  std::uint32_t first_;
  FaceLabels labels_;
  std::uint8_t centre_label_;
  std::uint32_t inside_;
};

}  // namespace

void place_resting_vertices(Sweep& sweep, const Cage& cage, std::span<const std::uint8_t> labels,
                            std::span<const std::uint8_t> greatest, const RingTables& rings,
                            const RefinedArrays& arrays, LargeArray<std::uint32_t>& owners) {
  owners.resize(cage.vertex_count());
  const FlatTopology& topology = *cage.topology;
  sweep.each(cage.vertex_count(), [&](std::size_t i) {
    const auto v = static_cast<std::uint32_t>(i);
    if (labels[v] > 0) {
      return;
    }
    const std::span<const std::uint32_t> corners = corners_around(cage, v);
    const auto moves = [&](std::uint32_t corner) {
      return greatest[cage.face_of(corner)] > 0 &&
             (labels[topology.corner_vertices[cage.next(corner)]] |
              labels[topology.corner_vertices[cage.previous(corner)]]) != 0;
    };
    const auto mover = std::ranges::find_if(corners, moves);
    if (mover != corners.end()) {
      owners[v] = *mover;
    } else {
      owners[v] = kNone;
      arrays.put(v, cage.point(v), 0);
      if (arrays.takes_limits()) {
        arrays.put_limit(v, limit_in_cage(cage, rings, v));
      }
    }
  });
}

void prefetch_face(const RefinementPlan& plan, std::uint32_t f) noexcept {
  const FlatTopology& topology = *plan.cage.topology;
  if (plan.greatest[f] == 0 || topology.quad_rings.empty()) {
    return;
  }
  const std::uint32_t first = plan.cage.first_corner(f);
  const std::uint32_t n = plan.cage.side_count(f);
  for (std::uint32_t corner = first; corner < first + n; ++corner) {
    __builtin_prefetch(&plan.cage.points[topology.corner_vertices[corner]]);
    plan.numbering->prefetch_edge(topology.corner_edges[corner]);
  }
  for (const std::uint32_t v : topology.quad_rings[f]) {
    __builtin_prefetch(plan.cage.points.data() + (v == kNone ? 0 : v));
  }
}

void refine_face(const RefinementPlan& plan, std::uint32_t f, const RefinedArrays& arrays) {
  if (plan.cage.side_count(f) == 4) {
    refine_quad(plan, f, arrays);
  } else {
    PolygonRefinement(plan, f, arrays).run();
  }
}

}  // namespace limn
