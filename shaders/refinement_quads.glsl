// Writing quads. After refinement.glsl.

layout(location = 3) uniform uint first_quad;    // among drawn faces
layout(location = 4) uniform uint first_corner;  // of quads, among corners

layout(std430, binding = 1) restrict writeonly buffer SurfaceCorners { uint surface_corners[]; };
layout(std430, binding = 3) restrict writeonly buffer SurfaceFaces { uint surface_faces[]; };

void put_quad(uint quad, uvec4 corners, uint record) {
  uint at = first_corner + 4 * quad;
  surface_corners[at] = corners.x;
  surface_corners[at + 1] = corners.y;
  surface_corners[at + 2] = corners.z;
  surface_corners[at + 3] = corners.w;
  surface_faces[first_quad + quad] = record;
}
