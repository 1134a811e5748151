#version 450
// Marks the control faces that own a pixel of the id image, one bit each. One invocation a pixel;
// only the first pixel of a run of equal numbers in its row does any work.

layout(local_size_x = 32, local_size_y = 4) in;

layout(binding = 0) uniform usampler2D ids;
layout(std430, binding = 3) restrict readonly buffer SurfaceFaces { uint surface_faces[]; };
layout(std430, binding = 9) restrict buffer VisibleFaces { uint visible_faces[]; };

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, textureSize(ids, 0)))) {
    return;
  }
  uint id = texelFetch(ids, pixel, 0).r;
  if (id == 0u || (pixel.x > 0 && texelFetch(ids, pixel - ivec2(1, 0), 0).r == id)) {
    return;
  }
  uint control_face = surface_faces[id - 1u] & 0x0FFFFFFFu;
  atomicOr(visible_faces[control_face >> 5], 1u << (control_face & 31u));
}
