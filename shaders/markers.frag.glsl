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
const uint kCandidate = 8u;
const uint kPicked = 9u;

const uint kPairText = 0u;
const uint kNegativeText = 2u;
const uint kBecomesText = 3u;

in vec2 from_centre;
flat in uint number;
flat in uint shade;
flat in uint style;
flat in uint second;
flat in uint text;

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

// What a pill says, glyph by glyph: 0..9, then a point, a minus, a stroke and an arrow's head.
const uint kPoint = 10u;
const uint kMinus = 11u;
const uint kStroke = 12u;
const uint kHead = 13u;

struct Words {
  uint glyphs[6];
  int count;
};

void put(inout Words words, uint glyph) {
  words.glyphs[words.count] = glyph;
  ++words.count;
}
void put_number(inout Words words, uint value) {
  if (value >= 10u) {
    put(words, value / 10u);
  }
  put(words, value % 10u);
}
Words words_of_pill() {
  Words words;
  words.count = 0;
  if (text == kNegativeText) {
    put(words, kMinus);
  }
  put_number(words, number);
  put(words, text == kPairText ? kStroke : text == kBecomesText ? kHead : kPoint);
  put_number(words, second);
  return words;
}

float advance_of(uint glyph) { return glyph < 10u ? 0.82 : glyph == kPoint ? 0.42 : 0.72; }

float distance_to_glyph(vec2 point, uint glyph) {
  if (glyph < 10u) {
    return distance_to_digit(point, glyph);
  }
  if (glyph == kHead) {
    return min(distance_to_segment(point, vec2(0.08, 0.78), vec2(0.42, 0.48)),
               distance_to_segment(point, vec2(0.42, 0.48), vec2(0.08, 0.18)));
  }
  return glyph == kPoint   ? distance(point, vec2(0.1, 0.04))
         : glyph == kMinus ? distance_to_segment(point, vec2(0.04, 0.48), vec2(0.46, 0.48))
                           : distance_to_segment(point, vec2(0.04, -0.06), vec2(0.46, 1.06));
}

vec4 pill(float unit) {
  Words words = words_of_pill();
  float height = 9.0 * unit;
  float width = -0.22;
  for (int i = 0; i < words.count; ++i) {
    width += advance_of(words.glyphs[i]);
  }
  vec2 half_size = vec2(0.5 * width * height + 5.5 * unit, 8.5 * unit);
  float corner = half_size.y;
  vec2 beyond = max(abs(from_centre) - half_size + corner, vec2(0.0));
  float outside = length(beyond) - corner;
  bool is_picked = style == kPicked;
  float ring = is_picked ? 3.0 * unit : 0.0;
  float coverage = clamp(0.5 - outside + ring, 0.0, 1.0);
  if (coverage <= 0.0) {
    discard;
  }
  vec3 fill = is_picked ? relabelled.rgb : illegal.rgb;
  vec3 ink = is_picked ? vec3(0.0) : vec3(1.0);
  vec3 shown = mix(fill, fill * 0.45, clamp(outside + 1.2 * unit + 0.5, 0.0, 1.0));
  // A ring of light around the picked one, with a dark gap.
  shown = mix(shown, vec3(1.0), is_picked ? clamp(outside - unit + 0.5, 0.0, 1.0) : 0.0);
  vec2 point = from_centre / height + vec2(0.5 * width, 0.5);
  float nearest = 1e9;
  for (int i = 0; i < words.count; ++i) {
    nearest = min(nearest, distance_to_glyph(point, words.glyphs[i]));
    point.x -= advance_of(words.glyphs[i]);
  }
  float stroke = clamp(0.5 * 1.35 * unit + 0.5 - nearest * height, 0.0, 1.0);
  return vec4(mix(shown, ink, 0.95 * stroke), coverage);
}

void main() {
  float unit = viewport.z;
  if (style >= kCandidate) {
    colour = pill(unit);
    return;
  }
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
