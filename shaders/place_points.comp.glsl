#version 450
// Vertices that are known from the start.

#include "refinement.glsl"

struct FlatPoint {
  uint vertex;
  uint level;
  float position[3];
  float normal[3];
};
layout(std430, binding = 6) restrict readonly buffer FlatPoints { FlatPoint flat_points[]; };
layout(std430, binding = 0) restrict writeonly buffer SurfacePositions {
  float surface_positions[];
};
layout(std430, binding = 4) restrict writeonly buffer VertexLevels { uint vertex_levels[]; };
layout(std430, binding = 5) restrict writeonly buffer SurfaceNormals { float surface_normals[]; };

const uint kWithLevels = 1u;
const uint kWithNormals = 2u;
layout(location = 5) uniform uint options;

void main() {
  uint index = item_index();
  if (index >= item_count) {
    return;
  }
  FlatPoint point = flat_points[index];
  for (uint i = 0; i < 3; ++i) {
    surface_positions[3 * point.vertex + i] = point.position[i];
    if ((options & kWithNormals) != 0u) {
      surface_normals[3 * point.vertex + i] = point.normal[i];
    }
  }
  if ((options & kWithLevels) != 0u) {
    vertex_levels[point.vertex] = point.level;
  }
}
