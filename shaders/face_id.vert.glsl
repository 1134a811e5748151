#version 450
#extension GL_ARB_shader_draw_parameters : require
// Face numbers for picking: where each corner of a drawn face lies, and the face's number plus 1,
// with the highest bit set where the triangle is seen from behind.

#include "surface.glsl"

layout(location = 0) uniform mat4 clip_from_local;
layout(location = 1) uniform vec4 eye;

flat out uint face_id;

void main() {
  SurfaceCorner corner = pull_surface_corner();
  face_id = 0u;
  if (corner.is_provoking) {
    face_id = (corner.face + 1u) | uint(faces_away(corner, eye)) << 31;
  }
  gl_Position = clip_from_local * vec4(surface_position(corner.vertex), 1.0);
}
