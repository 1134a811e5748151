#version 450
// The brush ring: a line of the accent colour with a soft dark one outside, to be seen on anything.

#include "frame.glsl"

layout(location = 0) uniform vec4 ring;

in vec2 from_centre;

layout(location = 0) out vec4 colour;

void main() {
  float from_line = length(from_centre) - ring.z;
  float core = clamp(0.5 * ring.w + 0.5 - abs(from_line), 0.0, 1.0);
  float shadow = 0.3 * clamp(1.5 * ring.w + 0.5 - abs(from_line), 0.0, 1.0);
  float alpha = core + shadow * (1.0 - core);
  colour = vec4(accent.rgb * core / max(alpha, 1e-4), alpha);
}
