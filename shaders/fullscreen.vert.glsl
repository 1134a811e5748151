#version 450
// One triangle that covers the viewport, made from gl_VertexID 0..2; no vertex data.

out vec2 uv;  // 0..1, from the lower left.

void main() {
  uv = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
  gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);
}
