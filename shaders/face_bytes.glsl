// A byte for each drawn face: its distance from the limit surface, 0 for none and 255 for the
// greatest (render/surface/face_distances.h), or with kHasDemands the depth that is asked of it
// beyond its control face's (render/surface/face_demands.h).
// Include after frame.glsl and face_paint.glsl.

layout(std430, binding = 10) restrict readonly buffer FaceBytes { uint face_bytes[]; };  // 4 a word

uint byte_of_face(uint face) { return face_bytes[face >> 2] >> ((face & 3u) * 8u) & 0xFFu; }
uint depth_of_drawn_face(uint face, uint control_face) {
  uint depth = depth_of_face(control_face);
  return has_option(kHasDemands) ? max(depth, byte_of_face(face)) : depth;
}
