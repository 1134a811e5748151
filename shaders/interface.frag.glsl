#version 450

layout(location = 0) in vec2 fragment_place;
layout(location = 1) in vec4 fragment_colour;

// How much of the texel is covered by a glyph or shape.
layout(binding = 0) uniform sampler2D coverage;

layout(location = 0) out vec4 pixel;

void main() {
  pixel = vec4(fragment_colour.rgb, fragment_colour.a * texture(coverage, fragment_place).r);
}
