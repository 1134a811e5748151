#version 450
// One number a pixel, into R32UI.

flat in uint face_id;
layout(location = 0) out uint id;

void main() { id = face_id; }
