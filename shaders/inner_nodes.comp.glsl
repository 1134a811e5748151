#version 450
// Nodes that split or become Y-elements, one invocation each: their vertices that rest from here on,
// the quads of their children that stay, and the two quads that a Y-element leaves beside its child.

#include "refinement.glsl"
#include "refinement_tree.glsl"
#include "refinement_quads.glsl"
#include "refinement_pieces.glsl"
#include "refinement_points.glsl"

const uvec2 kPlaces[9] = uvec2[](uvec2(0, 0), uvec2(2, 0), uvec2(2, 2), uvec2(0, 2),  // corners
                                 uvec2(1, 0), uvec2(2, 1), uvec2(1, 2), uvec2(0, 1),  // midpoints
                                 uvec2(1, 1));

uvec4 child_corners(Node node, Midpoints middles, uint i) {
  uvec4 corners;
  corners[i] = node.corners[i];
  corners[(i + 1) & 3u] = middles.vertices[i];
  corners[(i + 2) & 3u] = node.inside;
  corners[(i + 3) & 3u] = middles.vertices[(i + 3) & 3u];
  return corners;
}

void put_split_quads(Node node, Midpoints middles, uint record) {
  uint quad = node.quad;
  for (uint i = 0; i < 4; ++i) {
    uint labels = child_labels(node, middles, i);
    if (labels == 0u) {
      put_quad(quad, child_corners(node, middles, i), record);
    }
    quad += subtree_counts[subtree(labels) + kQuads];
  }
}

void put_y_quads(Node node, Midpoints middles, uint i, uint record) {
  uint after = (i + 1) & 3u;
  uint opposite = (i + 2) & 3u;
  uint before = (i + 3) & 3u;
  uint labels = child_labels(node, middles, i);
  if (labels == 0u) {
    put_quad(node.quad, child_corners(node, middles, i), record);
  }
  uint quad = node.quad + subtree_counts[subtree(labels) + kQuads];
  put_quad(quad,
           uvec4(middles.vertices[i], node.corners[after], node.corners[opposite], node.inside),
           record);
  put_quad(quad + 1,
           uvec4(middles.vertices[before], node.inside, node.corners[opposite],
                 node.corners[before]),
           record);
}

// Bits of kPlaces.
uint resting_in_split(Node node, Midpoints middles) {
  uint resting = uint(middles.centre_label == 0u) << 8;
  for (uint i = 0; i < 4; ++i) {
    if (has(node.owned_corners, i) && label_at(node.labels, i) <= 1u) {
      resting |= 1u << i;
    }
    if (has(node.owned_sides, i) && middles.vertices[i] != kNone && !goes_with_first(node, i) &&
        !goes_with_second(node, i)) {
      resting |= 16u << i;
    }
  }
  return resting;
}

uint resting_in_y(Node node, uint i) {
  uint after = (i + 1) & 3u;
  uint before = (i + 3) & 3u;
  uint resting = 1u << 8 | node.owned_corners & (1u << after | 1u << before);
  if (label_at(node.labels, i) <= 1u) {
    resting |= node.owned_corners & 1u << i;
    resting |= (node.owned_sides & (1u << i | 1u << before)) << 4;
  }
  return resting;
}

void main() {
  uint index = item_index();
  if (index >= item_count) {
    return;
  }
  Node node = find_node(kInnerKind, index);
  Midpoints middles = midpoints_of(node);
  uint level = node.level + 1;
  uint record = node.control_face | level << 28;
  uint y = y_corner(node);
  uint resting;
  if (y == kNone) {
    put_split_quads(node, middles, record);
    resting = resting_in_split(node, middles);
  } else {
    put_y_quads(node, middles, y, record);
    resting = resting_in_y(node, y);
  }
  for (uint i = 0; i < 9; ++i) {
    if (has(resting, i)) {
      uint vertex = i < 4 ? node.corners[i] : i < 8 ? middles.vertices[i - 4] : node.inside;
      put_point(vertex, level,
                Vertex(node.root, node.special, level - node.root_level,
                       2 * uvec2(node.column, node.row) + kPlaces[i]));
    }
  }
}
