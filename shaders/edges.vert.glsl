#version 450
// Edges of a control surface as ribbons of constant width on the screen: six vertices an edge,
// pulled from storage buffers.

#include "frame.glsl"
#include "ribbon.glsl"

layout(std430, binding = 0) restrict readonly buffer SurfacePositions { float surface_positions[]; };
layout(std430, binding = 8) restrict readonly buffer SurfaceEdges { uint surface_edges[]; };

layout(location = 0) uniform float width;  // pixels

const float kNearer = 0.5;  // pixels

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
  Ribbon ribbon = make_ribbon(end_of_edge(2 * edge), end_of_edge(2 * edge + 1));
  if (!ribbon.is_visible) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    from_middle = 0.0;
    faintness = 0.0;
    return;
  }
  vec2 across =
      ribbon.size > 1e-6 ? vec2(-ribbon.along.y, ribbon.along.x) / ribbon.size : vec2(0.0, 1.0);

  float side = side_of_line(part);
  float reach = 0.5 * width + 1.0;
  vec4 position = is_at_second_end(part) ? ribbon.b : ribbon.a;
  position.xy += across * side * reach / (0.5 * viewport.xy) * position.w;
  position.z = nearer_depth(position, kNearer);
  gl_Position = position;
  from_middle = side * reach;
  faintness = mix(0.3, 1.0, smoothstep(5.0 * viewport.z, 40.0 * viewport.z, ribbon.size));
}
