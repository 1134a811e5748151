// A pair keeps its corner while others are split or flipped, so all are decided on the mesh as it
// comes and then carried out one after the other.
#include "limn/editing/symmetrise.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "editing/quad_pairs.h"
#include "editing/surgery.h"
#include "editing/triangles_only.h"

namespace limn {
namespace {

/// Whether each pair is to be flipped.
using Flips = std::vector<std::uint8_t>;

Flips flips_to_axis(const ControlMesh& mesh, const std::vector<QuadPair>& pairs) {
  // Of a box any of the four space diagonals would do. Differences that are rounding alone change
  // nothing.
  constexpr double kRounding = 1e-9;
  const glm::dvec3 axis = mesh.bounds().high - mesh.bounds().low;
  const auto reach = [&](std::uint32_t a, std::uint32_t b) {
    return std::abs(glm::dot(axis, mesh.positions()[a] - mesh.positions()[b]));
  };
  Flips flips;
  flips.reserve(pairs.size());
  for (const QuadPair& pair : pairs) {
    const auto& [a, b, c, d] = pair.vertices;
    flips.push_back(reach(b, d) > reach(a, c) + kRounding * glm::dot(axis, axis) ? 1 : 0);
  }
  return flips;
}

/// Vertices joined by the sides of quads, to be coloured so that no side has both its ends of one
/// colour. A union-find forest that keeps the colour of a vertex relative to its parent's.
class Colouring {
 public:
  explicit Colouring(std::size_t vertices) : parents_(vertices), differs_(vertices, 0) {
    for (std::uint32_t v = 0; v < vertices; ++v) {
      parents_[v] = v;
    }
  }

  /// A vertex's tree, and whether it has another colour than the tree's root.
  struct Place {
    std::uint32_t root;
    std::uint8_t differs;
  };
  Place find(std::uint32_t v) {
    std::uint32_t root = v;
    std::uint8_t differs = 0;
    while (parents_[root] != root) {
      differs ^= differs_[root];
      root = parents_[root];
    }
    const Place place{root, differs};
    while (parents_[v] != root && v != root) {
      const std::uint32_t above = parents_[v];
      const std::uint8_t step = differs_[v];
      parents_[v] = root;
      differs_[v] = differs;
      differs ^= step;
      v = above;
    }
    return place;
  }

  /// False where the two have one colour by what was said before.
  bool tell_apart(std::uint32_t a, std::uint32_t b) {
    const Place one = find(a);
    const Place other = find(b);
    if (one.root == other.root) {
      return one.differs != other.differs;
    }
    // The lower number stays a root.
    const auto [above, below] = std::minmax(one.root, other.root);
    parents_[below] = above;
    differs_[below] = one.differs ^ other.differs ^ 1;
    return true;
  }

 private:
  std::vector<std::uint32_t> parents_;
  std::vector<std::uint8_t> differs_;
};

Result<Flips> flips_alternately(const ControlMesh& mesh, const std::vector<QuadPair>& pairs) {
  Colouring colours(mesh.vertex_count());
  for (const QuadPair& pair : pairs) {
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint32_t a = pair.vertices[i];
      const std::uint32_t b = pair.vertices[(i + 1) % 4];
      if (!colours.tell_apart(a, b)) {
        return fail(ErrorKind::kFailed,
                    fmt::format("The diagonals cannot join every other vertex: the sides of the "
                                "quads form a loop of odd length, through vertices {} and {}.",
                                a, b));
      }
    }
  }
  // In each connected part the colour that most diagonals join already; at a tie its root's.
  std::vector<long> diagonals_at_root(mesh.vertex_count(), 0);
  for (const QuadPair& pair : pairs) {
    const auto place = colours.find(pair.vertices[0]);
    diagonals_at_root[place.root] += place.differs == 0 ? 1 : -1;
  }
  Flips flips;
  flips.reserve(pairs.size());
  for (const QuadPair& pair : pairs) {
    const auto place = colours.find(pair.vertices[0]);
    const bool is_roots = diagonals_at_root[place.root] >= 0;
    flips.push_back((place.differs == 0) == is_roots ? 0 : 1);
  }
  return flips;
}

Result<Flips> choose_flips(const ControlMesh& mesh, const std::vector<QuadPair>& pairs,
                           SymmetriseBy by) {
  return by == SymmetriseBy::kFlipToAxis ? Result<Flips>(flips_to_axis(mesh, pairs))
                                         : flips_alternately(mesh, pairs);
}

/// Why a pair cannot be changed.
tl::unexpected<Error> refuse(const QuadPair& pair, std::string_view reason) {
  return fail(ErrorKind::kFailed,
              fmt::format("The diagonal between vertices {} and {} cannot be changed: {}.",
                          pair.vertices[0], pair.vertices[2], reason));
}

}  // namespace

Result<Symmetrised> symmetrise(const ControlMesh& mesh, SymmetriseBy by, double degrees) {
  if (auto triangles = check_triangles(mesh); !triangles) {
    return tl::unexpected(std::move(triangles.error()));
  }
  const std::vector<QuadPair> pairs = find_quad_pairs(mesh, degrees);
  if (pairs.empty()) {
    return fail(ErrorKind::kFailed,
                fmt::format("There is nothing to make symmetric: no two neighbouring triangles are "
                            "the halves of a quad that is flat to {} degrees.",
                            degrees));
  }
  Surgery surgery(mesh);
  Symmetrised result{nullptr, pairs.size(), 0};
  if (by == SymmetriseBy::kSplit) {
    for (const QuadPair& pair : pairs) {
      if (const auto reason = surgery.why_not_split(pair.corner)) {
        return refuse(pair, *reason);
      }
      surgery.split(pair.corner);
    }
    result.changed = pairs.size();
  } else {
    const Result<Flips> flips = choose_flips(mesh, pairs, by);
    if (!flips) {
      return tl::unexpected(flips.error());
    }
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if ((*flips)[i] == 0) {
        continue;
      }
      if (const auto reason = surgery.why_not_flip(pairs[i].corner)) {
        return refuse(pairs[i], *reason);
      }
      surgery.flip(pairs[i].corner);
      ++result.changed;
    }
  }
  result.mesh = surgery.finish();
  return result;
}

}  // namespace limn
