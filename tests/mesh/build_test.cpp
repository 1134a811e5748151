#include "limn/mesh/build.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/mesh_checks.h"

namespace limn {
namespace {

using test::faces_of;
using test::faults_of;
using test::soup_of;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Faces = std::vector<std::vector<std::uint32_t>>;

const Faces Cube = {{0, 1, 3, 2}, {2, 3, 5, 4}, {4, 5, 7, 6},
                    {6, 7, 1, 0}, {1, 7, 5, 3}, {6, 0, 2, 4}};

TEST(BuildControlMesh, CubeKeepsFacesVerticesAndFirstCorners) {
  const PolygonSoup soup = soup_of(8, Cube);
  const auto built = build_control_mesh(soup);
  ASSERT_TRUE(built.has_value()) << to_string(built.error());
  const ControlMesh& mesh = *built->mesh;
  EXPECT_THAT(faults_of(mesh), IsEmpty());
  EXPECT_EQ(faces_of(mesh), Cube);
  EXPECT_EQ(mesh.edge_count(), 12U);
  EXPECT_TRUE(mesh.is_closed());
  EXPECT_TRUE(mesh.is_all_quads());
  EXPECT_FALSE(built->report.is_mended());
  EXPECT_THAT(built->report.sentences(), IsEmpty());
  for (std::size_t v = 0; v < 8; ++v) {
    EXPECT_EQ(mesh.positions()[v], soup.positions[v]);
  }
  EXPECT_EQ(mesh.bounds().low, glm::dvec3(0.0));
  EXPECT_EQ(mesh.bounds().high, glm::dvec3(7.0, 49.0, 343.0));
}

}  // namespace
}  // namespace limn
