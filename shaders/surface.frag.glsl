#version 450
// Depth colours under a light fixed to the camera or as a matcap, then wireframe, hatching and highlight over them.
// Light is computed in linear RGB; what lies over it is mixed in sRGB, as a painter would.

#include "frame.glsl"
#include "matcap.glsl"

in vec3 eye_position;
in vec3 smooth_normal;
flat in vec3 flat_normal;
in vec4 edge_distances;
flat in uint face_state;

layout(location = 0) out vec4 colour;

// Directions towards the lights, in eye space: key over the left shoulder, fill from the right.
const vec3 kKey = vec3(-0.4499, 0.5849, 0.6749);
const vec3 kFill = vec3(0.7960, -0.0995, 0.5970);

vec3 lit(vec3 base, vec3 normal, vec3 to_eye) {
  float key = max(dot(normal, kKey), 0.0);
  float fill = max(dot(normal, kFill), 0.0);
  float sky = 0.5 + 0.5 * normal.y;
  vec3 shaded = base * (0.27 + 0.12 * sky + 0.70 * key + 0.16 * fill);
  float rim = pow(1.0 - max(dot(normal, to_eye), 0.0), 3.0);
  float gloss = pow(max(dot(normal, normalize(kKey + to_eye)), 0.0), 40.0);
  return shaded + rim * 0.10 * (0.35 + base) + gloss * 0.035;
}

// Pixels from here to each of the face's edges.
vec4 pixels_to_edges() {
  vec4 along_x = dFdx(edge_distances);
  vec4 along_y = dFdy(edge_distances);
  return edge_distances / max(sqrt(along_x * along_x + along_y * along_y), vec4(1e-30));
}

float line(float pixels, float width) { return clamp(0.5 * width + 0.5 - pixels, 0.0, 1.0); }

void main() {
  uint depth = face_state & 0xFFu;
  uint level = face_state >> 8 & 0xFFu;
  bool is_highlighted = (face_state >> 16 & 1u) != 0;
  bool is_illegal = (face_state >> 17 & 1u) != 0;
  uint sides = face_state >> 18 & 7u;

  vec3 base = palette[0].rgb;
  if (has_option(kColourByDepth)) {
    base = palette[min(depth, 7u)].rgb;
  } else if (has_option(kColourByLevel)) {
    base = palette[min(level, 7u)].rgb;
  } else if (has_option(kColourByDistance)) {
    float place = float(depth) * (7.0 / 255.0);
    uint below = min(uint(place), 6u);
    base = mix(palette[below].rgb, palette[below + 1u].rgb, place - float(below));
  }

  vec3 normal = normalize(has_option(kSmoothNormals) ? smooth_normal : flat_normal);
  if (!gl_FrontFacing) {
    // The inside of an open mesh: greyer and darker, so that it is not taken for the outside.
    normal = -normal;
    base = mix(base, vec3(dot(base, vec3(0.2126, 0.7152, 0.0722))), 0.5) * 0.55;
  }
  vec3 to_eye = is_perspective() ? normalize(-eye_position) : vec3(0.0, 0.0, 1.0);
  vec3 light = !has_option(kLit) ? base
               : material() == kStudio ? lit(base, normal, to_eye)
                                       : matcap(material(), base, facing(normal, to_eye));
  vec3 shown = srgb_from_linear(light);

  vec4 pixels = pixels_to_edges();
  float nearest = min(min(pixels.x, pixels.y), min(pixels.z, pixels.w));
  float unit = viewport.z;

  if (is_illegal && has_option(kShowIllegal)) {
    float period = 9.0 * unit;
    float across = (gl_FragCoord.x + gl_FragCoord.y) * 0.70711;
    float from_stripe = abs(fract(across / period) - 0.5) * period;
    shown = mix(shown, illegal.rgb, 0.12);
    shown = mix(shown, illegal.rgb, 0.85 * clamp(1.5 * unit + 0.5 - from_stripe, 0.0, 1.0));
  }
  if (!has_option(kFilled)) {
    // Edges alone, through which one sees the others: the alpha becomes coverage.
    float ink = has_option(kWireframe) ? line(nearest, 1.2 * unit) : 0.0;
    if (ink <= 0.0) {
      discard;
    }
    colour = vec4(is_highlighted ? accent.rgb : cage.rgb, ink);
    return;
  }
  if (is_highlighted) {
    shown = mix(shown, vec3(1.0), 0.24);
  }
  float narrow = sides == 4 ? min(pixels.x + pixels.z, pixels.y + pixels.w)
                            : pixels.x + pixels.y + pixels.z;
  if (has_option(kWireframe)) {
    // Faces a few pixels wide would drown in their own edges: theirs grow fainter.
    float strength = sides > 4 ? 1.0 : mix(0.3, 1.0, smoothstep(1.5 * unit, 6.0 * unit, narrow));
    // Black is not seen on the darkest depths, where the edges matter most: there they are light.
    float brightness = dot(shown, vec3(0.299, 0.587, 0.114));
    vec4 ink = mix(vec4(1.0, 1.0, 1.0, 0.28), wire, smoothstep(0.2, 0.3, brightness));
    shown = mix(shown, ink.rgb, ink.a * strength * line(nearest, unit));
  }
  if (is_highlighted) {
    // Likewise: where the faces are small, a tint says what the edges say elsewhere.
    float edges = sides > 4 ? 1.0 : smoothstep(5.0 * unit, 18.0 * unit, narrow);
    shown = mix(shown, accent.rgb, 0.22 * (1.0 - edges));
    shown = mix(shown, accent.rgb, 0.9 * edges * line(nearest, 2.5 * unit));
  }
  colour = vec4(shown, 1.0);
}
