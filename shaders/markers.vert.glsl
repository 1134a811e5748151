#version 450
// Dots and digits at points of the surface, of constant size on the screen: six vertices a marker.

#include "frame.glsl"

struct Marker {
  float x, y, z;
  uint number_and_style;  // number | style << 8 | second number << 16 | text << 24
};
layout(std430, binding = 8) restrict readonly buffer Markers { Marker markers[]; };

const float kReach = 10.0;  // the largest dot's half side, in units of the interface
const float kPillReach = 28.0;
const uint kCandidate = 8u;

out vec2 from_centre;  // pixels, y up
flat out uint number;
flat out uint shade;  // of the palette
flat out uint style;
flat out uint second;
flat out uint text;

void main() {
  Marker marker = markers[uint(gl_VertexID) / 6];
  uint part = uint(gl_VertexID) % 6;
  number = marker.number_and_style & 0xFFu;
  shade = min(number, 7u);
  style = marker.number_and_style >> 8 & 0xFFu;
  second = marker.number_and_style >> 16 & 0xFFu;
  text = marker.number_and_style >> 24;

  vec4 centre = clip_from_local * vec4(marker.x, marker.y, marker.z, 1.0);
  float reach = (style >= kCandidate ? kPillReach : kReach) * viewport.z;
  // Towards the eye by as much as the marker is wide, so that the surface around its point does not
  // cut into it, while markers on the far side stay hidden.
  vec4 eye = view_from_local * vec4(marker.x, marker.y, marker.z, 1.0);
  float pixel = 2.0 * centre.w / (viewport.y * projection[1][1]);
  eye.z += reach * pixel;
  vec4 nearer = projection * eye;
  if (centre.w <= 0.0 || nearer.w <= 0.0) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    from_centre = vec2(0.0);
    return;
  }
  vec2 corner = vec2(part == 1 || part == 2 || part == 4 ? 1.0 : -1.0,
                     part == 2 || part == 4 || part == 5 ? 1.0 : -1.0);
  from_centre = corner * reach;
  gl_Position = vec4(centre.xy + corner * reach * 2.0 / viewport.xy * centre.w,
                     min(nearer.z / nearer.w, 1.0) * centre.w, centre.w);
}
