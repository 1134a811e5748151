#version 450
#include "frame.glsl"

layout(location = 0) uniform float width;   // pixels
layout(location = 1) uniform float strength;  // of the whole line

noperspective in float from_middle;
flat in float faintness;

layout(location = 0) out vec4 colour;

void main() {
  float coverage = clamp(0.5 * width + 0.5 - abs(from_middle), 0.0, 1.0);
  colour = vec4(cage.rgb, cage.a * strength * faintness * coverage);
}
