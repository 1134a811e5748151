// A quad is the root of one patch. A face with another number of sides takes its first step from
// rings alone, and each of the quads that leaves is the root of a patch at level 1.
#include "subdivision/control_faces.h"

#include <algorithm>
#include <atomic>
#include <cstring>

#include "subdivision/fine/fine_trees.h"
#include "subdivision/patch_gather.h"
#include "subdivision/patch_limits.h"
#include "subdivision/root_nodes.h"

namespace limn {
namespace {

void refine_quad(const RefinementPlan& plan, std::uint32_t f, Patch& patch,
                 const RefinedArrays& arrays) {
  if (plan.greatest[f] == 0) {
    const std::uint32_t quad = plan.numbering->first_face(f);
    const std::uint32_t first = plan.cage.first_corner(f);
    std::memcpy(&arrays.quads[quad], &plan.cage.topology->corner_vertices[first],
                sizeof arrays.quads[quad]);
    if (arrays.face_levels != nullptr) {
      arrays.face_control_faces[quad] = f;
      arrays.face_levels[quad] = 0;
    }
    return;
  }
  Node node;
  set_quad_root(plan, f, node);
  gather_quad(plan.cage, *plan.rings, f, patch);
  refine_patch(patch, node, f, arrays);
}

/// Corners of a root that never move again.
void put_resting_corners(const RootNode& root, const Patch& patch, const RefinedArrays& arrays) {
  for (std::size_t i = 0; i < 4; ++i) {
    if (has(root.resting_corners, i)) {
      const GridPlace& place = kRootCorners[i];
      const PatchGrid grid{{patch.grid.data(), 4, 1}, 1, 0, 0, 15, 15};
      arrays.put(root.node.corners[i], patch.grid[4 * place.y + place.x + 5], 1);
      if (arrays.takes_limits()) {
        arrays.put_limit(root.node.corners[i], limit_in_patch(patch, grid, place));
      }
    }
  }
}

void refine_polygon(const RefinementPlan& plan, std::uint32_t f, Patch& patch,
                    const RefinedArrays& arrays) {
  RootCursor roots(plan, f);
  while (const RootNode* root = roots.next()) {
    gather_patch(plan, f, *root, patch);
    put_resting_corners(*root, patch, arrays);
    refine_patch(patch, root->node, f, arrays);
  }
}

/// A face moves its corners of label 0 where the label before or after them is positive.
void own_resting_corners(const RefinementPlan& plan, std::size_t f,
                         LargeArray<std::uint32_t>& owners) {
  const FaceLabels labels(plan.cage, plan.labels, f);
  const std::uint32_t first = plan.cage.first_corner(f);
  const auto n = static_cast<std::uint32_t>(labels.size());
  std::uint8_t before = labels[n - 1];
  std::uint8_t here = labels[0];
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint8_t after = labels[i + 1 == n ? 0 : i + 1];
    if (here == 0 && (before | after) != 0) {
      std::atomic_ref owner(owners[plan.cage.topology->corner_vertices[first + i]]);
      std::uint32_t lowest = owner.load(std::memory_order_relaxed);
      while (first + i < lowest &&
             !owner.compare_exchange_weak(lowest, first + i, std::memory_order_relaxed)) {
      }
    }
    before = here;
    here = after;
  }
}

}  // namespace

void place_resting_vertices(Sweep& sweep, const RefinementPlan& plan, const RefinedArrays& arrays,
                            LargeArray<std::uint32_t>& owners) {
  const Cage& cage = plan.cage;
  owners.clear();
  owners.resize(cage.vertex_count(), kNone);
  sweep.each(cage.face_count(), [&](std::size_t f) {
    if (plan.greatest[f] > 0) {
      own_resting_corners(plan, f, owners);
    }
  });
  sweep.each(cage.vertex_count(), [&](std::size_t i) {
    const auto v = static_cast<std::uint32_t>(i);
    if (plan.labels[v] > 0 || owners[v] != kNone) {
      return;
    }
    arrays.put(v, cage.point(v), 0);
    if (arrays.takes_limits()) {
      arrays.put_limit(v, limit_in_cage(cage, *plan.rings, v));
    }
  });
}

void prefetch_face(const RefinementPlan& plan, std::uint32_t f) noexcept {
  if (plan.greatest[f] == 0) {
    return;
  }
  const FlatTopology& topology = *plan.cage.topology;
  const std::uint32_t first = plan.cage.first_corner(f);
  __builtin_prefetch(&topology.quad_rings[f]);
  __builtin_prefetch(&topology.corner_vertices[first]);
  __builtin_prefetch(&topology.corner_edges[first]);
  __builtin_prefetch(&topology.corner_twins[first]);
  __builtin_prefetch(&topology.corner_ranks[first]);
}

void prefetch_around_face(const RefinementPlan& plan, std::uint32_t f) noexcept {
  if (plan.greatest[f] == 0) {
    return;
  }
  const FlatTopology& topology = *plan.cage.topology;
  const std::uint32_t first = plan.cage.first_corner(f);
  const std::uint32_t n = plan.cage.side_count(f);
  for (std::uint32_t corner = first; corner < first + n; ++corner) {
    __builtin_prefetch(&plan.cage.positions[topology.corner_vertices[corner]]);
    plan.numbering->prefetch_edge(topology.corner_edges[corner]);
  }
  for (const std::uint32_t v : topology.quad_rings[f]) {
    __builtin_prefetch(plan.cage.positions.data() + (v == kNone ? 0 : v));
  }
}

void refine_face(const RefinementPlan& plan, std::uint32_t f, Patch& patch,
                 const RefinedArrays& arrays) {
  if (plan.fine != nullptr && plan.fine->has(f)) {
    plan.fine->write_face(plan, f, patch, arrays);
  } else if (plan.cage.side_count(f) == 4) {
    refine_quad(plan, f, patch, arrays);
  } else {
    refine_polygon(plan, f, patch, arrays);
  }
}

}  // namespace limn
