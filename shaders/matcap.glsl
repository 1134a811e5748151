// Materials whose look depends on nothing but where the surface faces as seen from the eye: what
// others keep as a picture of a lit ball (a matcap) is a formula here. Linear RGB.

// The normal as on that ball: x to the right, y up, z towards the eye. Relative to the line of sight
// and not to the image, so that a plane in perspective looks flat.
vec3 facing(vec3 normal, vec3 to_eye) {
  vec3 right = normalize(vec3(to_eye.z, 0.0, -to_eye.x));
  return vec3(dot(normal, right), dot(normal, cross(to_eye, right)), dot(normal, to_eye));
}

// Where the eye looks once mirrored.
vec3 mirrored(vec3 m) { return vec3(2.0 * m.z * m.xy, 2.0 * m.z * m.z - 1.0); }

// A lit window far away: 1 inside its rectangle around a direction, soft at the rim.
float window(vec3 ray, vec3 towards, vec2 half_size, float softness) {
  vec3 right = normalize(cross(vec3(0.0, 1.0, 0.0), towards));
  vec2 at = vec2(dot(ray, right), dot(ray, cross(towards, right)));
  vec2 inside = 1.0 - smoothstep(half_size - softness, half_size + softness, abs(at));
  return dot(ray, towards) > 0.0 ? inside.x * inside.y : 0.0;
}

// Light that wraps around the terminator by `wrap`.
float wrapped(vec3 m, vec3 towards, float wrap) {
  return max((dot(m, towards) + wrap) / (1.0 + wrap), 0.0);
}

// Soft, warm where light passes through, darker where it turns away: no edge is ever lost in black.
vec3 clay(vec3 base, vec3 m) {
  float key = wrapped(m, vec3(-0.46, 0.66, 0.59), 0.35);
  float fill = wrapped(m, vec3(0.80, -0.10, 0.59), 0.5);
  vec3 warm = mix(vec3(1.0, 0.62, 0.48), vec3(1.0), smoothstep(0.0, 0.55, key));
  vec3 shaded = base * (0.18 + 0.86 * key * warm + 0.17 * fill * vec3(0.86, 0.92, 1.0));
  float turned_away = 1.0 - smoothstep(0.0, 0.45, m.z);
  float sheen = pow(max(dot(mirrored(m), vec3(-0.46, 0.66, 0.59)), 0.0), 9.0);
  return shaded * (1.0 - 0.42 * turned_away) + 0.05 * sheen;
}

// Little light from the front, much from behind on both sides: cool on the left, warm on the right.
vec3 stone(vec3 base, vec3 m) {
  float key = wrapped(m, vec3(-0.40, 0.72, 0.57), 0.2);
  float edge = pow(1.0 - clamp(m.z, 0.0, 1.0), 2.2);
  float left = edge * smoothstep(-0.2, 0.9, dot(m.xy, normalize(vec2(-0.85, 0.5))));
  float right = edge * smoothstep(-0.2, 0.9, dot(m.xy, normalize(vec2(0.95, 0.2))));
  float gloss = pow(max(dot(mirrored(m), normalize(vec3(-0.40, 0.72, 0.57))), 0.0), 14.0);
  return base * (0.30 + 0.85 * key) + gloss * vec3(0.10) +
         left * (0.15 + 0.5 * base) * vec3(0.75, 0.88, 1.1) +
         right * (0.10 + 0.4 * base) * vec3(1.1, 0.86, 0.68);
}

// Two windows and a horizon mirrored in polish over the body's own colour; more at grazing angles.
vec3 polish(vec3 base, vec3 m) {
  vec3 ray = mirrored(m);
  float key = wrapped(m, vec3(-0.42, 0.62, 0.66), 0.25);
  vec3 body = base * (0.20 + 0.62 * key + 0.14 * wrapped(m, vec3(0.7, -0.4, 0.59), 0.4));
  float horizon = smoothstep(-0.10, 0.12, ray.y);
  vec3 room = mix(vec3(0.10, 0.095, 0.09), mix(vec3(0.75, 0.80, 0.86), vec3(0.42, 0.50, 0.62),
                  smoothstep(0.0, 0.9, ray.y)), horizon);
  float fresnel = 0.06 + 0.80 * pow(1.0 - clamp(m.z, 0.0, 1.0), 4.0);
  float windows = window(ray, normalize(vec3(-0.62, 0.58, 0.52)), vec2(0.24, 0.30), 0.05) +
                  0.45 * window(ray, normalize(vec3(0.82, 0.20, 0.52)), vec2(0.12, 0.34), 0.05);
  return body + fresnel * room + windows * vec3(0.85, 0.88, 0.92) * (0.45 + 0.55 * fresnel);
}

vec3 matcap(int kind, vec3 base, vec3 m) {
  return kind == kClay ? clay(base, m) : kind == kDark ? stone(base, m) : polish(base, m);
}
