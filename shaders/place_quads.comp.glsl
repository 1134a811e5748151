#version 450
// Quads that are known from the start.

#include "refinement.glsl"
#include "refinement_quads.glsl"

struct FlatQuad {
  uint quad;
  uint record;
  uint corners[4];
};
layout(std430, binding = 6) restrict readonly buffer FlatQuads { FlatQuad flat_quads[]; };

void main() {
  uint index = item_index();
  if (index < item_count) {
    FlatQuad flat_quad = flat_quads[index];
    put_quad(flat_quad.quad,
             uvec4(flat_quad.corners[0], flat_quad.corners[1], flat_quad.corners[2],
                   flat_quad.corners[3]),
             flat_quad.record);
  }
}
