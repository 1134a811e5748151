#version 450
// Dots by their distance field, digits as strokes of a small font (render/digit_strokes.h).

#include "frame.glsl"

layout(std430, binding = 9) restrict readonly buffer DigitStrokes {
  uint first_stroke[12];  // of digits 0..9; [10] is their number
  vec4 strokes[];         // from, to; a digit is 0.6 wide and 1 high, y up
};

const uint kLabel = 0u;
const uint kIllegalVertex = 1u;
const uint kRelabelled = 2u;
const uint kFaceNumber = 3u;
const uint kValence = 4u;  // 4 + band

in vec2 from_centre;
flat in uint number;
flat in uint shade;
flat in uint style;

layout(location = 0) out vec4 colour;

float distance_to_segment(vec2 point, vec2 a, vec2 b) {
  vec2 along = b - a;
  float t = clamp(dot(point - a, along) / max(dot(along, along), 1e-9), 0.0, 1.0);
  return distance(point, a + t * along);
}

// Distance to the strokes of a digit whose lower left corner is the origin.
float distance_to_digit(vec2 point, uint digit) {
  float nearest = 1e9;
  for (uint i = first_stroke[digit]; i < first_stroke[digit + 1]; ++i) {
    nearest = min(nearest, distance_to_segment(point, strokes[i].xy, strokes[i].zw));
  }
  return nearest;
}

// Coverage of the number's digits, `height` pixels high, centred.
float number_coverage(float height, float thickness) {
  float advance = 0.82;
  bool is_double = number >= 10u;
  vec2 point = from_centre / height + vec2(is_double ? 0.3 + 0.5 * advance : 0.3, 0.5);
  float nearest;
  if (is_double) {
    nearest = min(distance_to_digit(point, number / 10u),
                  distance_to_digit(point - vec2(advance, 0.0), number % 10u));
  } else {
    nearest = distance_to_digit(point, number);
  }
  return clamp(0.5 * thickness + 0.5 - nearest * height, 0.0, 1.0);
}

void main() {
  float unit = viewport.z;
  if (style == kFaceNumber) {
    float ink = number_coverage(number >= 10u ? 9.0 * unit : 10.0 * unit, 1.5 * unit);
    if (ink <= 0.0) {
      discard;
    }
    colour = vec4(has_option(kFilled) ? palette_text[shade].rgb : cage.rgb, 0.85 * ink);
    return;
  }

  uint band = style >= kValence ? style - kValence : 0u;
  bool has_digits = style != kIllegalVertex && number > 0u;
  float radius = (has_digits ? 7.5 : style == kIllegalVertex ? 5.0 : 3.0) * unit;
  float outside = length(from_centre) - radius;
  float dot_coverage = clamp(0.5 - outside, 0.0, 1.0);
  if (dot_coverage <= 0.0) {
    discard;
  }
  vec3 fill = style == kIllegalVertex ? illegal.rgb
              : style == kRelabelled  ? relabelled.rgb
              : style >= kValence     ? valences[band].rgb
                                      : srgb_from_linear(palette[shade].rgb);
  // A thin darker border sets the dot off from a surface of the same colour.
  vec3 shown = mix(fill, fill * 0.45, clamp(outside + 1.2 * unit + 0.5, 0.0, 1.0));
  if (has_digits) {
    vec3 ink = style == kRelabelled ? vec3(0.0)
               : style >= kValence  ? valence_text[band].rgb
                                    : palette_text[shade].rgb;
    float height = (number >= 10u ? 6.5 : 8.0) * unit;
    shown = mix(shown, ink, 0.9 * number_coverage(height, 1.25 * unit));
  }
  colour = vec4(shown, dot_coverage);
}
