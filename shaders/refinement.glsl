// Nodes of the quadtrees that refinements are made of (subdivision/flat_plan.h), and where quads go.
// Every dispatch is a list of items, one invocation each.

layout(local_size_x = 64) in;

layout(location = 0) uniform uint item_count;
layout(location = 2) uniform uint root_count;

// Groups are dispatched in rows.
uint item_index() {
  return (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * gl_WorkGroupSize.x +
         gl_LocalInvocationIndex;
}

const uint kNone = 0xFFFFFFFFu;

struct Node {
  uint labels;  // 4 bits each
  uint level;
  uint root_level;
  uint column;  // among the root's nodes of its level
  uint row;
  uint owned_corners;  // bits
  uint owned_sides;
  uint lifted_sides;
  uint falling_sides;  // whose numbers fall from corner to corner
  uint root;
  uint special;
  uint control_face;
  uvec4 corners;
  uvec4 sides;  // first numbers
  uint inside;
  uint quad;
};

struct PackedNode {
  uvec4 head;  // bits, place, root, control face
  uvec4 corners;
  uvec4 sides;
  uvec4 tail;  // inside, quad, special, unused
};

Node unpack_node(PackedNode words) {
  Node node;
  uint bits = words.head.x;
  node.labels = bits & 0xFFFFu;
  node.level = bits >> 16 & 15u;
  node.owned_corners = bits >> 20 & 15u;
  node.owned_sides = bits >> 24 & 15u;
  node.lifted_sides = bits >> 28;
  uint place = words.head.y;
  node.falling_sides = place & 15u;
  node.root_level = place >> 4 & 15u;
  node.column = place >> 8 & 0xFFFu;
  node.row = place >> 20;
  node.root = words.head.z;
  node.control_face = words.head.w;
  node.corners = words.corners;
  node.sides = words.sides;
  node.inside = words.tail.x;
  node.quad = words.tail.y;
  node.special = words.tail.z;
  return node;
}

PackedNode pack_node(Node node) {
  PackedNode words;
  words.head = uvec4(node.labels | node.level << 16 | node.owned_corners << 20 |
                          node.owned_sides << 24 | node.lifted_sides << 28,
                      node.falling_sides | node.root_level << 4 | node.column << 8 | node.row << 20,
                      node.root, node.control_face);
  words.corners = node.corners;
  words.sides = node.sides;
  words.tail = uvec4(node.inside, node.quad, node.special, 0u);
  return words;
}

bool has(uint bits, uint i) { return (bits >> i & 1u) != 0u; }

// The number of vertex i inside side `side`, counted from corner `side` on.
uint on_side(Node node, uint side, uint i) {
  return has(node.falling_sides, side) ? node.sides[side] - i : node.sides[side] + i;
}
