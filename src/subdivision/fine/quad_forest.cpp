// Children come one after the other in the order of their parents, and whom they border on follows
// from whom these do:
//
//     3 ------ 2 ------ 2          Child i has half of the parent's sides i and i - 1. The side
//     | child  |  child |          after those, i + 1, runs from the middle of side i to the centre
//     |   3    |    2   |          and has child i + 1 across; side i + 2 comes back to side i - 1
//     3 ------ c ------ 1          and has child i - 1 across.
//     | child  |  child |
//     |   0    |    1   |          Across side i from end to end lies the parent's neighbour with
//     0 ------ 0 ------ 1          its side s: child s + 1 first, then child s.
#include "subdivision/fine/quad_forest.h"

#include "limn/contract.h"

namespace limn {
void QuadForest::plant(const Cage& cage, std::span<const std::uint32_t> faces) {
  const FlatTopology& topology = *cage.topology;
  roots_.clear();
  nodes_.clear();
  control_vertices_.clear();
  face_roots_.assign(cage.face_count(), kNone);
  vertex_numbers_.assign(topology.vertex_offsets.size() - 1, kNone);
  for (const std::uint32_t f : faces) {
    face_roots_[f] = static_cast<std::uint32_t>(roots_.size());
    ForestRoot& root = roots_.emplace_back();
    root.face = f;
    root.sides = cage.side_count(f);
    const std::uint32_t first = cage.first_corner(f);
    for (std::uint32_t i = 0; i < cage.side_count(f); ++i) {
      const std::uint32_t v = topology.corner_vertices[first + i];
      if (vertex_numbers_[v] == kNone) {
        vertex_numbers_[v] = static_cast<std::uint32_t>(control_vertices_.size());
        control_vertices_.push_back(v);
      }
    }
    if (root.is_quad()) {
      root.node = static_cast<std::uint32_t>(nodes_.size());
      ForestNode& node = nodes_.emplace_back();
      node.neighbours.fill(kNobody);
      for (std::uint32_t i = 0; i < 4; ++i) {
        node.vertices[i] = vertex_numbers_[topology.corner_vertices[first + i]];
      }
    }
  }
  vertex_count_ = static_cast<std::uint32_t>(control_vertices_.size());
  first_nodes_ = {0, static_cast<std::uint32_t>(nodes_.size())};
}

void QuadForest::divide_roots(const Cage& cage,
                              const std::function<std::uint8_t(std::uint32_t)>& children) {
  const FlatTopology& topology = *cage.topology;
  std::vector<std::uint32_t> middles(topology.edge_corners.size(), kNone);
  const auto middle_of = [&](std::uint32_t corner) {
    std::uint32_t& middle = middles[topology.corner_edges[corner]];
    if (middle == kNone) {
      middle = vertex_count_++;
    }
    return middle;
  };
  for (std::uint32_t r = 0; r < roots_.size(); ++r) {
    ForestRoot& root = roots_[r];
    root.children = children(r);
    if (root.children == kNoChildren) {
      continue;
    }
    root.first_child = static_cast<std::uint32_t>(nodes_.size());
    if (root.node != kNone) {
      nodes_[root.node].first_child = root.first_child;
      nodes_[root.node].children = root.children;
    }
    const std::uint32_t first = cage.first_corner(root.face);
    const std::uint32_t centre = vertex_count_++;
    for (std::uint32_t i = 0; i < cage.side_count(root.face); ++i) {
      if (root.child(i) == kNone) {
        continue;
      }
      const std::uint32_t turn = root.turn(i);
      ForestNode& node = nodes_.emplace_back();
      node.vertices[turn] = vertex_numbers_[topology.corner_vertices[first + i]];
      node.vertices[turned(turn, 1)] = middle_of(first + i);
      node.vertices[turned(turn, 2)] = centre;
      node.vertices[turned(turn, 3)] = middle_of(cage.previous(first + i));
    }
  }
  first_nodes_.push_back(static_cast<std::uint32_t>(nodes_.size()));
  for (const ForestRoot& root : roots_) {
    if (root.children != kNoChildren) {
      link_first_level(cage, root);
    }
  }
}

void QuadForest::link_first_level(const Cage& cage, const ForestRoot& root) {
  const std::uint32_t first = cage.first_corner(root.face);
  const std::uint32_t n = cage.side_count(root.face);
  // The child at a control corner, and its side that lies so many after the one that leaves there.
  const auto place = [&](std::uint32_t corner, std::uint32_t side) {
    const std::uint32_t face = cage.face_of(corner);
    const std::uint32_t r = face_roots_[face];
    if (r == kNone) {
      return kNobody;
    }
    const std::uint32_t i = corner - cage.first_corner(face);
    const std::uint32_t child = roots_[r].child(i);
    return child == kNone ? kNobody : 4 * child + turned(roots_[r].turn(i), side);
  };
  for (std::uint32_t i = 0; i < n; ++i) {
    if (root.child(i) == kNone) {
      continue;
    }
    const std::uint32_t corner = first + i;
    const std::uint32_t turn = root.turn(i);
    const std::uint32_t before = cage.previous(corner);
    const std::uint32_t leaving = cage.twin(corner);
    const std::uint32_t entering = cage.twin(before);
    std::array<std::uint32_t, 4>& neighbours = nodes_[root.child(i)].neighbours;
    neighbours[turn] = leaving == kNone ? kBoundary : place(cage.next(leaving), 3);
    neighbours[turned(turn, 1)] = place(cage.next(corner), 2);
    neighbours[turned(turn, 2)] = place(before, 1);
    neighbours[turned(turn, 3)] = entering == kNone ? kBoundary : place(entering, 0);
  }
}

/// The vertex in the middle of a node's side: its neighbour's, if that has it already.
std::uint32_t QuadForest::middle(std::uint32_t node, std::uint32_t side) {
  const std::uint32_t neighbour = nodes_[node].neighbours[side];
  if (neighbour < kBoundary && neighbour / 4 < node) {
    const ForestNode& other = nodes_[neighbour / 4];
    const std::uint32_t s = neighbour % 4;
    if (const std::uint32_t child = other.child(s); child != kNone) {
      return nodes_[child].vertices[turned(s, 1)];
    }
    if (const std::uint32_t child = other.child(turned(s, 1)); child != kNone) {
      return nodes_[child].vertices[s];
    }
  }
  return vertex_count_++;
}

/// Who is across the half of a side, `from_end` halves away from the end of the neighbour's side.
std::uint32_t QuadForest::across(std::uint32_t neighbour, std::uint32_t from_end) const {
  if (neighbour >= kBoundary) {
    return neighbour;
  }
  const std::uint32_t s = neighbour % 4;
  const std::uint32_t child = nodes_[neighbour / 4].child(turned(s, 1 - from_end));
  return child == kNone ? kNobody : 4 * child + s;
}

void QuadForest::divide(const std::function<std::uint8_t(std::uint32_t)>& children) {
  LIMN_EXPECTS(first_nodes_.size() > 2);
  const std::uint32_t begin = first_nodes_[first_nodes_.size() - 2];
  const std::uint32_t end = first_nodes_.back();
  for (std::uint32_t parent = begin; parent < end; ++parent) {
    const std::uint8_t wanted = children(parent);
    if (wanted == kNoChildren) {
      continue;
    }
    const auto is_there = [wanted](std::uint32_t i) {
      return wanted == kAllChildren || wanted == i;
    };
    std::array<std::uint32_t, 4> middles{};
    for (std::uint32_t side = 0; side < 4; ++side) {
      if (is_there(side) || is_there(turned(side, 1))) {
        middles[side] = middle(parent, side);
      }
    }
    const std::uint32_t centre = vertex_count_++;
    nodes_[parent].first_child = static_cast<std::uint32_t>(nodes_.size());
    nodes_[parent].children = wanted;
    for (std::uint32_t i = 0; i < 4; ++i) {
      if (is_there(i)) {
        ForestNode child;
        child.vertices[i] = nodes_[parent].vertices[i];
        child.vertices[turned(i, 1)] = middles[i];
        child.vertices[turned(i, 2)] = centre;
        child.vertices[turned(i, 3)] = middles[turned(i, 3)];
        nodes_.push_back(child);
      }
    }
  }
  first_nodes_.push_back(static_cast<std::uint32_t>(nodes_.size()));
  for (std::uint32_t parent = begin; parent < end; ++parent) {
    const ForestNode node = nodes_[parent];
    for (std::uint32_t i = 0; i < 4 && node.children != kNoChildren; ++i) {
      const std::uint32_t child = node.child(i);
      if (child == kNone) {
        continue;
      }
      const std::uint32_t after = node.child(turned(i, 1));
      const std::uint32_t before = node.child(turned(i, 3));
      std::array<std::uint32_t, 4>& neighbours = nodes_[child].neighbours;
      neighbours[i] = across(node.neighbours[i], 0);
      neighbours[turned(i, 1)] = after == kNone ? kNobody : 4 * after + turned(i, 3);
      neighbours[turned(i, 2)] = before == kNone ? kNobody : 4 * before + i;
      neighbours[turned(i, 3)] = across(node.neighbours[turned(i, 3)], 1);
    }
  }
}

}  // namespace limn
