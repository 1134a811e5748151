// A line between two points as a ribbon of constant width on the screen.

struct Ribbon {
  bool is_visible;  // false: all of it lies before the near plane
  vec4 a, b;        // its ends in clip space, cut at the near plane
  vec2 along;       // pixels, from a to b
  float size;       // its length
};

Ribbon make_ribbon(vec4 a, vec4 b) {
  Ribbon ribbon;
  // Cut at the near plane, beyond which directions on the screen make no sense.
  float a_inside = a.w - a.z;
  float b_inside = b.w - b.z;
  ribbon.is_visible = a_inside >= 0.0 || b_inside >= 0.0;
  if (a_inside < 0.0) {
    a = mix(a, b, a_inside / (a_inside - b_inside));
  } else if (b_inside < 0.0) {
    b = mix(b, a, b_inside / (b_inside - a_inside));
  }
  ribbon.a = a;
  ribbon.b = b;
  vec2 half_size = 0.5 * viewport.xy;
  ribbon.along = (b.xy / b.w - a.xy / a.w) * half_size;
  ribbon.size = length(ribbon.along);
  return ribbon;
}

// The clip-space z of a point as deep as one that lies nearer to the eye by `pixels`, so that the
// surface on either side of an edge does not cut into the ribbon along it.
float nearer_depth(vec4 point, float pixels) {
  float pixel = 2.0 * point.w / (viewport.y * projection[1][1]);
  float eye_z = is_perspective() ? -point.w : (point.z - projection[3][2]) / projection[2][2];
  eye_z += pixels * pixel;
  float z = projection[2][2] * eye_z + projection[3][2];
  float w = projection[2][3] * eye_z + projection[3][3];
  return w > 0.0 ? min(z / w, 1.0) * point.w : point.w;
}

// Of the six vertices of two triangles: whether a vertex stands at the second end, and on which
// side of the line.
bool is_at_second_end(uint part) { return part == 1 || part == 2 || part == 4; }
float side_of_line(uint part) { return part == 0 || part == 1 || part == 3 ? -1.0 : 1.0; }
