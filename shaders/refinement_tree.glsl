// How nodes have children, and which node is the i-th of a kind. After refinement.glsl.
//
// Everything below a node is numbered by its labels alone, so any node is found by going down from
// its root, past the siblings before it, without a look at any other node.

layout(location = 1) uniform uint label_count;  // labels are smaller

// For each quadruple of labels: quads, vertices inside, nodes of kinds 0..6. Then for each pair
// vertices on an edge.
layout(std430, binding = 8) restrict readonly buffer SubtreeCounts { uint subtree_counts[]; };
// For each kind of node, for each root: nodes in the roots before.
layout(std430, binding = 9) restrict readonly buffer FirstNodes { uint first_nodes[]; };
layout(std430, binding = 6) restrict readonly buffer Roots { PackedNode roots[]; };

const uint kKinds = 7;
const uint kInnerKind = 0;  // split, or a Y-element; kind a > 0: uniform of label a
const uint kQuads = 0;
const uint kInside = 1;
const uint kNodes = 2;
const uint kSubtreeSize = kNodes + kKinds;

uint label_at(uint labels, uint i) { return labels >> (4u * i) & 15u; }
uint lowered(uint label) { return max(label, 1u) - 1u; }
uint edge_point_label(uint a, uint b) { return lowered(min(a, b)); }
uint least_positive(uint a, uint b) { return a == 0u || b == 0u ? max(a, b) : min(a, b); }

uint subtree(uint labels) {
  uint index = ((label_at(labels, 0) * label_count + label_at(labels, 1)) * label_count +
                label_at(labels, 2)) * label_count + label_at(labels, 3);
  return index * kSubtreeSize;
}

uint edge_count(uint a, uint b) {
  uint square = label_count * label_count;
  return subtree_counts[square * square * kSubtreeSize + a * label_count + b];
}

// What the sides and the face point of a node turn into.
struct Midpoints {
  uvec4 labels;
  uvec4 vertices;  // kNone: the side is not split
  uvec4 inner;     // vertices between the midpoint and the centre
  uint centre_label;
};

uint face_point_label(uint labels) {
  uint label = 0u;
  for (uint i = 0; i < 4; ++i) {
    label = least_positive(label,
                           edge_point_label(label_at(labels, i), label_at(labels, (i + 1) & 3u)));
  }
  return label;
}

Midpoints midpoints_of(Node node) {
  Midpoints middles;
  middles.centre_label = face_point_label(node.labels);
  for (uint i = 0; i < 4; ++i) {
    uint a = label_at(node.labels, i);
    uint b = label_at(node.labels, (i + 1) & 3u);
    middles.labels[i] = edge_point_label(a, b);
    middles.vertices[i] =
        max(a, b) == 0u ? kNone : on_side(node, i, edge_count(lowered(a), middles.labels[i]));
    middles.inner[i] = edge_count(middles.labels[i], middles.centre_label);
  }
  return middles;
}

uint child_labels(Node node, Midpoints middles, uint i) {
  uint before = (i + 3) & 3u;
  return lowered(label_at(node.labels, i)) << (4u * i) |
         middles.labels[i] << (4u * ((i + 1) & 3u)) |
         middles.centre_label << (4u * ((i + 2) & 3u)) | middles.labels[before] << (4u * before);
}

// The one positive corner of a Y-element; kNone: the node is none.
uint y_corner(Node node) {
  uint count = 0u;
  uint corner = 0u;
  for (uint i = 0; i < 4; ++i) {
    if (label_at(node.labels, i) > 0u) {
      ++count;
      corner = i;
    }
  }
  return count == 1u ? corner : kNone;
}

bool is_uniform(uint labels) {
  uint label = labels & 15u;
  return labels == label * 0x1111u && label <= 6u;
}

// What all children of a node have; `inside` and `quad` are the numbers where the child's begin.
Node begin_child(Node node, Midpoints middles, uint i, uint inside, uint quad) {
  uint after = (i + 1) & 3u;
  uint opposite = (i + 2) & 3u;
  uint before = (i + 3) & 3u;
  Node child = node;
  child.labels = child_labels(node, middles, i);
  child.level = node.level + 1;
  child.column = 2 * node.column + uint(i == 1 || i == 2);
  child.row = 2 * node.row + uint(i >= 2);
  child.corners[after] = middles.vertices[i];
  child.corners[opposite] = node.inside;
  child.corners[before] = middles.vertices[before];
  child.sides[i] = node.sides[i];
  uint first_half = edge_count(lowered(label_at(node.labels, before)), middles.labels[before]);
  child.sides[before] = on_side(node, before, first_half + 1);
  child.falling_sides = node.falling_sides & (1u << i | 1u << before);
  child.owned_sides = node.owned_sides & (1u << i | 1u << before);
  child.owned_corners = 0u;
  child.lifted_sides = 0u;
  child.inside = inside;
  child.quad = quad;
  return child;
}

// Whether the face point of a node of these labels makes the middle of a side with these move again.
bool lifts(uint labels, uint middle_label, uint centre_label) {
  return max(middle_label, centre_label) == 1u && face_point_label(labels) > 0u;
}

// Whether the edge from the middle of side i to the centre is written by child i + 1, not child i.
bool is_inner_of_second(Node node, Midpoints middles, uint i) {
  return lifts(child_labels(node, middles, (i + 1) & 3u), middles.labels[i], middles.centre_label) &&
         !lifts(child_labels(node, middles, i), middles.labels[i], middles.centre_label);
}

// Who writes the middle of side i, which the node owns: a node of a positive corner beside it goes
// on moving it.
bool goes_with_first(Node node, uint i) {
  return label_at(node.labels, i) > 1u || has(node.lifted_sides, i);
}
bool goes_with_second(Node node, uint i) {
  return !goes_with_first(node, i) && label_at(node.labels, (i + 1) & 3u) > 1u;
}

// Child i of a node that splits.
Node split_child(Node node, Midpoints middles, uint i, uint inside, uint quad) {
  Node child = begin_child(node, middles, i, inside, quad);
  uint after = (i + 1) & 3u;
  uint opposite = (i + 2) & 3u;
  uint before = (i + 3) & 3u;
  uint inner = node.inside + 1;
  uint inner_before = inner;
  for (uint k = 0; k < 4; ++k) {
    inner += k < i ? middles.inner[k] : 0u;
    inner_before += k < before ? middles.inner[k] : 0u;
  }
  child.sides[after] = inner;
  child.sides[opposite] = inner_before + middles.inner[before] - 1;
  child.falling_sides |= 1u << opposite;

  if (!is_inner_of_second(node, middles, i)) {
    child.owned_sides |= 1u << after;
    child.lifted_sides |= uint(lifts(child.labels, middles.labels[i], middles.centre_label)) << after;
  }
  if (is_inner_of_second(node, middles, before)) {
    child.owned_sides |= 1u << opposite;
    child.lifted_sides |= 1u << opposite;
  }
  if (label_at(node.labels, i) > 1u) {
    child.owned_corners |= node.owned_corners & 1u << i;
  }
  if (has(node.owned_sides, i) && goes_with_first(node, i)) {
    child.owned_corners |= 1u << after;
  }
  if (has(node.owned_sides, before) && goes_with_second(node, before)) {
    child.owned_corners |= 1u << before;
  }
  if (i == 0u && middles.centre_label > 0u) {
    child.owned_corners |= 4u;
  }
  return child;
}

// The child of a Y-element.
Node y_child(Node node, Midpoints middles, uint i) {
  Node child = begin_child(node, middles, i, node.inside + 1, node.quad);
  uint before = (i + 3) & 3u;
  if (label_at(node.labels, i) > 1u) {
    child.owned_corners |= node.owned_corners & 1u << i;
    child.owned_corners |= uint(has(node.owned_sides, i)) << ((i + 1) & 3u);
    child.owned_corners |= uint(has(node.owned_sides, before)) << before;
  }
  return child;
}

// The root that the `index`-th node of a kind lies in: the last whose first is not greater.
uint root_of(uint kind, uint index) {
  uint low = 0u;
  uint high = root_count;
  while (high - low > 1u) {
    uint middle = (low + high) / 2;
    if (first_nodes[kind * root_count + middle] <= index) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return low;
}

// The `index`-th node of a kind.
Node find_node(uint kind, uint index) {
  uint root = root_of(kind, index);
  Node node = unpack_node(roots[root]);
  uint rest = index - first_nodes[kind * root_count + root];
  while (!is_uniform(node.labels)) {
    if (kind == kInnerKind) {
      if (rest == 0u) {
        break;
      }
      --rest;
    }
    Midpoints middles = midpoints_of(node);
    uint y = y_corner(node);
    if (y != kNone) {
      node = y_child(node, middles, y);
      continue;
    }
    uint inside = node.inside + 1 + middles.inner.x + middles.inner.y + middles.inner.z +
                  middles.inner.w;
    uint quad = node.quad;
    uint i = 0u;
    for (; i < 3u; ++i) {
      uint part = subtree(child_labels(node, middles, i));
      uint nodes = subtree_counts[part + kNodes + kind];
      if (rest < nodes) {
        break;
      }
      rest -= nodes;
      inside += subtree_counts[part + kInside];
      quad += subtree_counts[part + kQuads];
    }
    node = split_child(node, middles, i, inside, quad);
  }
  return node;
}
