#version 450
// Sharp edges as ribbons with round ends, sharp vertices as dots (ribbons without length): six
// vertices each, pulled from a storage buffer.

#include "frame.glsl"
#include "ribbon.glsl"

struct Crease {
  float ax, ay, az;
  uint colour;  // sRGB, red lowest
  float bx, by, bz;
  float width;  // units of the interface
};
layout(std430, binding = 8) restrict readonly buffer Creases { Crease creases[]; };

const float kCasing = 1.25;  // of a darker line around each, units of the interface

noperspective out vec2 place;  // pixels along and across
flat out float size;           // pixels from end to end
flat out float half_width;     // pixels
flat out float casing;         // pixels
flat out vec3 line_colour;

void main() {
  Crease crease = creases[uint(gl_VertexID) / 6];
  uint part = uint(gl_VertexID) % 6;
  Ribbon ribbon = make_ribbon(clip_from_local * vec4(crease.ax, crease.ay, crease.az, 1.0),
                              clip_from_local * vec4(crease.bx, crease.by, crease.bz, 1.0));
  size = ribbon.size;
  half_width = 0.5 * crease.width * viewport.z;
  casing = kCasing * viewport.z;
  line_colour = vec3(uvec3(crease.colour, crease.colour >> 8, crease.colour >> 16) & 0xFFu) / 255.0;
  if (!ribbon.is_visible) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    place = vec2(0.0);
    return;
  }
  vec2 direction = ribbon.size > 1e-6 ? ribbon.along / ribbon.size : vec2(1.0, 0.0);
  vec2 across = vec2(-direction.y, direction.x);
  bool is_second = is_at_second_end(part);
  float reach = half_width + casing + 1.0;
  float side = side_of_line(part) * reach;
  float beyond = is_second ? reach : -reach;
  vec4 position = is_second ? ribbon.b : ribbon.a;
  position.z = nearer_depth(position, 2.0 * reach);
  position.xy += (direction * beyond + across * side) / (0.5 * viewport.xy) * position.w;
  gl_Position = position;
  place = vec2(is_second ? ribbon.size + reach : -reach, side);
}
