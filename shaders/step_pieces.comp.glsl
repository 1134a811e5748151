#version 450
// One level of the pieces of special roots: of each the points one level down, ring included, one
// invocation each. First a tensor-product step as if everything were regular, then sides of their
// own rule, then corners of their own ring, and beyond curves what mirrors these.
//
// Item i / 25 is corner k mod 4 of special root k / 4; or, of a level's pieces along sharp sides,
// number k mod 2^level of sharp side k / 2^level.

#include "refinement.glsl"
#include "refinement_pieces.glsl"

layout(location = 6) uniform uint level;        // below the root
layout(location = 7) uniform uint along_sides;  // whether items are those of sides

layout(std430, binding = 6) restrict readonly buffer SharpSides { uvec2 sharp_sides[]; };
layout(std430, binding = 10) restrict buffer PatchPoints { float patch_points[]; };
layout(std430, binding = 14) restrict readonly buffer RingPoints { float ring_points[]; };
layout(std430, binding = 15) restrict readonly buffer Shares { float shares[]; };

struct Piece {
  Special special;
  uvec2 place;        // among the level's nodes
  uint first;         // of the 4 x 4 points of the level before
  uint stride;
  bvec4 is_on;        // which of the root's sides it lies on
};

vec3 grid_point(Piece piece, uvec2 at) {
  uint i = 3u * (piece.first + at.y * piece.stride + at.x);
  return vec3(patch_points[i], patch_points[i + 1], patch_points[i + 2]);
}

vec3 ring_point(uint i) {
  return vec3(ring_points[3 * i], ring_points[3 * i + 1], ring_points[3 * i + 2]);
}

// The weights of the points i / 2.. of a line that point i of 0..4 one level down has: it is the
// middle of an edge, or a vertex.
vec3 line_weights(uint i) {
  return (i & 1u) == 0u ? vec3(0.5, 0.5, 0.0) : vec3(0.125, 0.75, 0.125);
}

vec3 smooth_point(Piece piece, uvec2 at) {
  uvec2 first = at >> 1u;
  vec3 along = line_weights(at.x);
  vec3 across = line_weights(at.y);
  // An edge's third weight is 0, and beyond the last edge there is no point.
  uvec2 last = min(first + 2u, uvec2(3u));
  vec3 point = vec3(0.0);
  for (uint row = 0; row < 3; ++row) {
    uint y = min(first.y + row, last.y);
    point += across[row] * (along.x * grid_point(piece, uvec2(first.x, y)) +
                            along.y * grid_point(piece, uvec2(first.x + 1u, y)) +
                            along.z * grid_point(piece, uvec2(last.x, y)));
  }
  return point;
}

// Point i of the line that side `side` makes in the grid, as on a curve of its own.
vec3 curve_point(Piece piece, uint side, uint i) {
  bool is_row = side == 0u || side == 2u;
  uint line = side == 1u || side == 2u ? 2u : 1u;
  vec3 weights = line_weights(i);
  vec3 point = vec3(0.0);
  for (uint k = 0; k < 3; ++k) {
    uint along = min((i >> 1) + k, 3u);
    point += weights[k] * grid_point(piece, is_row ? uvec2(along, line) : uvec2(line, along));
  }
  return point;
}

// The piece's sides and corners among its 5 x 5 points.
bool is_on_line(uint side, uvec2 at) {
  return side == 0u ? at.y == 1u : side == 1u ? at.x == 3u : side == 2u ? at.y == 3u : at.x == 1u;
}

// What a ring says of a point: the number of its centre, or of an edge; kNone: nothing.
uint ring_point_at(Piece piece, uvec2 at) {
  const uvec2 kCorners[4] = uvec2[](uvec2(1, 1), uvec2(3, 1), uvec2(3, 3), uvec2(1, 3));
  const uvec2 kBefore[4] = uvec2[](uvec2(1, 0), uvec2(4, 1), uvec2(3, 4), uvec2(0, 3));
  const uvec2 kAfter[4] = uvec2[](uvec2(0, 1), uvec2(3, 0), uvec2(4, 3), uvec2(1, 4));
  Special special = piece.special;
  for (uint i = 0; i < 4; ++i) {
    if (piece.is_on[i] && piece.is_on[(i + 3) & 3u] && has(special.rings, i)) {
      uint first = special.first_ring_point +
                   3u * (rank_among(special.rings, i) * special.levels + level);
      if (at == kCorners[i]) {
        return first;
      }
      if (at == kBefore[i] && has(special.before, i)) {
        return first + 1u;
      }
      if (at == kAfter[i] && has(special.after, i)) {
        return first + 2u;
      }
    }
  }
  return kNone;
}

vec3 point_of(Piece piece, uvec2 at) {
  uint ring = ring_point_at(piece, at);
  if (ring != kNone) {
    return ring_point(ring);
  }
  vec3 point = smooth_point(piece, at);
  uint sharp = kNone;
  for (uint side = 0; side < 4; ++side) {
    if (piece.is_on[side] && has(piece.special.sharp, side) &&
        level < sharp_levels_of(piece.special, side) && is_on_line(side, at)) {
      sharp = side;
    }
  }
  if (sharp == kNone) {
    return point;
  }
  bool is_row = sharp == 0u || sharp == 2u;
  uint i = is_row ? at.x : at.y;
  uint edge = is_row ? piece.place.x : piece.place.y;
  uint share = share_index(piece.special, sharp, level, (i & 1u) == 1u, edge + (i >> 1));
  return mix(point, curve_point(piece, sharp, i), shares[share]);
}

// Where a point is mirrored from, along one axis: twice the first, less the second.
uvec2 mirrored(uint i, bool is_low, bool is_high) {
  return i == 0u && is_low ? uvec2(1, 2) : i == 4u && is_high ? uvec2(3, 2) : uvec2(i);
}

vec3 mirrored_point(Piece piece, uvec2 at) {
  uint curves = piece.special.curves;
  uvec2 x = mirrored(at.x, piece.is_on.w && has(curves, 3), piece.is_on.y && has(curves, 1));
  uvec2 y = mirrored(at.y, piece.is_on.x && has(curves, 0), piece.is_on.z && has(curves, 2));
  bool is_mirrored = x.x != x.y || y.x != y.y;
  vec3 point = vec3(0.0);
  for (uint i = 0; i < (is_mirrored ? 4u : 1u); ++i) {
    uint column = i & 1u;
    uint row = i >> 1;
    float weight =
        is_mirrored ? (column == 0u ? 2.0 : -1.0) * (row == 0u ? 2.0 : -1.0) : 1.0;
    point += weight * point_of(piece, uvec2(x[column], y[row]));
  }
  return point;
}

void main() {
  uint index = item_index();
  if (index >= item_count) {
    return;
  }
  uint item = index / kPiecePoints;
  uint number = index - item * kPiecePoints;
  uint last = (1u << level) - 1u;
  Piece piece;
  uint special_index;
  if (along_sides != 0u) {
    uvec2 sharp_side = sharp_sides[item >> level];
    special_index = sharp_side.x;
    uint along = item & last;
    if (along == 0u || along == last) {
      return;  // The corners' own.
    }
    piece.place = sharp_side.y == 0u   ? uvec2(along, 0u)
                  : sharp_side.y == 1u ? uvec2(last, along)
                  : sharp_side.y == 2u ? uvec2(along, last)
                                       : uvec2(0u, along);
  } else {
    special_index = item >> 2;
    uint corner = item & 3u;
    piece.place = uvec2(corner == 1u || corner == 2u ? last : 0u, corner >= 2u ? last : 0u);
    if (level == 0u && corner > 0u) {
      return;  // The root is one piece.
    }
  }
  piece.special = special_at(special_index);
  uint piece_index = level < piece.special.levels
                         ? piece_at(piece.special, level, piece.place.x, piece.place.y)
                         : kNone;
  if (piece_index == kNone) {
    return;
  }
  piece.first = kRootPoints * piece.special.root;
  piece.stride = 4u;
  if (level > 0u) {
    uint parent = piece_at(piece.special, level - 1u, piece.place.x >> 1, piece.place.y >> 1);
    uvec2 child = piece.place & 1u;
    piece.first = first_point_of(parent) + kPieceSide * child.y + child.x;
    piece.stride = kPieceSide;
  }
  piece.is_on = bvec4(piece.place.y == 0u, piece.place.x == last, piece.place.y == last,
                      piece.place.x == 0u);
  uint row = number / kPieceSide;
  vec3 point = mirrored_point(piece, uvec2(number - row * kPieceSide, row));
  uint at = 3u * (first_point_of(piece_index) + number);
  patch_points[at] = point.x;
  patch_points[at + 1] = point.y;
  patch_points[at + 2] = point.z;
}
