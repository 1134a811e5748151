#version 450
// Edges of a control surface as ribbons of constant width on the screen: six vertices an edge,
// pulled from storage buffers.

#include "frame.glsl"

layout(std430, binding = 0) restrict readonly buffer SurfacePositions { float surface_positions[]; };
layout(std430, binding = 8) restrict readonly buffer SurfaceEdges { uint surface_edges[]; };

layout(location = 0) uniform float width;  // pixels

noperspective out float from_middle;  // pixels across the ribbon
flat out float faintness;  // of edges a few pixels long, which would drown the surface

vec4 end_of_edge(uint end) {
  uint vertex = surface_edges[end];
  return clip_from_local * vec4(surface_positions[3 * vertex], surface_positions[3 * vertex + 1],
                                surface_positions[3 * vertex + 2], 1.0);
}

void main() {
  uint edge = uint(gl_VertexID) / 6;
  uint part = uint(gl_VertexID) % 6;
  vec4 a = end_of_edge(2 * edge);
  vec4 b = end_of_edge(2 * edge + 1);
  // Cut at the near plane, beyond which directions on the screen make no sense.
  float a_inside = a.z + a.w;
  float b_inside = b.z + b.w;
  if (a_inside < 0.0 && b_inside < 0.0) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    from_middle = 0.0;
    faintness = 0.0;
    return;
  }
  if (a_inside < 0.0) {
    a = mix(a, b, a_inside / (a_inside - b_inside));
  } else if (b_inside < 0.0) {
    b = mix(b, a, b_inside / (b_inside - a_inside));
  }
  vec2 half_size = 0.5 * viewport.xy;
  vec2 along = (b.xy / b.w - a.xy / a.w) * half_size;
  float size = length(along);
  vec2 across = size > 1e-6 ? vec2(-along.y, along.x) / size : vec2(0.0, 1.0);

  bool is_second = part == 1 || part == 2 || part == 4;
  float side = part == 0 || part == 1 || part == 3 ? -1.0 : 1.0;
  float reach = 0.5 * width + 1.0;
  vec4 position = is_second ? b : a;
  position.xy += across * side * reach / half_size * position.w;
  // Towards the eye by a hair, so that a cage edge on the surface is not swallowed by it.
  position.z -= 2e-5 * position.w;
  gl_Position = position;
  from_middle = side * reach;
  faintness = mix(0.3, 1.0, smoothstep(5.0 * viewport.z, 40.0 * viewport.z, size));
}
