// Refining again into a result that is there allocates nothing, nor does checking again. This
// program counts what operator new is asked for; it is a program of its own, since that replaces
// the allocator.
#include <cstddef>

#include <gtest/gtest.h>

#include "limn/subdivision/crack_check.h"
#include "limn/subdivision/label_subdivision.h"
#include "support/attribute_shapes.h"
#include "support/counting_allocator.h"
#include "support/shapes.h"

namespace limn {
namespace {

void expect_no_allocation(const ControlMesh& mesh, const SubdivisionSettings& settings) {
  test::Random random(91);
  IgnoreProgress progress;
  const auto labels =
      legal_labels(mesh, test::random_depths(mesh, 0.3, 4, random), settings, progress);
  ASSERT_TRUE(labels);
  Refiner refiner;
  RefinedMesh result;
  const std::size_t before_first = test::allocation_count();
  ASSERT_TRUE(refiner.refine(mesh, labels->labels, settings, {}, progress, result));
  EXPECT_GT(test::allocation_count(), before_first);
  const std::size_t before_second = test::allocation_count();
  const bool is_done =
      static_cast<bool>(refiner.refine(mesh, labels->labels, settings, {}, progress, result));
  const std::size_t after = test::allocation_count();
  EXPECT_TRUE(is_done);
  EXPECT_EQ(after - before_second, 0u);
}

TEST(Refiner, AllocatesNothingTheSecondTime) {
  test::Random random(92);
  expect_no_allocation(*test::control_mesh(test::torus_soup(40, 30)), {});
  SubdivisionSettings where_painted;
  where_painted.non_quads = NonQuadRule::kWherePainted;
  expect_no_allocation(*test::control_mesh(test::with_mixed_faces(test::grid_soup(20, 20), random)),
                       where_painted);
}

TEST(Refiner, AllocatesNothingTheSecondTimeForCreasesAndTexture) {
  test::Random random(93);
  const auto torus = test::control_mesh(test::torus_soup(10, 8));
  const auto creased = test::with_random_creases(*torus, 0.2, 0.05, random);
  expect_no_allocation(*test::with_random_charts(*creased, 5, random), {});
}

void expect_no_allocation_of_a_check(const ControlMesh& mesh, double painted) {
  test::Random random(94);
  IgnoreProgress progress;
  const auto labels =
      legal_labels(mesh, test::random_depths(mesh, painted, 4, random), {}, progress);
  ASSERT_TRUE(labels);
  const auto refined = refine(mesh, labels->labels, {}, {}, progress);
  ASSERT_TRUE(refined);
  CrackChecker checker;
  CrackCheck result;
  const std::size_t before_first = test::allocation_count();
  checker.check(mesh, *refined, result);
  EXPECT_GT(test::allocation_count(), before_first);
  EXPECT_TRUE(result.is_watertight());
  const std::size_t before_second = test::allocation_count();
  checker.check(mesh, *refined, result);
  EXPECT_EQ(test::allocation_count() - before_second, 0u);
  EXPECT_TRUE(result.is_watertight());
}

TEST(CrackChecker, AllocatesNothingTheSecondTime) {
  test::Random random(95);
  expect_no_allocation_of_a_check(*test::control_mesh(test::torus_soup(8, 6)), 0.3);
  // Large enough for several threads; with a boundary; with faces that stay triangles.
  expect_no_allocation_of_a_check(*test::control_mesh(test::torus_soup(80, 70)), 0.9);
  expect_no_allocation_of_a_check(*test::control_mesh(test::grid_soup(80, 70)), 0.9);
  expect_no_allocation_of_a_check(
      *test::control_mesh(test::with_mixed_faces(test::grid_soup(20, 20), random)), 0.1);
}

}  // namespace
}  // namespace limn
