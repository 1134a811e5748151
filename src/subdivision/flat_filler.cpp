// A quad is one root; a face with another number of sides has one at each corner. Those that stay
// are written down as they are.
#include "subdivision/flat_filler.h"

#include <algorithm>
#include <bit>

#include "subdivision/patch_limits.h"

namespace limn {
namespace {

glm::vec3 to_float(const Point& p) {
  return glm::vec3(to_vec3(p));
}

/// What a root's points are relative to: its first corner, as a float.
Point base_of(const Patch& patch) {
  return to_point(glm::dvec3(to_float(patch.grid[5])));
}

std::uint32_t packed(const QuadLabels& labels) {
  return labels[0] | labels[1] << 4U | labels[2] << 8U | labels[3] << 12U;
}

FlatNode flat_node(const RootNode& root, std::uint32_t control_face) {
  const Node& node = root.node;
  FlatNode flat;
  flat.bits = packed(node.labels) | static_cast<std::uint32_t>(node.level) << 16U |
              std::uint32_t{node.owned_corners} << 20U | std::uint32_t{node.owned_sides} << 24U |
              std::uint32_t{node.lifted_sides} << 28U;
  for (std::size_t i = 0; i < 4; ++i) {
    flat.place |= bit(i, node.sides[i].step() != 1);
    flat.sides[i] = node.sides[i].first();
  }
  flat.place |= static_cast<std::uint32_t>(node.level) << 4U;
  flat.control_face = control_face;
  flat.corners = node.corners;
  flat.inside = node.inside;
  flat.quad = node.quad;
  return flat;
}

/// Whether the four corners of a quad are regular amid quads, and nothing around is sharp.
bool is_plainly_regular(const Cage& cage, std::uint32_t f) {
  const std::array<std::uint32_t, 12>& ring = cage.topology->quad_rings[f];
  return cage.creases->edge_sharpness.empty() && cage.creases->vertex_sharpness.empty() &&
         ring[2] != kNone && ring[5] != kNone && ring[8] != kNone && ring[11] != kNone;
}

bool is_resting(const Node& node) {
  return std::ranges::max(node.labels) == 0;
}

}  // namespace

FlatFiller::FlatFiller(const RefinementPlan& from, FlatPlan& plan)
    : from_(&from), plan_(&plan), is_even_(from.cage.creases->method == CreasingMethod::kUniform) {}

PlanSizes FlatFiller::sizes(std::uint32_t f) const {
  PlanSizes sizes{};
  if (!from_->is_resting_polygon(f)) {
    RootCursor roots(*from_, f, RootDetail::kOutline);
    while (const RootNode* root = roots.next()) {
      add_sizes(*root, sizes);
      const bool may_be_special =
          root->polygon_corner != kNone || !is_plainly_regular(from_->cage, f);
      if (!is_resting(root->node) && may_be_special) {
        Patch patch;
        gather_patch(*from_, f, *root, patch);
        add_sizes(PatchShape(patch, root->node, plan_->has_limits), sizes);
      }
    }
  }
  return sizes;
}

void FlatFiller::fill(std::uint32_t f, PlanSizes& next) const {
  if (from_->is_resting_polygon(f)) {
    fill_polygon(f);
  } else {
    RootCursor roots(*from_, f);
    while (const RootNode* root = roots.next()) {
      fill_root(f, *root, next);
    }
  }
}

/// Without what makes its patch special.
void FlatFiller::add_sizes(const RootNode& root, PlanSizes& sizes) const {
  sizes[kPlanPoints] += static_cast<std::uint64_t>(std::popcount(root.resting_corners));
  if (is_resting(root.node)) {
    ++sizes[kPlanQuads];
    return;
  }
  ++sizes[kPlanRoots];
  const NodeCounts& nodes = plan_->subtrees.of(root.node.labels).nodes;
  for (std::size_t kind = 0; kind < kNodeKinds; ++kind) {
    sizes[kPlanNodes + kind] += nodes[kind];
  }
}

void FlatFiller::add_sizes(const PatchShape& shape, PlanSizes& sizes) const {
  if (!shape.is_special()) {
    return;
  }
  ++sizes[kPlanSpecials];
  sizes[kPlanRingPoints] += shape.ring_point_count(plan_->has_limits);
  sizes[kPlanPieces] += shape.piece_count();
  for (std::size_t i = 0; i < 4; ++i) {
    if (has(shape.sharp(), i)) {
      ++sizes[kPlanSharpSides];
      sizes[kPlanShares] += shape.share_count(i, is_even_);
    }
  }
}

void FlatFiller::fill_root(std::uint32_t f, const RootNode& root, PlanSizes& next) const {
  const PlanSizes at = next;
  add_sizes(root, next);
  if (is_resting(root.node)) {
    plan_->resting_quads[at[kPlanQuads]] = {
        root.node.quad, f | static_cast<std::uint32_t>(root.node.level) << 28U, root.node.corners};
    if (root.resting_corners != 0) {
      Patch patch;
      gather_patch(*from_, f, root, patch);
      fill_points(patch, root, at[kPlanPoints]);
    }
    return;
  }
  Patch patch;
  gather_patch(*from_, f, root, patch);
  fill_points(patch, root, at[kPlanPoints]);
  const PatchShape shape(patch, root.node, plan_->has_limits);
  add_sizes(shape, next);
  const auto index = static_cast<std::uint32_t>(at[kPlanRoots]);
  FlatNode& node = plan_->roots[index];
  node = flat_node(root, f);
  node.root = index;
  for (std::size_t kind = 0; kind < kNodeKinds; ++kind) {
    plan_->first_nodes[kind][index] = static_cast<std::uint32_t>(at[kPlanNodes + kind]);
  }
  if (shape.is_special()) {
    node.special = static_cast<std::uint32_t>(at[kPlanSpecials]);
    fill_special(patch, shape, index, at);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    if (has(shape.curves(), i)) {
      mirror_side(i, patch.grid);
    }
  }
  const Point base = base_of(patch);
  const auto points = plan_->points.begin() + static_cast<std::ptrdiff_t>(kRootPoints) * index;
  std::ranges::transform(patch.grid, points, [&](const Point& p) { return to_float(p - base); });
  points[16] = to_float(base);
}

/// Vertices that rest at level 1.
void FlatFiller::fill_points(const Patch& patch, const RootNode& root, std::uint64_t at) const {
  for (std::size_t i = 0; i < 4; ++i) {
    if (!has(root.resting_corners, i)) {
      continue;
    }
    const GridPlace& place = kRootCorners[i];
    FlatPoint& point = plan_->resting_points[at++];
    point = {root.node.corners[i], 1, to_float(patch.grid[4 * place.y + place.x + 5]),
             glm::vec3(0.0f)};
    if (plan_->has_limits) {
      const PatchGrid grid{{patch.grid.data(), 4, 1}, 1, 0, 0, 15, 15};
      const LimitPoint limit = limit_in_patch(patch, grid, place);
      point.normal = glm::vec3(limit.normal);
      if (plan_->has_limit_points) {
        point.position = glm::vec3(limit.position);
      }
    }
  }
}

void FlatFiller::fill_special(const Patch& patch, const PatchShape& shape, std::uint32_t root,
                              const PlanSizes& at) const {
  FlatSpecial& special = plan_->specials[at[kPlanSpecials]];
  special = {};
  special.first_piece = static_cast<std::uint32_t>(at[kPlanPieces]);
  special.bits = shape.bits();
  special.root = root;
  special.first_ring_point = static_cast<std::uint32_t>(at[kPlanRingPoints]);
  fill_rings(patch, shape, base_of(patch), plan_->ring_points.data() + at[kPlanRingPoints]);
  auto share = static_cast<std::uint32_t>(at[kPlanShares]);
  std::uint64_t sharp_side = at[kPlanSharpSides];
  for (std::uint32_t i = 0; i < 4; ++i) {
    if (!has(shape.sharp(), i)) {
      continue;
    }
    special.shares[i] = share | (is_even_ ? kEvenShares : 0);
    special.sharp_levels |= shape.sharp_levels(i) << 8U * i;
    float* out = plan_->shares.data() + share;
    for (std::uint32_t r = 0; r < shape.sharp_levels(i); ++r) {
      out = put_shares(patch.sides[i].sharpness, shape.level() + static_cast<int>(r),
                       std::ptrdiff_t{1} << r, is_even_, out);
    }
    share += shape.share_count(i, is_even_);
    plan_->sharp_sides[sharp_side++] = {static_cast<std::uint32_t>(at[kPlanSpecials]), i};
  }
}

void FlatFiller::fill_rings(const Patch& patch, const PatchShape& shape, const Point& base,
                            glm::vec3* out) const {
  for (const PatchCorner& corner : patch.corners) {
    if (!corner.ring.exists()) {
      continue;
    }
    for (std::uint32_t r = 1; r <= shape.levels(); ++r) {
      const int at = shape.level() + static_cast<int>(r);
      const auto edge = [&](std::uint32_t i) {
        return i == kNone ? glm::vec3(0.0f) : to_float(corner.ring.edge(at, i) - base);
      };
      *out++ = to_float(corner.ring.centre(at) - base);
      *out++ = edge(corner.before);
      *out++ = edge(corner.after);
    }
  }
  for (const PatchCorner& corner : patch.corners) {
    if (plan_->has_limits && corner.ring.exists()) {
      const LimitPoint limit = corner.ring.limit();
      *out++ = glm::vec3(limit.position - to_vec3(base));
      *out++ = glm::vec3(limit.normal);
    }
  }
}

void FlatFiller::fill_polygon(std::uint32_t f) const {
  const Cage& cage = from_->cage;
  const std::uint32_t polygon = from_->numbering->first_face(f);
  const std::uint32_t first = from_->numbering->first_polygon_side(f);
  const std::uint32_t n = cage.side_count(f);
  std::copy_n(cage.topology->corner_vertices.begin() + cage.first_corner(f), n,
              plan_->polygon_vertices.begin() + first);
  plan_->polygon_offsets[polygon + 1] = first + n;
  plan_->polygon_control_faces[polygon] = f;
}

}  // namespace limn
