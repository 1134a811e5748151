#version 450

// The interface's triangles: window coordinates, y down.
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 texture_place;
layout(location = 2) in vec4 colour;

// Window coordinates to clip space: xy * scale_offset.xy + scale_offset.zw.
layout(location = 0) uniform vec4 scale_offset;

layout(location = 0) out vec2 fragment_place;
layout(location = 1) out vec4 fragment_colour;

void main() {
  fragment_place = texture_place;
  fragment_colour = colour;
  gl_Position = vec4(position * scale_offset.xy + scale_offset.zw, 0.0, 1.0);
}
