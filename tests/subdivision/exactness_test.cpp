// Positions, connectivity and invariants of refinements against OpenSubdiv.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "exactness_check.h"
#include "limn/mesh/import.h"
#include "support/attribute_shapes.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/shapes.h"

namespace limn {
namespace {

using test::MeshPointer;

/// Uniform faces that a hierarchy may have, which bounds the time of a test; times the effort.
constexpr double kUniformFaces = 30000;
/// Two levels at least for meshes of up to so many corners, likewise.
constexpr double kMostCorners = 20000;

int deepest_affordable(const ControlMesh& mesh) {
  const double corners = static_cast<double>(mesh.topology().corner_vertices.size());
  const int levels = 1 + static_cast<int>(std::floor(
                             std::log(test::effort() * kUniformFaces / corners) / std::log(4)));
  return std::clamp(levels, corners <= test::effort() * kMostCorners ? 2 : 0, 6);
}

void expect_exact(const ControlMesh& mesh, const std::string& name, int paintings,
                  test::Random& random) {
  const int affordable = deepest_affordable(mesh);
  if (affordable < 2) {
    return;
  }
  for (const CornerRule corners : {CornerRule::kSharp, CornerRule::kSmooth}) {
    const test::UniformReference reference(mesh, affordable, corners);
    for (int painting = 0; painting < paintings; ++painting) {
      SubdivisionSettings settings;
      settings.corners = corners;
      settings.non_quads =
          painting % 2 == 0 ? NonQuadRule::kWherePainted : NonQuadRule::kUniformFirstStep;
      const bool has_first_step =
          !mesh.is_all_quads() && settings.non_quads == NonQuadRule::kUniformFirstStep;
      const int deepest = std::min(5, affordable - (has_first_step ? 1 : 0));
      const double probability = std::pow(0.5, 1 + painting % 6);
      const auto depths = test::random_depths(mesh, probability, deepest, random);
      IgnoreProgress progress;
      const auto legal = legal_labels(mesh, depths, settings, progress);
      ASSERT_TRUE(legal);
      const int levels = painting % 3 == 2 ? 1 + painting % 4 : kAllLevels;
      SCOPED_TRACE(fmt::format("{}, painting {}, stopped after {}", name, painting, levels));
      const auto exactness = reference.compare(legal->labels, settings, levels);
      ASSERT_EQ(exactness.difference, "");
      ASSERT_EQ(exactness.off, 0u) << exactness.greatest_deviation;
      ASSERT_EQ(test::first_breach(mesh, legal->labels, settings, levels), "");
    }
  }
}

TEST(Exactness, HoldsOnShapesOfEveryKind) {
  test::Random random(1);
  const auto mixed = [&](const PolygonSoup& soup) { return test::with_mixed_faces(soup, random); };
  const std::vector<std::pair<std::string, PolygonSoup>> shapes{
      {"cube", test::cube_soup()},
      {"single quad", test::grid_soup(1, 1)},
      {"strip", test::grid_soup(5, 1)},
      {"grid", test::grid_soup(7, 5)},
      {"torus", test::torus_soup(9, 6)},
      {"narrow torus", test::torus_soup(3, 3)},
      {"triangle", test::polygon_in_ring_soup(3)},
      {"pentagon", test::polygon_in_ring_soup(5)},
      {"heptagon", test::polygon_in_ring_soup(7)},
      {"prism of 3", test::prism_soup(3)},
      {"prism of 5", test::prism_soup(5)},
      {"prism of 64", test::prism_soup(64)},
      {"poles of 3", test::trapezohedron_soup(3)},
      {"poles of 64", test::trapezohedron_soup(64)},
      {"poles of 360", test::trapezohedron_soup(360)},
      {"mixed grid", mixed(test::grid_soup(6, 6))},
      {"mixed torus", mixed(test::torus_soup(8, 6))},
      {"holes", test::with_holes(test::torus_soup(9, 7), 9, random)},
      {"mixed holes", test::with_holes(mixed(test::torus_soup(9, 7)), 7, random)},
  };
  for (const auto& [name, soup] : shapes) {
    const MeshPointer mesh = test::control_mesh(test::jittered(soup, 0.1, random));
    expect_exact(*mesh, name, 6, random);
  }
}

TEST(Exactness, HoldsOnRandomQuadMeshes) {
  test::Random random(2);
  for (int i = 0; i < 12; ++i) {
    PolygonSoup soup =
        test::random_quads(i % 2 == 0 ? test::torus_soup(4, 3) : test::grid_soup(4, 3), random);
    if (i % 3 == 0) {
      soup = test::with_holes(soup, 4, random);
    }
    if (i % 4 == 3) {
      soup = test::with_mixed_faces(soup, random);
    }
    const MeshPointer mesh = test::control_mesh(test::jittered(soup, 0.2, random));
    expect_exact(*mesh, fmt::format("random mesh {}", i), 6, random);
  }
}

TEST(Exactness, HoldsOnCreasedShapes) {
  test::Random random(6);
  for (const auto& [name, mesh] : test::creased_shapes()) {
    expect_exact(*mesh, name, 2, random);
  }
  for (int i = 0; i < 4; ++i) {
    const MeshPointer quads =
        test::control_mesh(test::jittered(test::torus_soup(8, 6), 0.1, random));
    const MeshPointer mixed = test::control_mesh(
        test::jittered(test::with_mixed_faces(test::grid_soup(6, 6), random), 0.1, random));
    expect_exact(*test::with_random_creases(*quads, 0.2, 0.05, random), "creased torus", 4, random);
    expect_exact(*test::with_random_creases(*mixed, 0.2, 0.05, random), "creased mix", 4, random);
  }
}

TEST(Exactness, HoldsOnBundledMeshes) {
  test::Random random(3);
  const auto files = test::bundled_mesh_files();
  ASSERT_FALSE(files.empty());
  for (const auto& file : files) {
    const auto imported = import_mesh(file);
    ASSERT_TRUE(imported) << to_string(imported.error());
    expect_exact(*imported->mesh, file.filename().string(), 4, random);
  }
}

TEST(Exactness, HoldsOnTheCorpus) {
  if (!test::corpus_folder()) {
    GTEST_SKIP() << "no corpus of meshes: set LIMN_CORPUS or put one at ../shared/corpus";
  }
  test::Random random(4);
  std::size_t meshes = 0;
  const std::size_t step = test::effort() < 1.0 ? 4 : 1;  // Under sanitizers every fourth will do.
  std::size_t number = 0;
  for (const auto& file : test::corpus_files(".obj")) {
    if (number++ % step != 0) {
      continue;
    }
    const auto imported = import_mesh(file);
    if (imported) {
      ++meshes;
      expect_exact(*imported->mesh, file.filename().string(), 2, random);
    }
  }
  EXPECT_GT(meshes, 0u);
}

TEST(Exactness, IsMissedByTheLeastDeviation) {
  test::Random random(5);
  for (const auto& [name, soup] : {std::pair{"cube", test::cube_soup()},
                                   {"torus", test::torus_soup(9, 6)},
                                   {"grid", test::grid_soup(8, 8)}}) {
    SCOPED_TRACE(name);
    const MeshPointer mesh = test::control_mesh(test::jittered(soup, 0.1, random));
    const test::UniformReference reference(*mesh, 5, CornerRule::kSharp);
    std::vector<std::uint8_t> depths(mesh->face_count(), 0);
    depths[mesh->face_count() / 2] = 5;
    IgnoreProgress progress;
    const auto legal = legal_labels(*mesh, depths, {}, progress);
    ASSERT_TRUE(legal);
    const auto exact = reference.compare(legal->labels, {}, kAllLevels);
    EXPECT_EQ(exact.difference, "");
    EXPECT_EQ(exact.off, 0u);
    EXPECT_LT(exact.greatest_deviation, 2e-7);  // Rounding to float, no more.
    const auto faulty =
        reference.compare_faulty(legal->labels, {}, kAllLevels, [&](RefinedMesh& refined) {
          refined.positions.back().z += static_cast<float>(2e-6 * mesh->bounds().diagonal());
          refined.positions.front().x += static_cast<float>(1e-5 * mesh->bounds().diagonal());
        });
    EXPECT_EQ(faulty.difference, "");
    EXPECT_EQ(faulty.off, 2u);
    EXPECT_GT(faulty.greatest_deviation, 9e-6);
    const auto mislabelled =
        reference.compare_faulty(legal->labels, {}, kAllLevels,
                                 [](RefinedMesh& refined) { --refined.vertex_levels.back(); });
    EXPECT_NE(mislabelled.difference, "");
  }
}

}  // namespace
}  // namespace limn
