#version 450
// Marks the control faces that are seen in the id image, one bit each. One invocation a pixel; only
// the first pixel of a run of equal numbers in its row that counts does any work.
// What counts as seen is said in render/picking/seen.h.

layout(local_size_x = 32, local_size_y = 4) in;

layout(binding = 0) uniform usampler2D ids;
layout(std430, binding = 3) restrict readonly buffer SurfaceFaces { uint surface_faces[]; };
layout(std430, binding = 9) restrict buffer VisibleFaces { uint visible_faces[]; };

const uint kFromBehind = 1u << 31;

uint id_at(ivec2 pixel) { return texelFetch(ids, pixel, 0).r; }

bool is_clear_of_front_faces(ivec2 pixel) {
  ivec2 low = max(pixel - 1, ivec2(0));
  ivec2 high = min(pixel + 1, textureSize(ids, 0) - 1);
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) {
      if ((id_at(ivec2(x, y)) & kFromBehind) == 0u) {
        return false;
      }
    }
  }
  return true;
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, textureSize(ids, 0)))) {
    return;
  }
  uint id = id_at(pixel);
  if (id == 0u) {
    return;
  }
  if ((id & kFromBehind) != 0u) {
    if (!is_clear_of_front_faces(pixel)) {
      return;
    }
  } else if (pixel.x > 0 && id_at(pixel - ivec2(1, 0)) == id) {
    return;
  }
  uint control_face = surface_faces[(id & ~kFromBehind) - 1u] & 0x0FFFFFFFu;
  atomicOr(visible_faces[control_face >> 5], 1u << (control_face & 31u));
}
