#include "limn/subdivision/fine_demands.h"

#include <algorithm>
#include <map>
#include <tuple>

#include <gtest/gtest.h>

#include "hierarchy_labels.h"
#include "support/shapes.h"

namespace limn {
namespace {

TEST(FineDemands, AreTheSameInWhateverOrderTheyWereRaised) {
  test::Random random(3);
  const auto mesh = test::mixed_prism();
  std::vector<FineDemand> demands = test::random_demands(*mesh, 60, 6, random);
  const FineDemands at_once(demands);
  for (int i = 0; i < 10; ++i) {
    std::ranges::shuffle(demands, random);
    FineDemands one_by_one;
    for (const FineDemand& demand : demands) {
      one_by_one.raise({&demand, 1});
      one_by_one.raise({&demand, 1});
    }
    EXPECT_EQ(one_by_one, at_once);
  }
}

TEST(FineDemands, KeepOnlyWhatNoOtherCovers) {
  const FineFace face{2, 0, 2, 1, 3};
  const FineDemand outer{face, 5};
  const FineDemand inner{{2, 0, 3, 2, 7}, 5};
  const FineDemand deeper{{2, 0, 4, 5, 15}, 6};
  const FineDemand none{{2, 0, 3, 0, 0}, 3};
  const FineDemands demands(std::vector{deeper, none, inner, outer});
  ASSERT_EQ(demands.size(), 2u);
  EXPECT_EQ(demands.all()[0], outer);
  EXPECT_EQ(demands.all()[1], deeper);
  EXPECT_EQ(demands.depth_at(deeper.face), 6);
  EXPECT_EQ(demands.depth_at(inner.face), 5);
  EXPECT_EQ(demands.depth_at({2, 0, 1, 0, 1}), 0);
}

/// The depth asked of every face of one level.
std::vector<std::uint8_t> asked(const FineDemands& demands, const ControlMesh& mesh,
                                std::uint8_t level) {
  std::vector<std::uint8_t> depths;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    const auto sides = static_cast<std::uint32_t>(mesh.face(f).size());
    const auto along = static_cast<std::uint16_t>(1U << (sides == 4 ? level : level - 1));
    for (std::uint32_t corner = 0; corner < (sides == 4 ? 1 : sides); ++corner) {
      for (std::uint16_t row = 0; row < along; ++row) {
        for (std::uint16_t column = 0; column < along; ++column) {
          const std::uint8_t depth = demands.depth_at({f, corner, level, column, row});
          depths.push_back(depth > level ? depth : std::uint8_t{0});
        }
      }
    }
  }
  return depths;
}

TEST(FineDemands, AreLoweredWithinAFaceAndNowhereElse) {
  constexpr std::uint8_t kLevel = 4;
  test::Random random(5);
  const auto mesh = test::mixed_prism();
  for (int i = 0; i < 40; ++i) {
    FineDemands demands(test::random_demands(*mesh, 40, 6, random));
    const FineDemand most = test::random_demands(*mesh, 1, kLevel, random)[0];
    // Lowered by hand: every face of a level that is deep enough on its own.
    FineDemands inside(std::vector{FineDemand{most.face, kMaxDepth}});
    const std::vector<std::uint8_t> is_inside = asked(inside, *mesh, kLevel);
    std::vector<std::uint8_t> expected = asked(demands, *mesh, kLevel);
    for (std::size_t f = 0; f < expected.size(); ++f) {
      if (is_inside[f] > 0 && expected[f] > most.depth) {
        expected[f] = most.depth > kLevel ? most.depth : std::uint8_t{0};
      }
    }
    demands.lower(most);
    EXPECT_EQ(asked(demands, *mesh, kLevel), expected);
  }
}

TEST(FineDemands, KnowWhichFacesAMeshHas) {
  const auto mesh = test::mixed_prism();
  std::uint32_t polygon = 0;
  while (mesh->face(polygon).size() != 5) {
    ++polygon;
  }
  std::uint32_t quad = 0;
  while (mesh->face(quad).size() != 4) {
    ++quad;
  }
  EXPECT_TRUE(is_face_of(*mesh, {quad, 0, 1, 1, 1}));
  EXPECT_FALSE(is_face_of(*mesh, {quad, 1, 1, 1, 1}));
  EXPECT_FALSE(is_face_of(*mesh, {quad, 0, 1, 2, 1}));
  EXPECT_FALSE(is_face_of(*mesh, {quad, 0, 0, 0, 0}));
  EXPECT_TRUE(is_face_of(*mesh, {polygon, 4, 1, 0, 0}));
  EXPECT_FALSE(is_face_of(*mesh, {polygon, 4, 1, 1, 0}));
  EXPECT_FALSE(is_face_of(*mesh, {polygon, 5, 1, 0, 0}));
  EXPECT_FALSE(is_face_of(*mesh, {static_cast<std::uint32_t>(mesh->face_count()), 0, 1, 0, 0}));
  EXPECT_TRUE(is_demand_on(*mesh, {{quad, 0, 1, 1, 1}, 2}));
  EXPECT_FALSE(is_demand_on(*mesh, {{quad, 0, 1, 1, 1}, 1}));
  EXPECT_FALSE(is_demand_on(*mesh, {{quad, 0, 1, 1, 1}, kMaxDepth + 1}));
}

}  // namespace
}  // namespace limn
