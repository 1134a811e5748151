// What is painted on control faces (render/surface/face_paint.h).

layout(std430, binding = 4) restrict readonly buffer FaceDepths { uint face_depths[]; };  // 4 a word
layout(std430, binding = 6) restrict readonly buffer HighlightedFaces { uint highlighted_faces[]; };
layout(std430, binding = 7) restrict readonly buffer IllegalFaces { uint illegal_faces[]; };

uint depth_of_face(uint face) { return (face_depths[face >> 2] >> ((face & 3u) * 8u)) & 0xFFu; }
bool is_highlighted(uint face) { return (highlighted_faces[face >> 5] >> (face & 31u) & 1u) != 0u; }
bool is_illegal(uint face) { return (illegal_faces[face >> 5] >> (face & 31u) & 1u) != 0u; }
