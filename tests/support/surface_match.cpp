// Vertices are sorted along a direction that no mesh is aligned with, so that few lie side by side.
#include "support/surface_match.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "limn/mesh/control_mesh.h"

namespace limn::test {
namespace {

double along(const glm::dvec3& point) {
  return glm::dot(point, glm::dvec3(0.5718281828, 0.7141592653, 0.4142135623));
}

using Cycle = std::vector<std::uint32_t>;

/// The same cycle from its lowest vertex on.
Cycle from_lowest(Cycle cycle) {
  std::rotate(cycle.begin(), std::ranges::min_element(cycle), cycle.end());
  return cycle;
}

}  // namespace

PlainMesh plain(const RefinedMesh& mesh) {
  PlainMesh result;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    result.positions.push_back(mesh.position(v));
  }
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    result.faces.emplace_back(face.begin(), face.end());
  }
  return result;
}

PlainMesh plain(const ControlMesh& mesh) {
  PlainMesh result;
  result.positions.assign(mesh.positions().begin(), mesh.positions().end());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    result.faces.emplace_back(face.begin(), face.end());
  }
  return result;
}

std::vector<std::uint32_t> matching_vertices(std::span<const glm::dvec3> of,
                                             std::span<const glm::dvec3> among, double distance) {
  std::vector<std::uint32_t> order(among.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(order, {}, [&](std::uint32_t v) { return along(among[v]); });
  std::vector<bool> is_taken(among.size(), false);
  std::vector<std::uint32_t> matches;
  matches.reserve(of.size());
  for (const glm::dvec3& point : of) {
    auto at = std::ranges::lower_bound(order, along(point) - 2.0 * distance, {},
                                       [&](std::uint32_t v) { return along(among[v]); });
    std::uint32_t nearest = kNone;
    double least = distance;
    for (; at != order.end() && along(among[*at]) <= along(point) + 2.0 * distance; ++at) {
      const double length = glm::distance(among[*at], point);
      if (!is_taken[*at] && length <= least) {
        least = length;
        nearest = *at;
      }
    }
    if (nearest == kNone) {
      return {};
    }
    is_taken[nearest] = true;
    matches.push_back(nearest);
  }
  return matches;
}

std::string surface_difference(const PlainMesh& actual, const PlainMesh& expected,
                               double distance) {
  if (actual.positions.size() != expected.positions.size() ||
      actual.faces.size() != expected.faces.size()) {
    return fmt::format("{} vertices and {} faces where {} and {} are expected",
                       actual.positions.size(), actual.faces.size(), expected.positions.size(),
                       expected.faces.size());
  }
  const std::vector<std::uint32_t> matches =
      matching_vertices(actual.positions, expected.positions, distance);
  if (matches.size() != actual.positions.size()) {
    return "a vertex lies where none is expected";
  }
  std::vector<Cycle> faces;
  for (const Cycle& face : actual.faces) {
    Cycle cycle;
    for (const std::uint32_t v : face) {
      cycle.push_back(matches[v]);
    }
    faces.push_back(from_lowest(std::move(cycle)));
  }
  std::vector<Cycle> expected_faces;
  std::ranges::transform(expected.faces, std::back_inserter(expected_faces), from_lowest);
  std::ranges::sort(faces);
  std::ranges::sort(expected_faces);
  return faces == expected_faces ? "" : "the faces differ";
}

}  // namespace limn::test
