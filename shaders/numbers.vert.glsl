#version 450
#extension GL_ARB_shader_draw_parameters : require
// A number in the middle of every face that is large enough on the screen to hold it: three vertices
// a face, a triangle around the digits. Nothing is stored for it: the faces are those that are
// drawn, and what does not fit is dropped here.

#include "surface.glsl"
#include "face_paint.glsl"
#include "frame.glsl"
#include "face_bytes.glsl"

// Where not every face gets a number: drawn face, and how many times its size the number's is.
struct NumberedFace {
  uint face;
  float scale;
};
layout(std430, binding = 8) restrict readonly buffer NumberedFaces { NumberedFace numbered_faces[]; };

layout(location = 0) uniform int group_count;
layout(location = 1) uniform int is_listed;

const float kReach = 10.0;   // half the side of what is drawn, in units of the interface
const float kRoom = 6.5;     // a face's edges are at least as far from its middle
const uint kFaceNumber = 3u;

out vec2 from_centre;  // pixels, y up
flat out uint number;
flat out uint shade;
flat out uint style;
flat out uint second;
flat out uint text;

vec2 pixels_of(vec4 clip) { return clip.xy / clip.w * 0.5 * viewport.xy; }

float distance_to_line(vec2 point, vec2 a, vec2 b) {
  vec2 along = b - a;
  float size = length(along);
  vec2 way = point - a;
  return size > 0.0 ? abs(along.x * way.y - along.y * way.x) / size : length(way);
}

void drop() {
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  from_centre = vec2(0.0);
}

void main() {
  uint index = uint(gl_VertexID) / 3;
  uint part = uint(gl_VertexID) % 3;
  uint face = is_listed != 0 ? numbered_faces[index].face : index;
  float scale = is_listed != 0 ? numbered_faces[index].scale : 1.0;

  uint record = surface_faces[face];
  number = has_option(kColourByLevel) ? record >> 28 : depth_of_drawn_face(face, record & 0x0FFFFFFFu);
  shade = has_option(kColourByLevel) || has_option(kColourByDepth) ? min(number, 7u) : 0u;
  style = kFaceNumber;
  second = 0u;
  text = 0u;
  if (number == 0) {
    drop();
    return;
  }

  int g = 0;
  while (g + 1 < group_count && surface_groups[g + 1].first_face <= face) {
    ++g;
  }
  SurfaceGroup group = surface_groups[g];
  uint first = group.first_corner + (face - group.first_face) * group.sides;
  vec3 base = surface_position(surface_corners[first]);
  vec3 sum = vec3(0.0);
  for (uint side = 1; side < group.sides; ++side) {
    sum += surface_position(surface_corners[first + side]) - base;
  }
  vec3 middle = base + sum / float(group.sides);
  vec4 centre = clip_from_local * vec4(middle, 1.0);
  vec4 seen = view_from_local * vec4(middle, 1.0);
  if (centre.w <= 0.0 || centre.z > centre.w) {
    drop();
    return;
  }

  float room = 1e9;
  vec2 at = pixels_of(centre);
  vec4 before = clip_from_local * vec4(surface_position(surface_corners[first + group.sides - 1]), 1.0);
  for (uint side = 0; side < group.sides; ++side) {
    vec4 here = clip_from_local * vec4(surface_position(surface_corners[first + side]), 1.0);
    if (here.w <= 0.0 || before.w <= 0.0) {
      drop();
      return;
    }
    room = min(room, distance_to_line(at, pixels_of(before), pixels_of(here)));
    before = here;
  }
  float wanted = (number >= 10u ? 1.3 : 1.0) * kRoom * viewport.z;
  if (room * scale < wanted) {
    drop();
    return;
  }

  // Towards the eye by half a digit, so that a face seen aslant does not cut into its number.
  float pixel = 2.0 * centre.w / (viewport.y * projection[1][1]);
  seen.z += kRoom * viewport.z * pixel;
  vec4 nearer = projection * seen;
  vec2 corner = part == 0 ? vec2(-1.0, -1.0) : part == 1 ? vec2(3.0, -1.0) : vec2(-1.0, 3.0);
  float reach = kReach * viewport.z;
  from_centre = corner * reach;
  gl_Position = vec4(centre.xy + corner * reach * 2.0 / viewport.xy * centre.w,
                     nearer.w > 0.0 ? min(nearer.z / nearer.w, 1.0) * centre.w : centre.w, centre.w);
}
