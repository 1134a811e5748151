#version 450
flat in vec4 ends;
flat in vec4 segment_colour;
flat in float width;
in vec2 place;

layout(location = 0) out vec4 colour;

void main() {
  vec2 along = ends.zw - ends.xy;
  float t = clamp(dot(place - ends.xy, along) / max(dot(along, along), 1e-9), 0.0, 1.0);
  float coverage = clamp(0.5 * width + 0.5 - distance(place, ends.xy + t * along), 0.0, 1.0);
  colour = vec4(segment_colour.rgb, segment_colour.a * coverage);
}
