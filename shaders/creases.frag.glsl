#version 450
// Two passes, so that where lines meet no casing lies over a neighbour.

layout(location = 0) uniform int is_casing;

noperspective in vec2 place;
flat in float size;
flat in float half_width;
flat in float casing;
flat in vec3 line_colour;

layout(location = 0) out vec4 colour;

const vec4 kCasingColour = vec4(0.07, 0.07, 0.08, 0.75);

void main() {
  float away = length(vec2(place.x - clamp(place.x, 0.0, size), place.y));
  float reach = is_casing != 0 ? half_width + casing : half_width;
  float coverage = clamp(reach + 0.5 - away, 0.0, 1.0);
  colour = is_casing != 0 ? kCasingColour : vec4(line_colour, 1.0);
  colour.a *= coverage;
}
