#version 450
#extension GL_ARB_shader_draw_parameters : require
// Faces with everything that shading needs to know of them, pulled from storage buffers.

#include "surface.glsl"
#include "face_paint.glsl"
#include "frame.glsl"
#include "face_bytes.glsl"

layout(std430, binding = 5) restrict readonly buffer SurfaceNormals { float surface_normals[]; };

out vec3 eye_position;
out vec3 smooth_normal;
flat out vec3 flat_normal;
// Distances in mesh units to the face's true edges, linear over the triangle: all four of a quad,
// the three of a triangle, and of a larger polygon those of its sides that bound this triangle.
out vec4 edge_distances;
flat out uint face_state;  // depth or distance, level << 8, highlighted << 16, illegal << 17, min(sides, 5) << 18

const float kNoEdge = 1e9;

vec3 corner_position(SurfaceCorner corner, uint side) {
  return surface_position(surface_corners[corner.first_corner + side]);
}

// Newell's normal: for polygons that are not planar too. Relative to corner 0, which keeps digits,
// and to the face's size: areas of tiny faces are no numbers any more.
vec3 face_normal(SurfaceCorner corner) {
  vec3 base = corner_position(corner, 0);
  vec3 normal = vec3(0.0);
  vec3 before = corner_position(corner, 1) - base;
  vec3 extent = max(abs(before), abs(corner_position(corner, 2) - base));
  float unit = max(extent.x, max(extent.y, extent.z));
  float per_unit = unit > 0.0 ? 1.0 / unit : 1.0;
  before *= per_unit;
  for (uint side = 2; side < corner.sides; ++side) {
    vec3 here = (corner_position(corner, side) - base) * per_unit;
    normal += cross(before, here);
    before = here;
  }
  float size = length(normal);
  return size > 0.0 ? normal / size : vec3(0.0, 0.0, 1.0);
}

float distance_to_line(vec3 point, vec3 a, vec3 b) {
  vec3 along = b - a;
  float size = length(along);
  return size > 0.0 ? length(cross(point - a, along / size)) : distance(point, a);
}

vec4 distances_to_edges(SurfaceCorner corner, vec3 position) {
  if (corner.sides == 4) {
    vec3 p[4];
    for (uint side = 0; side < 4; ++side) {
      p[side] = corner_position(corner, side);
    }
    vec4 distances;
    for (uint side = 0; side < 4; ++side) {
      uint next = (side + 1) & 3u;
      distances[side] = corner.side == side || corner.side == next
                            ? 0.0
                            : distance_to_line(position, p[side], p[next]);
    }
    return distances;
  }
  uint second = corner.triangle + 1;
  uint third = corner.triangle + 2;
  vec3 a = corner_position(corner, 0);
  vec3 b = corner_position(corner, second);
  vec3 c = corner_position(corner, third);
  vec4 distances = vec4(kNoEdge);
  if (corner.triangle == 0) {
    distances.x = corner.side == third ? distance_to_line(position, a, b) : 0.0;
  }
  distances.y = corner.side == 0 ? distance_to_line(position, b, c) : 0.0;
  if (third == corner.sides - 1) {
    distances.z = corner.side == second ? distance_to_line(position, c, a) : 0.0;
  }
  return distances;
}

void main() {
  SurfaceCorner corner = pull_surface_corner();
  vec3 position = surface_position(corner.vertex);
  gl_Position = clip_from_local * vec4(position, 1.0);
  eye_position = (view_from_local * vec4(position, 1.0)).xyz;

  smooth_normal = vec3(0.0, 0.0, 1.0);
  flat_normal = vec3(0.0, 0.0, 1.0);
  face_state = 0;
  mat3 rotation = mat3(view_from_local);
  if (has_option(kSmoothNormals)) {
    vec3 normal = vec3(surface_normals[3 * corner.vertex], surface_normals[3 * corner.vertex + 1],
                       surface_normals[3 * corner.vertex + 2]);
    // Where a surface made on the GPU has no tangent plane.
    smooth_normal = rotation * (normal == vec3(0.0) ? face_normal(corner) : normal);
  } else if (corner.is_provoking) {
    flat_normal = rotation * face_normal(corner);
  }
  // Highlighted faces show their edges without the wireframe as well.
  edge_distances = distances_to_edges(corner, position);
  if (corner.is_provoking) {
    uint shade = has_option(kColourByDistance)
                     ? byte_of_face(corner.face)
                     : depth_of_drawn_face(corner.face, corner.control_face);
    uint lit = has_option(kLightsDrawn) ? corner.face : corner.control_face;
    face_state = shade | corner.level << 8 | uint(is_highlighted(lit)) << 16 |
                 uint(is_illegal(corner.control_face)) << 17 | min(corner.sides, 5u) << 18;
  }
}
