#version 450
// The vertices inside uniform nodes of one label, one invocation each: row by row.

// These are never on a side of their root.
#define INSIDE_NODES
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
  uint inner = (1u << label) - 1u;  // vertices along a row
  uint node_index = index / (inner * inner);
  uint local = index - node_index * inner * inner;
  Node node = unpack_node(nodes[node_index]);
  uint row = local / inner;
  uvec2 place = uvec2(local - row * inner, row) + 1u;
  put_point(node.inside + local, node.level + label,
            Vertex(node.root, node.special, node.level + label - node.root_level,
                   (uvec2(node.column, node.row) << label) + place));
}
