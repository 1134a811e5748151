// A quadtree walk. A node whose labels are all equal becomes a grid that is refined as a whole;
// any other splits, or becomes a Y-element, and its children go on with the 4 x 4 points around
// them out of the node's 5 x 5. Children keep their parent's orientation: child i has the parent's
// corner i as its own corner i.
#include "subdivision/patch.h"

#include <algorithm>
#include <cstring>

#include "limn/contract.h"
#include "subdivision/parallel_ranges.h"
#include "subdivision/patch_around.h"
#include "subdivision/patch_levels.h"
#include "subdivision/patch_limits.h"
#include "subdivision/tensor_kernels.h"

namespace limn {
namespace {

/// Uniform nodes of up to so many levels are refined as one grid, whose last stored level fits the
/// second-level cache.
constexpr int kGridLevels = 6;
constexpr std::size_t kGridSide = (std::size_t{1} << kGridLevels) + 1;          ///< Vertices.
constexpr std::size_t kStoredSide = (std::size_t{1} << (kGridLevels - 1)) + 3;  ///< With a ring.
static_assert(kStoredSide <= kLongestLimitRow);
/// Children of nodes with so many quads are worth a task of their own.
constexpr std::uint32_t kParallelQuads = std::uint32_t{1} << 17;

PatchGrid around(const Node& node, const GridView& grid) {
  return {grid, node.level, node.column, node.row, node.patch_corners, node.patch_sides};
}

class PatchWriter {
 public:
  PatchWriter(const Patch& patch, std::uint32_t control_face, const RefinedArrays& arrays)
      : patch_(&patch), control_face_(control_face), arrays_(&arrays) {}

  void write(const Node& node, const GridView& grid) const;

 private:
  void put(std::uint32_t vertex, const Around& next, const GridPlace& place) const;
  void write_uniform(const Node& node, const GridView& grid) const;
  void write_last(const Node& node, const GridView& grid) const;
  void write_uniform_quads(const Node& node, std::size_t n) const;
  void write_uniform_border(const Node& node, const PatchGrid& last) const;
  void write_split(const Node& node, const GridView& grid) const;
  void write_y(const Node& node, const GridView& grid) const;
  void put_quad(std::uint32_t at, const std::array<std::uint32_t, 4>& quad, int level) const;

  const Patch* patch_;
  std::uint32_t control_face_;
  const RefinedArrays* arrays_;
};

/// What the sides and the face point of a node turn into.
struct Midpoints {
  std::array<std::uint8_t, 4> labels{};
  std::array<std::uint32_t, 4> vertices{};  ///< kNone: the side is not split.
  std::array<EdgeRun, 4> first_halves{};    ///< From corner i on.
  std::array<EdgeRun, 4> second_halves{};
};

Midpoints midpoints_of(const Node& node) {
  const LabelCounts& counts = LabelCounts::table();
  Midpoints midpoints;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::uint8_t a = node.labels[i];
    const std::uint8_t b = node.labels[(i + 1) % 4];
    midpoints.vertices[i] = kNone;
    if (a > 0 || b > 0) {
      const std::uint8_t label = edge_point_label(a, b);
      const std::uint32_t before = counts.edge(lowered(a), label);
      midpoints.labels[i] = label;
      midpoints.vertices[i] = node.sides[i].at(before);
      midpoints.first_halves[i] = node.sides[i];
      midpoints.second_halves[i] = node.sides[i].from(before + 1);
    }
  }
  return midpoints;
}

void PatchWriter::put(std::uint32_t vertex, const Around& next, const GridPlace& place) const {
  const PatchGrid grid = next.grid();
  arrays_->put(vertex, next.at(place), grid.level);
  if (arrays_->takes_limits()) {
    arrays_->put_limit(vertex, limit_in_patch(*patch_, grid, place));
  }
}

void PatchWriter::put_quad(std::uint32_t at, const std::array<std::uint32_t, 4>& quad,
                           int level) const {
  arrays_->quads[at] = quad;
  if (arrays_->face_control_faces != nullptr) {
    arrays_->face_control_faces[at] = control_face_;
    arrays_->face_levels[at] = static_cast<std::uint8_t>(level);
  }
}

void PatchWriter::write(const Node& node, const GridView& grid) const {
  const auto [a, b, c, d] = node.labels;
  if (a == b && b == c && c == d && a > 0 && a <= kGridLevels) {
    if (a == 1) {
      write_last(node, grid);
    } else {
      write_uniform(node, grid);
    }
    return;
  }
  switch (std::ranges::count_if(node.labels, [](std::uint8_t label) { return label > 0; })) {
    case 0:
      put_quad(node.quad, node.corners, node.level);
      return;
    case 1:
      write_y(node, grid);
      return;
    default:
      write_split(node, grid);
  }
}

/// Gives each child what it has of the node's patch, and the owned corners that go on moving.
void PatchWriter::write_split(const Node& node, const GridView& grid) const {
  const LabelCounts& counts = LabelCounts::table();
  const PatchGrid here = around(node, grid);
  const Around next(*patch_, here);
  const int level = node.level + 1;
  const Midpoints midpoints = midpoints_of(node);
  const std::uint8_t centre_label = face_point_label(node.labels);
  const std::uint32_t centre = node.inside;

  std::array<Node, 4> children;
  std::array<EdgeRun, 4> inner;  // From the midpoint of side i to the centre.
  std::uint32_t next_vertex = node.inside + 1;
  for (std::size_t i = 0; i < 4; ++i) {
    inner[i] = {next_vertex, 1};
    next_vertex += counts.edge(midpoints.labels[i], centre_label);
  }
  std::uint32_t next_quad = node.quad;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t after = (i + 1) % 4;
    const std::size_t opposite = (i + 2) % 4;
    const std::size_t before = (i + 3) % 4;
    Node& child = children[i];
    child.level = level;
    child.column = 2 * node.column + (i == 1 || i == 2 ? 1 : 0);
    child.row = 2 * node.row + (i >= 2 ? 1 : 0);
    child.labels[i] = lowered(node.labels[i]);
    child.labels[after] = midpoints.labels[i];
    child.labels[opposite] = centre_label;
    child.labels[before] = midpoints.labels[before];
    child.corners[i] = node.corners[i];
    child.corners[after] = midpoints.vertices[i];
    child.corners[opposite] = centre;
    child.corners[before] = midpoints.vertices[before];
    child.sides[i] = midpoints.first_halves[i];
    child.sides[after] = inner[i];
    child.sides[opposite] =
        inner[before].reversed(counts.edge(midpoints.labels[before], centre_label));
    child.sides[before] = midpoints.second_halves[before];
    child.inside = next_vertex;
    child.quad = next_quad;
    const FaceCounts& part = counts.face(child.labels);
    next_vertex += part.inside;
    next_quad += part.quads;
    child.owned_sides = static_cast<std::uint8_t>(node.owned_sides & (bit(i) | bit(before)));
    child.patch_corners = static_cast<std::uint8_t>(node.patch_corners & bit(i));
    child.patch_sides = static_cast<std::uint8_t>(node.patch_sides & (bit(i) | bit(before)));
  }

  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t after = (i + 1) % 4;
    if (has(node.owned_corners, i)) {
      if (children[i].labels[i] > 0) {
        children[i].owned_corners |= bit(i);
      } else {
        put(node.corners[i], next, kCornersOfFour[i]);
      }
    }
    if (has(node.owned_sides, i) && midpoints.vertices[i] != kNone) {
      // It moves on with a child that has it beside a positive corner.
      if (children[i].labels[i] > 0 || has(node.lifted_sides, i)) {
        children[i].owned_corners |= bit(after);
      } else if (children[after].labels[after] > 0) {
        children[after].owned_corners |= bit(i);
      } else {
        put(midpoints.vertices[i], next, kMiddlesOfFour[i]);
      }
    }
    // The inner edge from the midpoint of side i to the centre has children i and i + 1 beside it.
    // If a face point makes its own midpoint move once more, the child with that face point owns
    // it.
    const std::size_t before = (i + 3) % 4;
    const std::uint8_t greater = std::max(midpoints.labels[i], centre_label);
    const bool by_first = greater == 1 && face_point_label(children[i].labels) > 0;
    const bool by_second = greater == 1 && face_point_label(children[after].labels) > 0;
    if (by_second && !by_first) {
      children[after].owned_sides |= bit(before);
      children[after].lifted_sides |= bit(before);
    } else {
      children[i].owned_sides |= bit(after);
      children[i].lifted_sides |= bit(after, by_first);
    }
  }
  if (centre_label > 0) {
    children[0].owned_corners |= bit(2);
  } else {
    put(centre, next, kCentreOfFour);
  }

  const auto write_children = [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      write(children[i], next.child(i));
    }
  };
  if (next_quad - node.quad >= kParallelQuads) {
    parallel_ranges(0, 4, 1, write_children);
  } else {
    write_children(0, 4);
  }
}

void PatchWriter::write_y(const Node& node, const GridView& grid) const {
  const PatchGrid here = around(node, grid);
  const Around next(*patch_, here);
  const int level = node.level + 1;
  const Midpoints midpoints = midpoints_of(node);
  const auto positive = static_cast<std::size_t>(
      std::ranges::find_if(node.labels, [](std::uint8_t label) { return label > 0; }) -
      node.labels.begin());
  const std::size_t after = (positive + 1) % 4;
  const std::size_t opposite = (positive + 2) % 4;
  const std::size_t before = (positive + 3) % 4;
  const std::uint32_t centre = node.inside;

  Node child;
  child.level = level;
  child.column = 2 * node.column + (positive == 1 || positive == 2 ? 1 : 0);
  child.row = 2 * node.row + (positive >= 2 ? 1 : 0);
  child.labels[positive] = lowered(node.labels[positive]);
  child.corners[positive] = node.corners[positive];
  child.corners[after] = midpoints.vertices[positive];
  child.corners[opposite] = centre;
  child.corners[before] = midpoints.vertices[before];
  child.sides[positive] = midpoints.first_halves[positive];
  child.sides[before] = midpoints.second_halves[before];
  child.inside = node.inside + 1;
  child.quad = node.quad;
  child.owned_sides = static_cast<std::uint8_t>(node.owned_sides & (bit(positive) | bit(before)));
  child.patch_corners = static_cast<std::uint8_t>(node.patch_corners & bit(positive));
  child.patch_sides = static_cast<std::uint8_t>(node.patch_sides & (bit(positive) | bit(before)));

  const bool goes_on = child.labels[positive] > 0;
  for (const std::size_t i : {positive, after, before}) {
    if (has(node.owned_corners, i)) {
      if (i == positive && goes_on) {
        child.owned_corners |= bit(i);
      } else {
        put(node.corners[i], next, kCornersOfFour[i]);
      }
    }
  }
  const auto put_midpoint = [&](std::size_t side, std::size_t child_corner) {
    if (has(node.owned_sides, side)) {
      if (goes_on) {
        child.owned_corners |= bit(child_corner);
      } else {
        put(midpoints.vertices[side], next, kMiddlesOfFour[side]);
      }
    }
  };
  put_midpoint(positive, after);
  put_midpoint(before, before);
  put(centre, next, kCentreOfFour);

  write(child, next.child(positive));
  const std::uint32_t quad = node.quad + LabelCounts::table().face(child.labels).quads;
  put_quad(quad,
           {midpoints.vertices[positive], node.corners[after], node.corners[opposite], centre},
           level);
  put_quad(quad + 1,
           {midpoints.vertices[before], centre, node.corners[opposite], node.corners[before]},
           level);
}

/// The numbers of a row of a uniform node's vertices.
struct NumberRow {
  std::uint32_t first = 0;
  EdgeRun inner;
  std::uint32_t last = 0;
};

NumberRow number_row(const Node& node, std::uint32_t n, std::uint32_t row) {
  const std::array<std::uint32_t, 4>& corners = node.corners;
  const std::array<EdgeRun, 4>& sides = node.sides;
  if (row == 0) {
    return {corners[0], sides[0], corners[1]};
  }
  if (row == n) {
    return {corners[3], sides[2].reversed(n - 1), corners[2]};
  }
  return {sides[3].at(n - 1 - row), {node.inside + (row - 1) * (n - 1), 1}, sides[1].at(row - 1)};
}

using Quad [[gnu::vector_size(16)]] = std::uint32_t;

/// The n quads between two rows.
void write_quad_row(const NumberRow& below, const NumberRow& above, std::uint32_t n,
                    std::array<std::uint32_t, 4>* out) {
  const auto put = [&out](const Quad& quad) { std::memcpy(out++, &quad, sizeof quad); };
  const EdgeRun b = below.inner;
  const EdgeRun a = above.inner;
  put(Quad{below.first, b.at(0), a.at(0), above.first});
  Quad inner{b.at(0), b.at(1), a.at(1), a.at(0)};
  const Quad step{b.step(), b.step(), a.step(), a.step()};
  for (std::uint32_t i = 2; i < n; ++i) {
    put(inner);
    inner += step;
  }
  put(Quad{inner[0], below.last, above.last, inner[3]});
}

void PatchWriter::write_uniform_quads(const Node& node, std::size_t side) const {
  const auto n = static_cast<std::uint32_t>(side);
  NumberRow below = number_row(node, n, 0);
  for (std::uint32_t row = 0; row < n; ++row) {
    const NumberRow above = number_row(node, n, row + 1);
    write_quad_row(below, above, n, arrays_->quads + node.quad + std::size_t{row} * n);
    below = above;
  }
  if (arrays_->face_control_faces != nullptr) {
    std::fill_n(arrays_->face_control_faces + node.quad, side * side, control_face_);
    std::fill_n(arrays_->face_levels + node.quad, side * side,
                static_cast<std::uint8_t>(node.level + node.labels[0]));
  }
}

/// A uniform node of one level: four quads, and five points at most.
void PatchWriter::write_last(const Node& node, const GridView& grid) const {
  const PatchGrid last = around(node, grid);
  std::array<std::uint32_t, 4> middles;
  for (std::size_t i = 0; i < 4; ++i) {
    middles[i] = node.sides[i].at(0);
    if (has(node.owned_sides, i)) {
      arrays_->put(middles[i], step_down_middle(*patch_, last, i), node.level + 1);
    }
    if (has(node.owned_corners, i)) {
      arrays_->put(node.corners[i], step_down_corner(*patch_, last, i), node.level + 1);
    }
  }
  arrays_->put(node.inside, centroid(grid), node.level + 1);
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::size_t after = (i + 1) % 4;
    const std::size_t before = (i + 3) % 4;
    std::array<std::uint32_t, 4> quad;
    quad[i] = node.corners[i];
    quad[after] = middles[i];
    quad[(i + 2) % 4] = node.inside;
    quad[before] = middles[before];
    put_quad(node.quad + i, quad, node.level + 1);
  }
  if (arrays_->takes_limits()) {
    put_last_limits(*patch_, node, last, *arrays_);
  }
}

void PatchWriter::write_uniform(const Node& node, const GridView& grid) const {
  std::array<std::array<Point, kStoredSide * kStoredSide>, 2> levels;
  Point* points = nullptr;
  PatchGrid last = around(node, grid);
  for (int step = 1; step < node.labels[0]; ++step) {
    points = levels[static_cast<std::size_t>(step) % 2].data();
    step_down(*patch_, last, points);
    last = one_level_down(last, points);
  }
  const std::size_t n = 2 * last.grid.n;
  write_uniform_quads(node, n);

  const int level = last.level + 1;
  if (!arrays_->has_limit_points) {
    const auto write_rows = patch_->is_bilinear ? bilinear_inner_rows : refine_inner_rows;
    write_rows(last.grid, arrays_->points + arrays_->width * node.inside, arrays_->width);
  }
  if (arrays_->vertex_levels != nullptr) {
    std::fill_n(arrays_->vertex_levels + node.inside, (n - 1) * (n - 1),
                static_cast<std::uint8_t>(level));
  }
  write_uniform_border(node, last);
  if (arrays_->takes_limits()) {
    put_uniform_limits(*patch_, node, last, points, *arrays_);
  }
}

/// The sides and corners that a uniform node owns, out of its last level but one.
void PatchWriter::write_uniform_border(const Node& node, const PatchGrid& last) const {
  const std::size_t n = 2 * last.grid.n;
  std::array<Point, kGridSide + 2> line_with_ends;
  Point* const line = line_with_ends.data() + 1;
  for (std::size_t i = 0; i < 4; ++i) {
    if (has(node.owned_sides, i)) {
      step_down_side(*patch_, last, i, line);
      for (std::uint32_t at = 1; at < n; ++at) {
        const auto along = static_cast<std::uint32_t>(i < 2 ? at - 1 : n - 1 - at);
        arrays_->put(node.sides[i].at(along), line[at], last.level + 1);
      }
    }
    if (has(node.owned_corners, i)) {
      arrays_->put(node.corners[i], step_down_corner(*patch_, last, i), last.level + 1);
    }
  }
}

}  // namespace

void refine_patch(const Patch& patch, const Node& node, std::uint32_t control_face,
                  const RefinedArrays& arrays) {
  PatchWriter(patch, control_face, arrays).write(node, {patch.grid.data(), 4, 1});
}

}  // namespace limn
