#include "support/sample_meshes.h"

#include <cmath>
#include <numbers>

#include "limn/contract.h"
#include "limn/mesh/build.h"

namespace limn::test {

std::shared_ptr<const ControlMesh> control_mesh(
    const std::vector<glm::dvec3>& positions,
    const std::vector<std::vector<std::uint32_t>>& faces) {
  PolygonSoup soup;
  soup.positions = positions;
  for (const std::vector<std::uint32_t>& face : faces) {
    soup.add_face(face);
  }
  const Result<ImportedMesh> built = build_control_mesh(soup);
  LIMN_EXPECTS(built.has_value());
  return built->mesh;
}

std::shared_ptr<const ControlMesh> cube_mesh() {
  return control_mesh(
      {{-1, -1, -1},
       {1, -1, -1},
       {1, 1, -1},
       {-1, 1, -1},
       {-1, -1, 1},
       {1, -1, 1},
       {1, 1, 1},
       {-1, 1, 1}},
      {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}});
}

std::shared_ptr<const ControlMesh> mixed_mesh() {
  std::vector<glm::dvec3> positions;
  for (const double y : {-1.0, 1.0}) {
    for (int i = 0; i < 5; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / 5.0;
      positions.emplace_back(std::cos(angle), y, -std::sin(angle));
    }
  }
  return control_mesh(positions, {{0, 1, 6, 5},
                                  {5, 6, 7, 8, 9},
                                  {1, 2, 7},
                                  {1, 7, 6},
                                  {2, 3, 8, 7},
                                  {4, 3, 2, 1, 0},
                                  {3, 4, 9, 8},
                                  {4, 0, 5, 9}});
}

std::shared_ptr<const ControlMesh> grid_mesh(std::uint32_t n) {
  std::vector<glm::dvec3> positions;
  for (std::uint32_t y = 0; y <= n; ++y) {
    for (std::uint32_t x = 0; x <= n; ++x) {
      positions.emplace_back(x, y, 0.0);
    }
  }
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::uint32_t y = 0; y < n; ++y) {
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t v = y * (n + 1) + x;
      faces.push_back({v, v + 1, v + n + 2, v + n + 1});
    }
  }
  return control_mesh(positions, faces);
}

}  // namespace limn::test
