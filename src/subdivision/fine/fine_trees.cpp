// Trees are grown level by level for all faces together, which gives every vertex one number in the
// forest. A vertex belongs to the first node that moves it for the last time. Where such a face
// borders on one that is refined from its four labels alone, labels are the same for both, and the
// rules of those (root_nodes.cpp) tell whose the common vertices are.
#include "subdivision/fine/fine_trees.h"

#include <algorithm>

#include "limn/contract.h"
#include "subdivision/root_nodes.h"

namespace limn {
namespace {

/// Instead of a root: any may own the vertex, or none.
constexpr std::uint32_t kAnyRoot = kNone;
constexpr std::uint32_t kNoRoot = kNone - 1;

std::uint8_t children_of(const WalkNode& node) {
  switch (node.pattern()) {
    case FacePattern::kStays:
      return kNoChildren;
    case FacePattern::kY:
      return static_cast<std::uint8_t>(node.positive_corner());
    case FacePattern::kSplit:
      return kAllChildren;
    case FacePattern::kIllegal:
      break;
  }
  LIMN_EXPECTS(!"legal labels");
  return kNoChildren;
}

}  // namespace

void FineTrees::build(const RefinementPlan& plan, const FineLabels& fine, int levels) {
  forest_.plant(plan.cage, fine.faces);
  grow(plan, FineWalk(&fine, levels));
  number_vertices(plan);
  find_owners(plan);
}

void FineTrees::grow(const RefinementPlan& plan, const FineWalk& walk) {
  const auto labels_of = [&](std::uint32_t root) {
    return FaceLabels(plan.cage, plan.labels, forest_.root(root).face);
  };
  forest_.divide_roots(plan.cage, [&](std::uint32_t root) -> std::uint8_t {
    const FaceLabels labels = labels_of(root);
    if (labels.size() == 4) {
      return children_of(walk.root(labels));
    }
    return labels[0] > 0 ? kAllChildren : kNoChildren;
  });
  node_roots_.resize(forest_.nodes().size());
  std::vector<WalkNode> level(forest_.nodes().size() - forest_.first_node(1));
  for (std::uint32_t r = 0; r < forest_.roots().size(); ++r) {
    const ForestRoot& root = forest_.root(r);
    if (root.node != kNone) {
      node_roots_[root.node] = r;
    }
    for (std::uint32_t i = 0; i < root.sides; ++i) {
      if (const std::uint32_t child = root.child(i); child != kNone) {
        node_roots_[child] = r;
        level[child - forest_.first_node(1)] = walk.child_of_root(root.face, labels_of(r), i);
      }
    }
  }
  std::vector<WalkNode> next;
  while (!level.empty()) {
    const std::uint32_t begin = forest_.first_node(forest_.level_count() - 1);
    forest_.divide([&](std::uint32_t node) { return children_of(level[node - begin]); });
    const auto end = static_cast<std::uint32_t>(begin + level.size());
    next.resize(forest_.nodes().size() - end);
    node_roots_.resize(forest_.nodes().size());
    for (std::uint32_t node = begin; node < end; ++node) {
      for (std::uint32_t i = 0; i < 4; ++i) {
        if (const std::uint32_t child = forest_.node(node).child(i); child != kNone) {
          node_roots_[child] = node_roots_[node];
          next[child - end] = walk.child(level[node - begin], i);
        }
      }
    }
    level.swap(next);
  }
}

/// The cage's vertices keep their numbers, those on control edges follow the edge, and all others
/// come in the order of their trees.
void FineTrees::number_vertices(const RefinementPlan& plan) {
  const FlatTopology& topology = *plan.cage.topology;
  numbers_.assign(forest_.vertex_count(), kNone);
  std::ranges::copy(forest_.control_vertices(), numbers_.begin());
  std::vector<Piece> pieces;
  for (const ForestRoot& root : forest_.roots()) {
    const std::uint32_t first = plan.cage.first_corner(root.face);
    for (std::uint32_t side = 0; side < root.sides; ++side) {
      const std::uint32_t corner = first + side;
      const std::uint32_t twin = plan.cage.twin(corner);
      const bool is_first = plan.cage.is_first(corner);
      if (!is_first && has(plan.cage.face_of(twin))) {
        continue;
      }
      pieces.clear();
      walk_root_side(root, side, pieces);
      const auto inside = static_cast<std::uint32_t>(pieces.size() - 1);
      const EdgeRun run(plan.numbering->first_on_edge(topology.corner_edges[corner]), 1);
      for (std::uint32_t i = 0; i < inside; ++i) {
        numbers_[pieces[i].ends[1]] = run.at(is_first ? i : inside - 1 - i);
      }
    }
  }
  for (const ForestRoot& root : forest_.roots()) {
    if (root.children == kNoChildren) {
      continue;
    }
    std::uint32_t next = plan.numbering->first_inside(root.face);
    if (root.node != kNone) {
      number_inside(root.node, next);
      continue;
    }
    number_middle(forest_.node(root.first_child).vertices[2], next);
    for (std::uint32_t i = 0; i < root.sides; ++i) {
      number_inside(root.child(i), next);
    }
  }
}

void FineTrees::number_middle(std::uint32_t vertex, std::uint32_t& next) {
  if (numbers_[vertex] == kNone) {
    numbers_[vertex] = next++;
  }
}

void FineTrees::number_inside(std::uint32_t at, std::uint32_t& next) {
  const ForestNode& node = forest_.node(at);
  for (std::uint32_t i = 0; i < 4; ++i) {
    if (const std::uint32_t child = node.child(i); child != kNone) {
      for (const std::uint32_t v : forest_.node(child).vertices) {
        number_middle(v, next);
      }
      number_inside(child, next);
    }
  }
}

void FineTrees::find_owners(const RefinementPlan& plan) {
  owners_.assign(forest_.vertex_count(), kNone);
  levels_.assign(forest_.vertex_count(), 0);
  restrict_owners(plan);
  for (std::uint32_t node = 0; node < forest_.first_node(1); ++node) {
    claim_around(node, 1);
  }
  for (std::uint32_t r = 0; r < forest_.roots().size(); ++r) {
    const ForestRoot& root = forest_.root(r);
    for (std::uint32_t i = 0; i < root.sides && !root.is_quad(); ++i) {
      if (const std::uint32_t child = root.child(i); child != kNone) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
          claim(forest_.node(child).vertices[corner], child, r, 1);
        }
      }
    }
  }
  for (int level = 1; level < forest_.level_count(); ++level) {
    for (std::uint32_t n = forest_.first_node(level); n < forest_.first_node(level + 1); ++n) {
      claim_around(n, level + 1);
    }
  }
}

/// Says whose the vertices are that faces refined by themselves have, too.
void FineTrees::restrict_owners(const RefinementPlan& plan) {
  only_roots_.assign(forest_.vertex_count(), kAnyRoot);
  for (std::uint32_t i = 0; i < forest_.control_vertices().size(); ++i) {
    const std::span<const std::uint32_t> corners =
        corners_around(plan.cage, forest_.control_vertices()[i]);
    const auto is_here = [&](std::uint32_t corner) { return has(plan.cage.face_of(corner)); };
    if (!std::ranges::all_of(corners, is_here)) {
      const auto owner =
          std::ranges::find_if(corners, [&](std::uint32_t corner) { return plan.owns(corner); });
      const std::uint32_t root =
          owner == corners.end() ? kNone : forest_.root_of(plan.cage.face_of(*owner));
      only_roots_[i] = root == kNone ? kNoRoot : root;
    }
  }
  std::vector<Piece> pieces;
  for (const ForestRoot& root : forest_.roots()) {
    for (std::uint32_t side = 0; side < root.sides; ++side) {
      const std::uint32_t corner = plan.cage.first_corner(root.face) + side;
      const std::uint32_t twin = plan.cage.twin(corner);
      if (twin != kNone && !has(plan.cage.face_of(twin)) && !writes_side(plan, corner)) {
        pieces.clear();
        walk_root_side(root, side, pieces);
        for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
          only_roots_[pieces[i].ends[1]] = kNoRoot;
        }
      }
    }
  }
}

/// For a node: what it moves or makes at the next level.
void FineTrees::claim_around(std::uint32_t at, int level) {
  const ForestNode& node = forest_.node(at);
  if (node.children == kNoChildren) {
    return;
  }
  const std::uint32_t root = node_roots_[at];
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t child = node.child(i);
    if (child == kNone) {
      continue;
    }
    for (const std::uint32_t v : forest_.node(child).vertices) {
      claim(v, at, root, level);
    }
    if (node.children != kAllChildren) {
      claim(node.vertices[turned(i, 1)], at, root, level);
      claim(node.vertices[turned(i, 3)], at, root, level);
    }
  }
}

void FineTrees::claim(std::uint32_t vertex, std::uint32_t node, std::uint32_t root, int level) {
  const std::uint32_t only = only_roots_[vertex];
  if ((only == kAnyRoot || only == root) && levels_[vertex] < level) {
    levels_[vertex] = static_cast<std::uint8_t>(level);
    owners_[vertex] = node;
  }
}

void FineTrees::walk_root_side(const ForestRoot& root, std::uint32_t side,
                               std::vector<Piece>& pieces) const {
  const std::uint32_t after = side + 1 == root.sides ? 0 : side + 1;
  if (root.is_quad()) {
    const ForestNode& node = forest_.node(root.node);
    walk_side(root.node, side, {0, 0, {node.vertices[side], node.vertices[after]}}, pieces);
    return;
  }
  if (root.children == kNoChildren) {
    pieces.emplace_back();  // Its ends are control vertices, and known.
    return;
  }
  const std::array<std::uint32_t, 4>& first = forest_.node(root.child(side)).vertices;
  const std::array<std::uint32_t, 4>& second = forest_.node(root.child(after)).vertices;
  walk_side(root.child(side), 0, {1, 0, {first[0], first[1]}}, pieces);
  walk_side(root.child(after), 3, {1, 1, {first[1], second[0]}}, pieces);
}

void FineTrees::walk_side(std::uint32_t at, std::uint32_t side, const Piece& whole,
                          std::vector<Piece>& pieces) const {
  const ForestNode& node = forest_.node(at);
  const std::uint32_t after = turned(side, 1);
  const std::uint32_t first = node.child(side);
  const std::uint32_t second = node.child(after);
  if (first == kNone && second == kNone) {
    pieces.push_back(whole);
    return;
  }
  const std::uint32_t middle =
      first != kNone ? forest_.node(first).vertices[after] : forest_.node(second).vertices[side];
  const Piece half{whole.level + 1, 2 * whole.index, {whole.ends[0], middle}};
  const Piece other{whole.level + 1, 2 * whole.index + 1, {middle, whole.ends[1]}};
  // Half a side without a child there is a coarse quad's.
  if (first != kNone) {
    walk_side(first, side, half, pieces);
  } else {
    pieces.push_back(half);
  }
  if (second != kNone) {
    walk_side(second, side, other, pieces);
  } else {
    pieces.push_back(other);
  }
}

void FineTrees::list_pieces(std::uint32_t face, std::uint32_t side,
                            std::vector<EdgePiece>& pieces) const {
  std::vector<Piece> found;
  walk_root_side(forest_.root(forest_.root_of(face)), side, found);
  pieces.clear();
  for (const Piece& piece : found) {
    pieces.push_back(
        {piece.level, piece.index, {numbers_[piece.ends[0]], numbers_[piece.ends[1]]}});
  }
}

}  // namespace limn
