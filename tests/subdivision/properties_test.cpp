// What holds of every painting, tried on very many small ones.
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "limn/subdivision/crack_check.h"
#include "limn/subdivision/label_subdivision.h"
#include "subdivision/invariants.h"
#include "support/effort.h"
#include "support/shapes.h"

namespace limn {
namespace {

/// Paintings of one mesh, a quarter of a million of them where there is no sanitizer to wait for,
/// and a sixteenth of that where there is.
void expect_sound_paintings(const ControlMesh& mesh, NonQuadRule rule, std::uint32_t seed) {
  constexpr double kPaintings = 250000.0;
  const auto paintings = static_cast<int>(kPaintings * test::effort() * test::effort());
  test::Random random(seed);
  SubdivisionSettings settings;
  settings.non_quads = rule;
  IgnoreProgress progress;
  Refiner refiner;
  RefinedMesh refined;
  for (int i = 0; i < paintings; ++i) {
    const auto depths = test::random_depths(mesh, i % 2 == 0 ? 0.2 : 0.5, 1 + i % 2, random);
    const auto legal = legal_labels(mesh, depths, settings, progress);
    ASSERT_TRUE(legal);
    ASSERT_TRUE(illegal_faces(mesh, legal->labels, settings.legalisation).empty());
    ASSERT_TRUE(refiner.refine(mesh, legal->labels, settings, {}, progress, refined));
    const CrackCheck cracks = check_cracks(mesh, refined);
    ASSERT_TRUE(cracks.is_watertight() && cracks.boundary_edges == 0) << "painting " << i;
    ASSERT_LE(greatest_level_difference(refined), 1) << "painting " << i;
  }
}

TEST(Properties, HoldOfAMillionPaintings) {
  expect_sound_paintings(*test::cube(), NonQuadRule::kUniformFirstStep, 81);
  expect_sound_paintings(*test::control_mesh(test::torus_soup(4, 3)),
                         NonQuadRule::kUniformFirstStep, 82);
  expect_sound_paintings(*test::control_mesh(test::prism_soup(3)), NonQuadRule::kWherePainted, 83);
  expect_sound_paintings(*test::control_mesh(test::trapezohedron_soup(5)),
                         NonQuadRule::kUniformFirstStep, 84);
}

}  // namespace
}  // namespace limn
