#version 450
// Lines over the picture, in framebuffer pixels: six vertices a segment.

#include "frame.glsl"

struct Segment {
  vec4 ends;    // x, y of both, from the upper left
  vec4 colour;  // sRGB and opacity
  float width;
  float unused_0, unused_1, unused_2;
};
layout(std430, binding = 8) restrict readonly buffer Segments { Segment segments[]; };

flat out vec4 ends;
flat out vec4 segment_colour;
flat out float width;
out vec2 place;

void main() {
  Segment segment = segments[uint(gl_VertexID) / 6];
  uint part = uint(gl_VertexID) % 6;
  ends = segment.ends;
  segment_colour = segment.colour;
  width = segment.width;
  vec2 along = segment.ends.zw - segment.ends.xy;
  float size = length(along);
  vec2 direction = size > 1e-6 ? along / size : vec2(1.0, 0.0);
  vec2 across = vec2(-direction.y, direction.x);
  float reach = 0.5 * width + 1.0;
  bool is_second = part == 1 || part == 2 || part == 4;
  float side = part == 0 || part == 1 || part == 3 ? -1.0 : 1.0;
  place = (is_second ? segment.ends.zw + direction * reach : segment.ends.xy - direction * reach) +
          across * side * reach;
  gl_Position = vec4(place.x / viewport.x * 2.0 - 1.0, 1.0 - place.y / viewport.y * 2.0, 0.0, 1.0);
}
