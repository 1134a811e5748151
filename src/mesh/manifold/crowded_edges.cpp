// With all crowded edges cut, a fan that ends at both sides with the same crowded edge, at both
// ends of that edge, has to be closed there: else two edges would have the same ends.
//
//          a                 A tube pinched along a-b: f1 and f4 are one sheet, f2 and f3 the
//          other.
//     f1 \ | / f2            Cut, the fan of f1..f4 round the left has the edge a-b twice, and so
//     has
//         \|/                the one round the right. Each is closed with itself.
//     f4 / | \ f3
//          b
//
// Other pairs are a matter of choice. A choice can still give two edges the same ends, where it
// closes fans over other crowded edges; then nothing is chosen at the vertices concerned.
#include "mesh/manifold/crowded_edges.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "limn/mesh/flat_topology.h"

namespace limn::detail {
namespace {

/// At edges with more faces than this only the first are compared with each other.
constexpr std::size_t kMostCompared = 32;

/// After so many tries to do without the choices that doubled an edge, none is made anywhere.
constexpr int kMostRounds = 4;

class UnionFind {
 public:
  explicit UnionFind(std::size_t size) : parents_(size) {
    for (std::uint32_t i = 0; i < size; ++i) {
      parents_[i] = i;
    }
  }
  [[nodiscard]] std::uint32_t find(std::uint32_t i) {
    while (parents_[i] != i) {
      parents_[i] = parents_[parents_[i]];
      i = parents_[i];
    }
    return i;
  }
  void unite(std::uint32_t a, std::uint32_t b) { parents_[find(b)] = find(a); }

 private:
  std::vector<std::uint32_t> parents_;
};

/// Two corners at one edge that could be joined; the smallest is the best.
struct Candidate {
  long bend = 0;  ///< Rises from straight on to folded back.
  bool is_apart = false;
  std::array<std::uint32_t, 2> corners{};

  auto operator<=>(const Candidate&) const = default;
};

class CrowdedEdges {
 public:
  CrowdedEdges(const WorkingFaces& working, CornerMatching& matching,
               std::span<const glm::dvec3> positions)
      : faces_(working.arrays()),
        twins_(matching.twins),
        matching_(matching),
        positions_(positions),
        face_of_(corner_faces(faces_.offsets)),
        is_settled_(faces_.vertex_count, 0) {
    if (edge_count() > 0) {
      measure_spreads();
    }
  }

  FanOwners join() {
    join_what_must_be();
    const std::vector<std::uint32_t> without_choice = twins_;
    UnionFind components = connected_faces();
    for (int round = 0;; ++round) {
      if (round == kMostRounds) {
        std::ranges::fill(is_settled_, std::uint8_t{1});
      }
      choose(components);
      FanOwners owners = find_fans(faces_, twins_);
      if (!settle_doubled_edges(owners)) {
        return owners;
      }
      twins_ = without_choice;
    }
  }

  [[nodiscard]] std::size_t edge_count() const { return matching_.crowded_offsets.size() - 1; }
  [[nodiscard]] std::span<const std::uint32_t> corners(std::size_t edge) const {
    const std::uint32_t begin = matching_.crowded_offsets[edge];
    return std::span(matching_.crowded_corners)
        .subspan(begin, matching_.crowded_offsets[edge + 1] - begin);
  }
  [[nodiscard]] std::uint32_t end_of(std::uint32_t corner) const {
    return faces_.vertices[next(corner)];
  }
  [[nodiscard]] std::uint32_t face_of(std::uint32_t corner) const { return face_of_[corner]; }

 private:
  [[nodiscard]] std::uint32_t next(std::uint32_t corner) const {
    return next_corner(faces_, face_of_[corner], corner);
  }

  /// The owners at the lower and the higher vertex of a corner's edge.
  [[nodiscard]] std::array<std::uint32_t, 2> ends(const FanOwners& owners,
                                                  std::uint32_t corner) const {
    const std::uint32_t other = next(corner);
    std::array<std::uint32_t, 2> result{owners.of_corners[corner], owners.of_corners[other]};
    if (faces_.vertices[corner] > faces_.vertices[other]) {
      std::swap(result[0], result[1]);
    }
    return result;
  }

  void make_twins(std::uint32_t a, std::uint32_t b) {
    twins_[a] = b;
    twins_[b] = a;
  }

  void join_what_must_be() {
    const FanOwners owners = find_fans(faces_, twins_);
    std::vector<std::pair<std::array<std::uint32_t, 2>, std::uint32_t>> sorted;
    for (std::size_t e = 0; e < edge_count(); ++e) {
      sorted.clear();
      for (const std::uint32_t c : corners(e)) {
        sorted.emplace_back(ends(owners, c), c);
      }
      std::ranges::sort(sorted);
      for (std::size_t i = 1; i < sorted.size(); ++i) {
        if (sorted[i].first == sorted[i - 1].first) {
          make_twins(sorted[i - 1].second, sorted[i].second);
        }
      }
    }
  }

  /// Faces joined over the twins that there are.
  [[nodiscard]] UnionFind connected_faces() const {
    UnionFind components(faces_.face_count());
    for (std::uint32_t c = 0; c < twins_.size(); ++c) {
      if (twins_[c] != kNone && c < twins_[c]) {
        components.unite(face_of_[c], face_of_[twins_[c]]);
      }
    }
    return components;
  }

  [[nodiscard]] const glm::dvec3& first_position(std::uint32_t face) const {
    return positions_[faces_.vertices[faces_.offsets[face]]];
  }

  void measure_spreads() {
    spreads_.assign(faces_.face_count(), glm::dvec3(0.0));
    for (std::uint32_t f = 0; f < spreads_.size(); ++f) {
      for (std::uint32_t c = faces_.offsets[f]; c < faces_.offsets[f + 1]; ++c) {
        spreads_[f] += positions_[faces_.vertices[c]] - first_position(f);
      }
    }
  }

  /// The direction in which a corner's face leaves its edge, square to it; of length 1 or 0.
  [[nodiscard]] glm::dvec3 wing(std::uint32_t corner) const {
    const std::uint32_t f = face_of_[corner];
    const glm::dvec3& from = positions_[faces_.vertices[corner]];
    const double sides = faces_.offsets[f + 1] - faces_.offsets[f];
    glm::dvec3 towards = spreads_[f] + sides * (first_position(f) - from);
    const glm::dvec3 along = positions_[end_of(corner)] - from;
    const double squared = glm::dot(along, along);
    if (squared > 0.0) {
      towards -= along * (glm::dot(along, towards) / squared);
    }
    const double length = glm::length(towards);
    return length > 0.0 ? towards / length : glm::dvec3(0.0);
  }

  void choose(UnionFind& components) {
    std::vector<std::uint32_t> open;
    std::vector<glm::dvec3> wings;
    std::vector<Candidate> candidates;
    for (std::size_t e = 0; e < edge_count(); ++e) {
      const std::uint32_t first = corners(e).front();
      if (is_settled_[faces_.vertices[first]] != 0 || is_settled_[end_of(first)] != 0) {
        continue;
      }
      open.clear();
      wings.clear();
      for (const std::uint32_t c : corners(e)) {
        if (twins_[c] == kNone && open.size() < kMostCompared) {
          open.push_back(c);
          wings.push_back(wing(c));
        }
      }
      candidates.clear();
      for (std::size_t i = 0; i < open.size(); ++i) {
        for (std::size_t j = i + 1; j < open.size(); ++j) {
          const bool is_opposite = faces_.vertices[open[i]] != faces_.vertices[open[j]];
          if (is_opposite && face_of_[open[i]] != face_of_[open[j]]) {
            // Rounded, so that what is equally straight by construction is so in fact.
            const auto bend = static_cast<long>(1e6 * glm::dot(wings[i], wings[j]) + 2e6);
            const bool is_apart =
                components.find(face_of_[open[i]]) != components.find(face_of_[open[j]]);
            candidates.push_back({bend, is_apart, {open[i], open[j]}});
          }
        }
      }
      std::ranges::sort(candidates);
      for (const Candidate& candidate : candidates) {
        const auto [a, b] = candidate.corners;
        if (twins_[a] == kNone && twins_[b] == kNone) {
          make_twins(a, b);
        }
      }
    }
  }

  /// Marks the vertices of edges that have the same ends as others, unless they are marked.
  bool settle_doubled_edges(const FanOwners& owners) {
    bool is_any = false;
    std::vector<std::array<std::uint32_t, 2>> seen;
    for (std::size_t e = 0; e < edge_count(); ++e) {
      seen.clear();
      for (const std::uint32_t c : corners(e)) {
        if (twins_[c] == kNone || c < twins_[c]) {
          seen.push_back(ends(owners, c));
        }
      }
      std::ranges::sort(seen);
      const std::uint32_t first = corners(e).front();
      if (std::ranges::adjacent_find(seen) != seen.end()) {
        is_any |= std::exchange(is_settled_[faces_.vertices[first]], std::uint8_t{1}) == 0;
        is_any |= std::exchange(is_settled_[end_of(first)], std::uint8_t{1}) == 0;
      }
    }
    return is_any;
  }

  FaceArrays faces_;
  std::vector<std::uint32_t>& twins_;
  const CornerMatching& matching_;
  std::span<const glm::dvec3> positions_;
  std::vector<std::uint32_t> face_of_;
  std::vector<glm::dvec3> spreads_;       ///< Per face the sum of its corners, seen from its first.
  std::vector<std::uint8_t> is_settled_;  ///< Vertices at whose edges nothing more is chosen.
};

}  // namespace

FanOwners join_crowded_edges(const WorkingFaces& faces, CornerMatching& matching,
                             std::span<const glm::dvec3> positions, MendLog& log) {
  CrowdedEdges crowded(faces, matching, positions);
  for (std::size_t e = 0; e < crowded.edge_count(); ++e) {
    const std::uint32_t first = crowded.corners(e).front();
    log.add_edge(MendKind::kCrowdedEdge, faces.sources[crowded.face_of(first)],
                 faces.vertices[first], crowded.end_of(first));
  }
  return crowded.join();
}

}  // namespace limn::detail
