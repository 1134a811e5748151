// Every edge that could be a diagonal is scored; the best are taken first, as long as both their
// triangles are free.
#include "editing/quad_pairs.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <glm/geometric.hpp>

namespace limn {
namespace {

struct Candidate {
  QuadPair pair;
  std::array<std::uint32_t, 2> faces{};
  double length = 0.0;  ///< Squared, of the diagonal, in that of the quad's longest side.
};

std::uint32_t next_in_triangle(std::uint32_t corner) {
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}

bool is_seam(const std::vector<std::uint32_t>& uvs, std::uint32_t corner, std::uint32_t twin) {
  return !uvs.empty() &&
         (uvs[corner] != uvs[next_in_triangle(twin)] || uvs[next_in_triangle(corner)] != uvs[twin]);
}

/// The quad around an edge, where it is flat and convex. `most` is the greatest angle in radians.
std::optional<Candidate> quad_at(const ControlMesh& mesh, std::uint32_t edge, double most) {
  const FlatTopology& flat = mesh.topology();
  const auto [corner, twin] = flat.edge_corners[edge];
  if (twin == kNone || is_seam(mesh.texture().corner_values, corner, twin)) {
    return std::nullopt;
  }
  const auto vertex = [&flat](std::uint32_t c) { return flat.corner_vertices[c]; };
  Candidate quad;
  quad.pair = {corner,
               {vertex(corner), vertex(next_in_triangle(next_in_triangle(twin))), vertex(twin),
                vertex(next_in_triangle(next_in_triangle(corner)))}};
  quad.faces = {flat.corner_faces[corner], flat.corner_faces[twin]};
  std::array<glm::dvec3, 4> p;
  for (std::size_t i = 0; i < 4; ++i) {
    p[i] = mesh.positions()[quad.pair.vertices[i]];
  }
  const glm::dvec3 one = glm::cross(p[2] - p[0], p[3] - p[0]);
  const glm::dvec3 other = glm::cross(p[1] - p[0], p[2] - p[0]);
  if (std::atan2(glm::length(glm::cross(one, other)), glm::dot(one, other)) > most ||
      glm::dot(one, one) == 0.0 || glm::dot(other, other) == 0.0) {
    return std::nullopt;
  }
  double longest_side = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec3 side = p[(i + 1) % 4] - p[i];
    const glm::dvec3 next_side = p[(i + 2) % 4] - p[(i + 1) % 4];
    if (glm::dot(glm::cross(side, next_side), one + other) <= 0.0) {
      return std::nullopt;
    }
    longest_side = std::max(longest_side, glm::dot(side, side));
  }
  quad.length = glm::dot(p[2] - p[0], p[2] - p[0]) / longest_side;
  return quad;
}

}  // namespace

std::vector<QuadPair> find_quad_pairs(const ControlMesh& mesh, double degrees) {
  const double most = degrees * std::numbers::pi / 180.0;
  std::vector<Candidate> candidates;
  for (std::uint32_t e = 0; e < mesh.edge_count(); ++e) {
    if (const auto candidate = quad_at(mesh, e, most)) {
      candidates.push_back(*candidate);
    }
  }
  std::ranges::stable_sort(candidates, std::ranges::greater(), &Candidate::length);
  std::vector<std::uint8_t> is_taken(mesh.face_count(), 0);
  std::vector<QuadPair> pairs;
  for (const Candidate& candidate : candidates) {
    const auto [one, other] = candidate.faces;
    if (is_taken[one] == 0 && is_taken[other] == 0) {
      is_taken[one] = 1;
      is_taken[other] = 1;
      pairs.push_back(candidate.pair);
    }
  }
  std::ranges::sort(pairs, {}, [&mesh](const QuadPair& pair) {
    return mesh.topology().corner_edges[pair.corner];
  });
  return pairs;
}

}  // namespace limn
