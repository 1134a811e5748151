#include "render/surface/crease_lines.h"

#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/attribute_shapes.h"

namespace limn::render {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

TEST(CreaseLines, OfAControlMeshAreItsSharpEdgesAndVertices) {
  EXPECT_THAT(crease_lines(*test::cube()), IsEmpty());
  PolygonSoup soup = test::cube_soup();
  for (glm::dvec3& position : soup.positions) {
    position += glm::dvec3(1e6, 0.0, 0.0);
  }
  const auto mesh = test::with_tags(soup, {{{1, 0}, 2.0F}, {{6, 7}, 0.5F}}, {{4, 3.0F}});
  std::vector<CreaseLine> lines = crease_lines(*mesh);
  for (CreaseLine& line : lines) {
    if (line.from.x > line.to.x) {
      std::swap(line.from, line.to);
    }
  }
  EXPECT_THAT(lines, UnorderedElementsAre(CreaseLine{{-1, -1, -1}, {1, -1, -1}, 2.0F},
                                          CreaseLine{{-1, 1, 1}, {1, 1, 1}, 0.5F},
                                          CreaseLine{{-1, -1, 1}, {-1, -1, 1}, 3.0F}));
}

TEST(CreaseLines, OfARefinedMeshAreRelativeToTheSurface) {
  RefinedMesh mesh;
  mesh.origin = {10.0, 0.0, 0.0};
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.creases = {{{1, 2}, 1.5F}};
  mesh.corners = {{3, 0.5F}};
  EXPECT_THAT(
      crease_lines(mesh, {9.0, 0.0, 0.0}),
      ElementsAre(CreaseLine{{2, 0, 0}, {2, 1, 0}, 1.5F}, CreaseLine{{1, 1, 0}, {1, 1, 0}, 0.5F}));
}

}  // namespace
}  // namespace limn::render
