#version 450
// In which control faces some drawn faces lie, one invocation each.

layout(local_size_x = 64) in;

layout(std430, binding = 3) restrict readonly buffer SurfaceFaces { uint surface_faces[]; };
layout(std430, binding = 8) restrict readonly buffer DrawnFaces { uint drawn_faces[]; };
layout(std430, binding = 9) restrict writeonly buffer ControlFaces { uint control_faces[]; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i < uint(drawn_faces.length())) {
    control_faces[i] = surface_faces[drawn_faces[i]] & 0x0FFFFFFFu;
  }
}
