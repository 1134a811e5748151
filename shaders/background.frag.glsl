#version 450
// A vertical gradient, dithered by less than one step so that it shows no bands.

layout(location = 0) uniform vec4 top;
layout(location = 1) uniform vec4 bottom;

in vec2 uv;
layout(location = 0) out vec4 colour;

void main() {
  vec3 gradient = mix(bottom.rgb, top.rgb, uv.y);
  // Interleaved gradient noise (Jimenez 2014).
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  colour = vec4(gradient + (noise - 0.5) / 255.0, 1.0);
}
