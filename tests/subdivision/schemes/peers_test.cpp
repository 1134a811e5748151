// Schemes against other libraries' own, on closed meshes: at boundaries these have other rules.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "limn/subdivision/schemes/uniform.h"
#include "peers.h"
#include "scheme_shapes.h"

namespace limn {
namespace {

using Peer = test::PlainMesh (*)(const ControlMesh&, int);

void expect_same_as(Peer peer, Scheme scheme) {
  for (const test::NamedShape& shape : test::closed_shapes_for(scheme)) {
    for (int level = 1; level <= 3; ++level) {
      SCOPED_TRACE(fmt::format("{}, level {}", shape.name, level));
      IgnoreProgress progress;
      const RefinedMesh result =
          subdivide(*shape.mesh, {.scheme = scheme}, {.levels = level}, progress).value();
      ASSERT_EQ(test::surface_difference(test::plain(result), peer(*shape.mesh, level),
                                         1e-6 * shape.mesh->bounds().diagonal()),
                "");
    }
  }
}

TEST(Loop, IsOpenMeshs) {
  expect_same_as(test::openmesh_loop, Scheme::kLoop);
}

TEST(Butterfly, IsOpenMeshs) {
  expect_same_as(test::openmesh_butterfly, Scheme::kButterfly);
}

TEST(Sqrt3, IsOpenMeshs) {
  expect_same_as(test::openmesh_sqrt3, Scheme::kSqrt3);
}

TEST(Sqrt3, IsCgals) {
  expect_same_as(test::cgal_sqrt3, Scheme::kSqrt3);
}

TEST(DooSabin, IsCgals) {
  expect_same_as(test::cgal_doo_sabin, Scheme::kDooSabin);
}

}  // namespace
}  // namespace limn
