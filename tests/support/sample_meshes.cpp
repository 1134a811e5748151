#include "support/sample_meshes.h"

#include <cmath>
#include <numbers>

#include "support/shapes.h"

namespace limn::test {

std::shared_ptr<const ControlMesh> control_mesh(
    const std::vector<glm::dvec3>& positions,
    const std::vector<std::vector<std::uint32_t>>& faces) {
  PolygonSoup soup;
  soup.positions = positions;
  for (const std::vector<std::uint32_t>& face : faces) {
    soup.add_face(face);
  }
  return control_mesh(soup);
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
  return control_mesh(grid_soup(n, n));
}

}  // namespace limn::test
