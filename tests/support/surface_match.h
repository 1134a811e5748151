#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "limn/mesh/refined_mesh.h"

// Whether two meshes are the same but for the numbers of their vertices and faces.
namespace limn::test {

/// Positions and faces as plain lists.
struct PlainMesh {
  std::vector<glm::dvec3> positions;
  std::vector<std::vector<std::uint32_t>> faces;
};
[[nodiscard]] PlainMesh plain(const RefinedMesh& mesh);
[[nodiscard]] PlainMesh plain(const ControlMesh& mesh);

/// For each point of `of` one of `among` no further than `distance` away, such that no two have the
/// same; empty where there are none such.
[[nodiscard]] std::vector<std::uint32_t> matching_vertices(std::span<const glm::dvec3> of,
                                                           std::span<const glm::dvec3> among,
                                                           double distance);

/// Empty where every vertex has its match within `distance` and the faces are the same cycles of
/// these; else what is not so.
[[nodiscard]] std::string surface_difference(const PlainMesh& actual, const PlainMesh& expected,
                                             double distance);

}  // namespace limn::test
