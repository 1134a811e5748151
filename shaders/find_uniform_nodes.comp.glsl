#version 450
// Lists the uniform nodes of one label.

#include "refinement.glsl"
#include "refinement_tree.glsl"

layout(location = 6) uniform uint label;

layout(std430, binding = 7) restrict writeonly buffer Nodes { PackedNode nodes[]; };

void main() {
  uint index = item_index();
  if (index < item_count) {
    nodes[index] = pack_node(find_node(label, index));
  }
}
