#include "limn/mesh/import.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/mesh_checks.h"
#include "support/corpus.h"

namespace limn {
namespace {

using test::faces_of;
using test::faults_of;
using testing::HasSubstr;
using testing::IsEmpty;
using Faces = std::vector<std::vector<std::uint32_t>>;

TEST(ImportObj, ReadsQuadAndTriangle) {
  const auto imported = import_obj(
      "v 0 0 0\nv 1 0 0\nv 1 1 0.1\nv 0 1 0\nv 2 0.5 0\nf 1 2 3 4\nf 2/1/1 5//2 3/3\n", "two.obj");
  ASSERT_TRUE(imported.has_value()) << to_string(imported.error());
  EXPECT_THAT(faults_of(*imported->mesh), IsEmpty());
  EXPECT_EQ(faces_of(*imported->mesh), (Faces{{0, 1, 2, 3}, {1, 4, 2}}));
  EXPECT_EQ(imported->mesh->positions()[2], glm::dvec3(1.0, 1.0, 0.1));
}

}  // namespace
}  // namespace limn
