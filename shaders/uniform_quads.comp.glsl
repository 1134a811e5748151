#version 450
// The quads of uniform nodes of one label, one invocation each: row by row through a node of 2^label
// by 2^label, but counter-clockwise where there are only four.

#include "refinement.glsl"
#include "refinement_quads.glsl"

layout(location = 6) uniform uint label;

layout(std430, binding = 7) restrict readonly buffer Nodes { PackedNode nodes[]; };

uint vertex_at(Node node, uvec2 place, uint n) {
  bool is_left = place.x == 0u;
  bool is_right = place.x == n;
  bool is_low = place.y == 0u;
  bool is_high = place.y == n;
  if ((is_left || is_right) && (is_low || is_high)) {
    return node.corners[is_low ? (is_left ? 0u : 1u) : (is_left ? 3u : 2u)];
  }
  if (is_low) {
    return on_side(node, 0u, place.x - 1u);
  }
  if (is_right) {
    return on_side(node, 1u, place.y - 1u);
  }
  if (is_high) {
    return on_side(node, 2u, n - 1u - place.x);
  }
  if (is_left) {
    return on_side(node, 3u, n - 1u - place.y);
  }
  return node.inside + (place.y - 1u) * (n - 1u) + place.x - 1u;
}

void main() {
  uint index = item_index();
  if (index >= item_count) {
    return;
  }
  Node node = unpack_node(nodes[index >> (2u * label)]);
  uint n = 1u << label;
  uint local = index & (n * n - 1u);
  uvec2 place = uvec2(local & (n - 1u), local >> label);
  uvec4 corners = uvec4(vertex_at(node, place, n), vertex_at(node, place + uvec2(1, 0), n),
                        vertex_at(node, place + uvec2(1, 1), n),
                        vertex_at(node, place + uvec2(0, 1), n));
  uint number = label == 1u ? local ^ local >> 1 : local;
  put_quad(node.quad + number, corners, node.control_face | (node.level + label) << 28);
}
