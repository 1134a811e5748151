// Which pieces of a special root there are (FlatSpecial in subdivision/flat_plan.h). After
// refinement.glsl.

struct Special {
  uint first_piece;
  uint root;
  uint levels;
  uint corners;  // bits
  uint rings;
  uint before;
  uint after;
  uint curves;
  uint sharp;
  uint first_ring_point;
  uvec4 shares;
  uint sharp_levels;  // 8 bits a side
};

struct PackedSpecial {
  uvec4 head;  // first piece, bits, root, first ring point
  uvec4 shares;
  uvec4 tail;  // sharp levels
};
layout(std430, binding = 11) restrict readonly buffer Specials { PackedSpecial specials[]; };

const uint kPieceSide = 5;  // points of a piece one level down, ring included
const uint kPiecePoints = kPieceSide * kPieceSide;

// Pieces' points come after the roots'.
const uint kRootPoints = 17;  // 4 x 4, and what all are relative to
uint first_point_of(uint piece) { return kRootPoints * root_count + kPiecePoints * piece; }

Special special_at(uint index) {
  PackedSpecial words = specials[index];
  Special special;
  special.first_piece = words.head.x;
  uint bits = words.head.y;
  special.levels = bits & 15u;
  special.corners = bits >> 4 & 15u;
  special.rings = bits >> 8 & 15u;
  special.before = bits >> 12 & 15u;
  special.after = bits >> 16 & 15u;
  special.curves = bits >> 20 & 15u;
  special.sharp = bits >> 24 & 15u;
  special.root = words.head.z;
  special.first_ring_point = words.head.w;
  special.shares = words.shares;
  special.sharp_levels = words.tail.x;
  return special;
}

uint sharp_levels_of(Special special, uint side) { return special.sharp_levels >> (8u * side) & 255u; }

// Where the share of a crease's rule stands (FlatPlan::shares) that a point of a sharp side takes at
// a level below the root: vertex `at`, or the middle of edge `at` - 1.
uint share_index(Special special, uint side, uint level, bool is_vertex, uint at) {
  const uint kEvenShares = 0x80000000u;
  uint first = special.shares[side];
  if ((first & kEvenShares) != 0u) {
    return (first & ~kEvenShares) + 2u * level + uint(is_vertex);
  }
  first += 2u * ((1u << level) - 1u) + 3u * level;
  return is_vertex ? first + (1u << level) + 2u + at : first + at;
}

// Levels that have pieces along sides.
uint side_levels(Special special) {
  uint most = 0u;
  for (uint side = 0; side < 4; ++side) {
    most = max(most, sharp_levels_of(special, side));
  }
  return min(most, special.levels);
}

uint rank_among(uint bits, uint i) { return uint(bitCount(bits & ((1u << i) - 1u))); }

// The piece of a level r below the root at a column and row; kNone: that node is none.
uint piece_at(Special special, uint r, uint column, uint row) {
  if (r == 0u) {
    return special.first_piece;
  }
  uint last = (1u << r) - 1u;
  uint corner_count = uint(bitCount(special.corners));
  uint sides_from = side_levels(special);
  // Sides have 2^q - 2 pieces at level q.
  uint q = min(r, sides_from);
  uint before = q < 1u ? 0u : uint(bitCount(special.sharp)) * ((1u << q) - 2u * q);
  uint first = special.first_piece + 1u + (r - 1u) * corner_count + before;
  bool is_left = column == 0u;
  bool is_right = column == last;
  bool is_low = row == 0u;
  bool is_high = row == last;
  if ((is_left || is_right) && (is_low || is_high)) {
    uint corner = is_low ? (is_left ? 0u : 1u) : (is_left ? 3u : 2u);
    return has(special.corners, corner) ? first + rank_among(special.corners, corner) : kNone;
  }
  if (r >= sides_from || !(is_left || is_right || is_low || is_high)) {
    return kNone;
  }
  uint side = is_low ? 0u : is_right ? 1u : is_high ? 2u : 3u;
  if (!has(special.sharp, side)) {
    return kNone;
  }
  uint along = side == 0u || side == 2u ? column : row;
  return first + corner_count + rank_among(special.sharp, side) * ((1u << r) - 2u) + along - 1u;
}
