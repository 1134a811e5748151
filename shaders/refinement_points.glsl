// Where vertices lie. After refinement.glsl and refinement_pieces.glsl.
//
// A root that is not special is a bicubic B-spline patch, and so is what of a special one lies
// outside its pieces: there the points of every level are the tensor product of B-splines' weights,
// without the levels between.

// kRootPoints a root, then the pieces', relative to the last of their root's.
layout(std430, binding = 10) restrict readonly buffer PatchPoints { float patch_points[]; };
// For each level m = 0.., for each vertex 0..2^m of a segment of a cubic B-spline's control polygon
// that far down, the weights of the four points around the segment.
layout(std430, binding = 13) restrict readonly buffer Weights { vec4 weights[]; };

layout(std430, binding = 0) restrict writeonly buffer SurfacePositions {
  float surface_positions[];
};
layout(std430, binding = 4) restrict writeonly buffer VertexLevels { uint vertex_levels[]; };
layout(std430, binding = 5) restrict writeonly buffer SurfaceNormals { float surface_normals[]; };
layout(std430, binding = 14) restrict readonly buffer RingPoints { float ring_points[]; };
layout(std430, binding = 15) restrict readonly buffer Shares { float shares[]; };

const uint kWithLevels = 1u;
const uint kWithNormals = 2u;       // of the limit
const uint kWithLimitPoints = 4u;
layout(location = 5) uniform uint options;

struct Grid {
  uint first;   // point
  uint stride;  // from row to row
};

vec3 grid_point(Grid grid, uint column, uint row) {
  uint at = 3u * (grid.first + row * grid.stride + column);
  return vec3(patch_points[at], patch_points[at + 1], patch_points[at + 2]);
}

vec4 weights_at(uint level, uint i) { return weights[(1u << level) - 1u + level + i]; }

// Where a vertex of a root stands: level `depth` below it, `place` of 0..2^depth along and across.
struct Vertex {
  uint root;
  uint special;
  uint depth;
  uvec2 place;
};

// The same within a grid of 4 x 4 points.
struct GridVertex {
  Grid grid;
  uint depth;
  uvec2 place;
};

GridVertex in_grid(Vertex vertex) {
  if (vertex.special == kNone || vertex.depth == 0u) {
    return GridVertex(Grid(kRootPoints * vertex.root, 4u), vertex.depth, vertex.place);
  }
  Special special = special_at(vertex.special);
  uint r = 0u;
  uint piece = special.first_piece;
  uvec2 child;
  for (;; ++r) {
    child = min(vertex.place >> (vertex.depth - r - 1u), uvec2((2u << r) - 1u));
    uint next = r + 1u < vertex.depth && r + 1u < special.levels
                    ? piece_at(special, r + 1u, child.x, child.y)
                    : kNone;
    if (next == kNone) {
      break;
    }
    piece = next;
  }
  uint depth = vertex.depth - r - 1u;
  uvec2 side = child & 1u;
  Grid grid = Grid(first_point_of(piece) + kPieceSide * side.y + side.x, kPieceSide);
  return GridVertex(grid, depth, vertex.place - (child << depth));
}

vec3 tensor_product(Grid grid, vec4 along, vec4 across) {
  vec3 point = vec3(0.0);
  for (uint row = 0; row < 4; ++row) {
    point += across[row] * (along.x * grid_point(grid, 0u, row) + along.y * grid_point(grid, 1u, row) +
                            along.z * grid_point(grid, 2u, row) + along.w * grid_point(grid, 3u, row));
  }
  return point;
}

vec3 level_point(GridVertex at) {
  return tensor_product(at.grid, weights_at(at.depth, at.place.x),
                        weights_at(at.depth, at.place.y));
}

#ifdef WITH_LIMITS
// Where a vertex ends up, and the direction out of the surface there; 0 where it has no tangent
// plane.
struct Limit {
  vec3 point;
  vec3 normal;
};

vec3 unit_normal(vec3 along, vec3 across) {
  float sizes = length(along) * length(across);
  vec3 normal = cross(along, across);
  float size = length(normal);
  return size > 1e-6 * sizes ? normal / size : vec3(0.0);
}

// The segment of the B-spline surface at a place of the grid.
Limit limit_in_grid(GridVertex at) {
  vec2 t = vec2(at.place) / float(1u << at.depth);
  vec2 s = 1.0 - t;
  vec2 square = t * t;
  vec2 cube = square * t;
  vec2 a = s * s * s / 6.0;
  vec2 b = (3.0 * cube - 6.0 * square + 4.0) / 6.0;
  vec2 c = (-3.0 * cube + 3.0 * square + 3.0 * t + 1.0) / 6.0;
  vec2 d = cube / 6.0;
  vec2 da = -0.5 * s * s;
  vec2 db = 1.5 * square - 2.0 * t;
  vec2 dc = -1.5 * square + t + 0.5;
  vec2 dd = 0.5 * square;
  vec4 across = vec4(a.y, b.y, c.y, d.y);
  vec4 slope_across = vec4(da.y, db.y, dc.y, dd.y);
  Limit limit = Limit(vec3(0.0), vec3(0.0));
  vec3 tangent = vec3(0.0);
  vec3 other = vec3(0.0);
  for (uint row = 0; row < 4; ++row) {
    vec3 p = grid_point(at.grid, 0u, row);
    vec3 q = grid_point(at.grid, 1u, row);
    vec3 r = grid_point(at.grid, 2u, row);
    vec3 z = grid_point(at.grid, 3u, row);
    vec3 combined = a.x * p + b.x * q + c.x * r + d.x * z;
    limit.point += across[row] * combined;
    tangent += across[row] * (da.x * p + db.x * q + dc.x * r + dd.x * z);
    other += slope_across[row] * combined;
  }
  limit.normal = unit_normal(tangent, other);
  return limit;
}

vec3 ring_point(uint index) {
  return vec3(ring_points[3 * index], ring_points[3 * index + 1], ring_points[3 * index + 2]);
}

Limit limit_of_ring(Special special, uint corner) {
  uint first = special.first_ring_point + 3u * special.levels * uint(bitCount(special.rings)) +
               2u * rank_among(special.rings, corner);
  return Limit(ring_point(first), ring_point(first + 1u));
}

// Three points one level down, along a line and across.
mat3 refined(vec3 a, vec3 b, vec3 c) {
  return mat3(0.5 * (a + b), 0.125 * (a + c) + 0.75 * b, 0.5 * (b + c));
}

// On a side that is still sharp: the vertex is stepped down with the eight points around it until
// the side is smooth.
Limit limit_on_sharp_side(Special special, uint side, Vertex vertex, GridVertex at) {
  bool is_row = side == 0u || side == 2u;
  uint edge = is_row ? vertex.place.x : vertex.place.y;
  uvec2 along = is_row ? uvec2(1, 0) : uvec2(0, 1);
  mat3 lines[3];  // The side is line 1.
  for (uint i = 0; i < 3; ++i) {
    uvec2 place = at.place + i * along.yx;
    lines[i] = mat3(grid_point(at.grid, place.x, place.y),
                    grid_point(at.grid, place.x + along.x, place.y + along.y),
                    grid_point(at.grid, place.x + 2 * along.x, place.y + 2 * along.y));
  }
  for (uint level = vertex.depth; level < sharp_levels_of(special, side); ++level, edge *= 2u) {
    mat3 curve = refined(lines[1][0], lines[1][1], lines[1][2]);
    mat3 before = 0.5 * (lines[0] + lines[1]);
    mat3 on = 0.125 * (lines[0] + lines[2]) + 0.75 * lines[1];
    mat3 after = 0.5 * (lines[1] + lines[2]);
    lines[0] = refined(before[0], before[1], before[2]);
    lines[2] = refined(after[0], after[1], after[2]);
    on = refined(on[0], on[1], on[2]);
    lines[1] = mat3(mix(on[0], curve[0], shares[share_index(special, side, level, false, edge)]),
                    mix(on[1], curve[1], shares[share_index(special, side, level, true, edge)]),
                    mix(on[2], curve[2], shares[share_index(special, side, level, false, edge + 1u)]));
  }
  mat3 point = (lines[0] + 4.0 * lines[1] + lines[2]) / 6.0;
  mat3 slope = lines[2] - lines[0];
  vec3 tangent = point[2] - point[0];
  vec3 other = slope[0] + 4.0 * slope[1] + slope[2];
  return Limit((point[0] + 4.0 * point[1] + point[2]) / 6.0,
               is_row ? unit_normal(tangent, other) : unit_normal(other, tangent));
}

// `at` is the vertex in its grid.
Limit limit_of(Vertex vertex, GridVertex at) {
#ifndef INSIDE_NODES
  if (vertex.special != kNone) {
    Special special = special_at(vertex.special);
    uint last = 1u << vertex.depth;
    bvec4 is_on = bvec4(vertex.place.y == 0u, vertex.place.x == last, vertex.place.y == last,
                        vertex.place.x == 0u);
    uint corner = kNone;
    uint side = kNone;
    for (uint i = 0; i < 4; ++i) {
      if (is_on[i] && is_on[(i + 3) & 3u] && has(special.rings, i)) {
        corner = i;
      }
      if (is_on[i] && has(special.sharp, i) && vertex.depth < sharp_levels_of(special, i)) {
        side = i;
      }
    }
    if (corner != kNone) {
      return limit_of_ring(special, corner);
    }
    if (side != kNone) {
      return limit_on_sharp_side(special, side, vertex, at);
    }
  }
#endif
  return limit_in_grid(at);
}
#endif

void put_point(uint number, uint level, Vertex vertex) {
  GridVertex at = in_grid(vertex);
#ifdef WITH_LIMITS
  Limit limit = limit_of(vertex, at);
  vec3 point = (options & kWithLimitPoints) != 0u ? limit.point : level_point(at);
  if ((options & kWithNormals) != 0u) {
    surface_normals[3 * number] = limit.normal.x;
    surface_normals[3 * number + 1] = limit.normal.y;
    surface_normals[3 * number + 2] = limit.normal.z;
  }
#else
  vec3 point = level_point(at);
#endif
  point += grid_point(Grid(kRootPoints * vertex.root + 16u, 0u), 0u, 0u);
  surface_positions[3 * number] = point.x;
  surface_positions[3 * number + 1] = point.y;
  surface_positions[3 * number + 2] = point.z;
  if ((options & kWithLevels) != 0u) {
    vertex_levels[number] = level;
  }
}
