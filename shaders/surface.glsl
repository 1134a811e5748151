// A surface pulled from storage buffers (render/surface/surface_buffers.h). One multi-draw covers
// all faces: gl_DrawIDARB selects the group of faces with the same number of sides, gl_VertexID the
// face in it, its triangle of the fan around corner 0, and the corner.
// Include after `#extension GL_ARB_shader_draw_parameters : require`; vertex shaders only.

struct SurfaceGroup {
  uint sides;
  uint first_face;
  uint first_corner;
  uint triangles;  // per face
};

layout(std430, binding = 0) restrict readonly buffer SurfacePositions { float surface_positions[]; };
layout(std430, binding = 1) restrict readonly buffer SurfaceCorners { uint surface_corners[]; };
layout(std430, binding = 2) restrict readonly buffer SurfaceGroups { SurfaceGroup surface_groups[]; };
layout(std430, binding = 3) restrict readonly buffer SurfaceFaces { uint surface_faces[]; };

struct SurfaceCorner {
  uint face;          // drawn face, 0..face count - 1
  uint control_face;  // the control face it lies in
  uint level;         // the level it was made at
  uint sides;
  uint first_corner;  // of the face, in surface_corners
  uint triangle;      // of the fan, 0..sides - 3
  uint side;          // which of the face's corners, 0..sides - 1
  uint vertex;
  bool is_provoking;  // whether flat outputs are taken from here
};

vec3 surface_position(uint vertex) {
  return vec3(surface_positions[3 * vertex], surface_positions[3 * vertex + 1],
              surface_positions[3 * vertex + 2]);
}

SurfaceCorner pull_surface_corner() {
  SurfaceGroup group = surface_groups[gl_DrawIDARB];
  uint index = uint(gl_VertexID);
  uint triangle_index = index / 3;
  uint corner_in_triangle = index - triangle_index * 3;
  uint face_in_group = triangle_index / group.triangles;

  SurfaceCorner corner;
  corner.face = group.first_face + face_in_group;
  uint record = surface_faces[corner.face];
  corner.control_face = record & 0x0FFFFFFFu;
  corner.level = record >> 28;
  corner.sides = group.sides;
  corner.first_corner = group.first_corner + face_in_group * group.sides;
  corner.triangle = triangle_index - face_in_group * group.triangles;
  corner.side = corner_in_triangle == 0 ? 0 : corner.triangle + corner_in_triangle;
  corner.vertex = surface_corners[corner.first_corner + corner.side];
  corner.is_provoking = corner_in_triangle == 2;
  return corner;
}

// Whether the triangle turns its back to the eye, that of eye_from_local (render/camera.h).
bool faces_away(SurfaceCorner corner, vec4 eye) {
  vec3 a = surface_position(surface_corners[corner.first_corner]);
  vec3 b = surface_position(surface_corners[corner.first_corner + corner.triangle + 1]);
  vec3 c = surface_position(surface_corners[corner.first_corner + corner.triangle + 2]);
  return dot(cross(b - a, c - a), eye.xyz - eye.w * a) < 0.0;
}
