#version 450
// The vertices around uniform nodes of one label that these nodes own: four sides of 2^label
// invocations each, each from its corner on.

#include "refinement.glsl"
#include "refinement_pieces.glsl"
#include "refinement_points.glsl"

layout(location = 6) uniform uint label;

layout(std430, binding = 7) restrict readonly buffer Nodes { PackedNode nodes[]; };

void main() {
  uint index = item_index();
  if (index >= item_count) {
    return;
  }
  Node node = unpack_node(nodes[index >> (label + 2u)]);
  uint n = 1u << label;
  uint side = index >> label & 3u;
  uint along = index & (n - 1u);
  if (!has(along == 0u ? node.owned_corners : node.owned_sides, side)) {
    return;
  }
  uint vertex = along == 0u ? node.corners[side] : on_side(node, side, along - 1u);
  uvec2 place = side == 0u   ? uvec2(along, 0u)
                : side == 1u ? uvec2(n, along)
                : side == 2u ? uvec2(n - along, n)
                             : uvec2(0u, n - along);
  put_point(vertex, node.level + label,
            Vertex(node.root, node.special, node.level + label - node.root_level,
                   (uvec2(node.column, node.row) << label) + place));
}
