#version 450
// A square around a circle on the screen.

#include "frame.glsl"

layout(location = 0) uniform vec4 ring;  // centre from the upper left, radius, line width; pixels

out vec2 from_centre;

void main() {
  float reach = ring.z + 2.0 * ring.w + 2.0;
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  from_centre = corner * reach;
  vec2 place = ring.xy + from_centre;
  gl_Position = vec4(place.x / viewport.x * 2.0 - 1.0, 1.0 - place.y / viewport.y * 2.0, 0.0, 1.0);
}
