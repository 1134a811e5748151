// Demands on finer faces: their labels on whole uniform meshes, and the refinements against
// OpenSubdiv.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "exactness_check.h"
#include "hierarchy_labels.h"
#include "limn/mesh/import.h"
#include "limn/subdivision/fine_places.h"
#include "subdivision/fine/demand_levels.h"
#include "support/attribute_shapes.h"
#include "support/corpus.h"
#include "support/shapes.h"

namespace limn {
namespace {

using test::MeshPointer;

/// Uniform faces that a hierarchy may have.
constexpr double kMostUniformFaces = 12000;

int levels_with_demands(const ControlMesh& mesh) {
  const auto corners = static_cast<double>(mesh.topology().corner_vertices.size());
  return std::clamp(1 + static_cast<int>(std::log(kMostUniformFaces / corners) / std::log(4)), 0,
                    6);
}

LabelsWithDemands labels_with_demands(const ControlMesh& mesh, std::span<const std::uint8_t> depths,
                                      const FineDemands& demands,
                                      const SubdivisionSettings& settings = {}) {
  IgnoreProgress progress;
  return legal_labels(mesh, depths, demands, settings, progress).value();
}

RefinedMesh refined_with_demands(const ControlMesh& mesh, const LabelsWithDemands& labels) {
  IgnoreProgress progress;
  RefineLimits limits;
  limits.normals = true;
  limits.fine = labels.fine.get();
  return refine(mesh, labels.legal.labels, {}, limits, progress).value();
}

template <class T>
bool have_same_bytes(const T& a, const T& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0);
}

bool are_same(const RefinedMesh& a, const RefinedMesh& b) {
  return have_same_bytes(a.positions, b.positions) &&
         have_same_bytes(a.vertex_levels, b.vertex_levels) &&
         have_same_bytes(a.normals, b.normals) && have_same_bytes(a.quads, b.quads) &&
         have_same_bytes(a.polygon_offsets, b.polygon_offsets) &&
         have_same_bytes(a.polygon_vertices, b.polygon_vertices) &&
         have_same_bytes(a.face_control_faces, b.face_control_faces) &&
         have_same_bytes(a.face_levels, b.face_levels) && have_same_bytes(a.uvs, b.uvs) &&
         have_same_bytes(a.quad_uvs, b.quad_uvs) && a.creases == b.creases &&
         a.corners == b.corners;
}

void expect_exact_with_demands(const ControlMesh& mesh, const std::string& name, int paintings,
                               test::Random& random) {
  const int deepest = levels_with_demands(mesh);
  ASSERT_GE(deepest, 3) << name;
  for (const CornerRule corners : {CornerRule::kSharp, CornerRule::kSmooth}) {
    const test::UniformReference reference(mesh, deepest, corners);
    for (int painting = 0; painting < paintings; ++painting) {
      SCOPED_TRACE(fmt::format("{}, painting {}", name, painting));
      SubdivisionSettings settings;
      settings.corners = corners;
      settings.non_quads =
          painting % 2 == 0 ? NonQuadRule::kWherePainted : NonQuadRule::kUniformFirstStep;
      settings.legalisation =
          painting % 3 == 0 ? LegalisationMethod::kGreedy : LegalisationMethod::kLookAhead;
      const auto depths = test::random_depths(mesh, painting % 4 == 1 ? 0.0 : 0.15, 2, random);
      const auto [labels, given] = test::random_fine_painting(
          reference.hierarchy(), mesh, depths, std::size_t{1} << (painting % 5), settings, random);
      ASSERT_EQ(given.breach, "");
      const int levels = painting % 4 == 2 ? 1 + painting % 3 : kAllLevels;
      const auto exactness = reference.compare_fine(labels.legal.labels, labels.fine.get(),
                                                    given.labels, settings, levels);
      ASSERT_EQ(exactness.difference, "");
      ASSERT_EQ(exactness.off, 0u) << exactness.greatest_deviation;
      ASSERT_EQ(test::first_breach(mesh, labels.legal.labels, settings, levels, labels.fine.get()),
                "");
    }
  }
}

TEST(FineLabels, AreExactOnShapesOfEveryKind) {
  test::Random random(11);
  const auto mixed = [&](const PolygonSoup& soup) { return test::with_mixed_faces(soup, random); };
  const std::vector<std::pair<std::string, PolygonSoup>> shapes{
      {"cube", test::cube_soup()},
      {"single quad", test::grid_soup(1, 1)},
      {"grid", test::grid_soup(7, 5)},
      {"torus", test::torus_soup(9, 6)},
      {"narrow torus", test::torus_soup(3, 3)},
      {"triangle", test::polygon_in_ring_soup(3)},
      {"heptagon", test::polygon_in_ring_soup(7)},
      {"prism of 5", test::prism_soup(5)},
      {"poles of 3", test::trapezohedron_soup(3)},
      {"poles of 12", test::trapezohedron_soup(12)},
      {"mixed grid", mixed(test::grid_soup(6, 6))},
      {"mixed holes", test::with_holes(mixed(test::torus_soup(9, 7)), 7, random)},
  };
  for (const auto& [name, soup] : shapes) {
    expect_exact_with_demands(*test::control_mesh(test::jittered(soup, 0.1, random)), name, 8,
                              random);
  }
}

TEST(FineLabels, AreExactOnRandomQuadsAndCreases) {
  test::Random random(12);
  for (int i = 0; i < 4; ++i) {
    const PolygonSoup soup =
        test::random_quads(i % 2 == 0 ? test::torus_soup(4, 3) : test::grid_soup(4, 3), random);
    const MeshPointer mesh = test::control_mesh(test::jittered(soup, 0.2, random));
    expect_exact_with_demands(*mesh, "random quads", 2, random);
    expect_exact_with_demands(*test::with_random_creases(*mesh, 0.2, 0.05, random), "creased", 4,
                              random);
  }
  for (const auto& [name, mesh] : test::creased_shapes()) {
    expect_exact_with_demands(*mesh, name, 1, random);
  }
}

TEST(FineLabels, AreExactOnBundledMeshes) {
  test::Random random(13);
  std::size_t meshes = 0;
  for (const auto& file : test::bundled_mesh_files()) {
    const auto imported = import_mesh(file);
    ASSERT_TRUE(imported) << to_string(imported.error());
    if (levels_with_demands(*imported->mesh) >= 3) {
      expect_exact_with_demands(*imported->mesh, file.filename().string(), 3, random);
      ++meshes;
    }
  }
  EXPECT_GT(meshes, 2u);
}

TEST(FineLabels, WithoutDemandsAreThoseOfDepthsAlone) {
  test::Random random(14);
  const auto mesh = test::mixed_prism();
  for (const NonQuadRule rule : {NonQuadRule::kUniformFirstStep, NonQuadRule::kWherePainted}) {
    SubdivisionSettings settings;
    settings.non_quads = rule;
    const auto depths = test::random_depths(*mesh, 0.3, 3, random);
    IgnoreProgress progress;
    const LabelsWithDemands labels = labels_with_demands(*mesh, depths, {}, settings);
    EXPECT_EQ(labels.fine, nullptr);
    EXPECT_EQ(labels.legal.labels, legal_labels(*mesh, depths, settings, progress)->labels);
  }
}

TEST(FineLabels, ChangeNothingThatIsThereAnyway) {
  // Demands on less than the paint asks for: the same mesh, another way, and all of it.
  test::Random random(15);
  const auto mesh = test::control_mesh(test::jittered(test::grid_soup(9, 8), 0.1, random));
  auto depths = test::random_depths(*mesh, 0.2, 3, random);
  depths[30] = 3;
  const LabelsWithDemands plain = labels_with_demands(*mesh, depths, {});
  const LabelsWithDemands fine =
      labels_with_demands(*mesh, depths, FineDemands(std::vector{FineDemand{{30, 0, 1, 1, 0}, 3}}));
  ASSERT_NE(fine.fine, nullptr);
  EXPECT_EQ(fine.legal.labels, plain.legal.labels);
  const RefinedMesh a = refined_with_demands(*mesh, plain);
  const RefinedMesh b = refined_with_demands(*mesh, fine);
  ASSERT_EQ(a.vertex_count(), b.vertex_count());
  ASSERT_EQ(a.face_count(), b.face_count());
  const auto vertices_of = [](const RefinedMesh& of) {
    std::vector<std::tuple<long, long, long, int>> all;
    for (std::size_t v = 0; v < of.vertex_count(); ++v) {
      const glm::dvec3 p = of.position(v) * 1e4;
      all.emplace_back(std::lround(p.x), std::lround(p.y), std::lround(p.z), of.vertex_levels[v]);
    }
    std::ranges::sort(all);
    return all;
  };
  const auto a_vertices = vertices_of(a);
  const auto b_vertices = vertices_of(b);
  for (std::size_t v = 0; v < a_vertices.size(); ++v) {
    EXPECT_LE(std::abs(std::get<0>(a_vertices[v]) - std::get<0>(b_vertices[v])), 1);
    EXPECT_EQ(std::get<3>(a_vertices[v]), std::get<3>(b_vertices[v]));
  }
}

TEST(FineLabels, GiveTheSameBytesInWhateverOrderOnePaints) {
  test::Random random(16);
  const auto mesh = test::control_mesh(
      test::jittered(test::with_mixed_faces(test::grid_soup(12, 10), random), 0.1, random));
  const auto depths = test::random_depths(*mesh, 0.1, 2, random);
  auto strokes = test::random_demands(*mesh, 40, 5, random);
  const RefinedMesh once =
      refined_with_demands(*mesh, labels_with_demands(*mesh, depths, FineDemands(strokes)));
  ASSERT_GT(once.face_count(), 1000u);
  for (int i = 0; i < 4; ++i) {
    std::ranges::shuffle(strokes, random);
    FineDemands demands;
    for (const FineDemand& stroke : strokes) {
      demands.raise({&stroke, 1});
    }
    EXPECT_TRUE(
        are_same(once, refined_with_demands(*mesh, labels_with_demands(*mesh, depths, demands))));
  }
}

TEST(FineLabels, GiveTheSameBytesForAnyNumberOfThreads) {
  test::Random random(17);
  const auto mesh = test::control_mesh(
      test::jittered(test::with_mixed_faces(test::grid_soup(40, 30), random), 0.1, random));
  const auto depths = test::random_depths(*mesh, 0.1, 3, random);
  const LabelsWithDemands labels =
      labels_with_demands(*mesh, depths, FineDemands(test::random_demands(*mesh, 60, 6, random)));
  const auto refined_by = [&](int threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    return arena.execute([&] { return refined_with_demands(*mesh, labels); });
  };
  const RefinedMesh alone = refined_by(1);
  for (const int threads : {2, 7}) {
    EXPECT_TRUE(are_same(alone, refined_by(threads)));
  }
}

TEST(FineLabels, ConcernOnlyWhatIsAroundADemand) {
  // One face of level 3 in the middle of a grid, up to level 6.
  const auto mesh = test::control_mesh(test::grid_soup(9, 9));
  const std::vector<std::uint8_t> depths(mesh->face_count(), 0);
  const LabelsWithDemands labels =
      labels_with_demands(*mesh, depths, FineDemands(std::vector{FineDemand{{40, 0, 3, 3, 4}, 6}}));
  const RefinedMesh mesh_of_demand = refined_with_demands(*mesh, labels);
  EXPECT_LT(mesh_of_demand.face_count(), 500u);
  std::map<std::uint32_t, int> deepest;
  for (std::size_t f = 0; f < mesh_of_demand.face_count(); ++f) {
    int& level = deepest[mesh_of_demand.face_control_faces[f]];
    level = std::max<int>(level, mesh_of_demand.face_levels[f]);
  }
  EXPECT_EQ(deepest[40], 6);
  EXPECT_LE(deepest[39], 2);
  EXPECT_EQ(deepest[0], 0);
  // The 64 faces of level 6 that were asked for are there.
  EXPECT_GE(std::ranges::count(mesh_of_demand.face_levels, 6), 64);
}

TEST(FineLabels, NoticeWhenFacesFurtherAwayAreConcerned) {
  const auto mesh = test::control_mesh(test::grid_soup(9, 9));
  const VertexLabels labels(mesh->vertex_count(), 0);
  const FineDemands demands(std::vector{FineDemand{{40, 0, 1, 0, 0}, 2}});
  EXPECT_FALSE(DemandLevels(*mesh, demands, labels, 0).close());
  EXPECT_FALSE(DemandLevels(*mesh, demands, labels, 1).close());
  EXPECT_TRUE(DemandLevels(*mesh, demands, labels, 2).close());
}

TEST(FineLabels, TellWhatIsStillSharp) {
  test::Random random(18);
  for (const auto& [name, mesh] : test::creased_shapes()) {
    SCOPED_TRACE(name);
    constexpr int kLevels = 4;
    const test::UniformReference reference(*mesh, kLevels, CornerRule::kSharp);
    const test::UniformHierarchy& hierarchy = reference.hierarchy();
    const auto depths = test::random_depths(*mesh, 0.1, 2, random);
    const auto [labels, given] =
        test::random_fine_painting(hierarchy, *mesh, depths, 12, {}, random);
    const RefinedMesh result = refined_with_demands(*mesh, labels);
    const auto references = reference.references_fine(labels.legal.labels, labels.fine.get(),
                                                      given.labels, {}, kAllLevels);
    ASSERT_EQ(references.size(), result.vertex_count());
    // Vertices by their numbers at the last level, where those of all levels are; so edges of all
    // levels differ.
    const auto at_last_level = [&](int level, std::uint32_t v) {
      for (; level < kLevels; ++level) {
        v = hierarchy.child_of_vertex(level, v);
      }
      return v;
    };
    using Edge = std::pair<std::uint32_t, std::uint32_t>;
    std::map<Edge, float> sharpness;
    for (int level = 0; level <= kLevels; ++level) {
      for (std::uint32_t e = 0; e < hierarchy.edge_count(level); ++e) {
        const auto [a, b] = hierarchy.edge_vertices(level, e);
        sharpness[std::minmax(at_last_level(level, a), at_last_level(level, b))] =
            hierarchy.edge_sharpness(level, e);
      }
    }
    const auto edge_of = [&](std::uint32_t a, std::uint32_t b) -> Edge {
      return std::minmax(at_last_level(references[a].level, references[a].index),
                         at_last_level(references[b].level, references[b].index));
    };
    std::map<Edge, int> faces_of_edges;
    for (std::size_t f = 0; f < result.face_count(); ++f) {
      const auto face = result.face(f);
      for (std::size_t i = 0; i < face.size(); ++i) {
        ++faces_of_edges[edge_of(face[i], face[(i + 1) % face.size()])];
      }
    }
    std::map<Edge, float> expected;
    for (const auto& [edge, faces] : faces_of_edges) {
      // Edges beside the coarse quads of a Y-element are nobody's.
      const auto found = sharpness.find(edge);
      if (faces == 2 && found != sharpness.end() && found->second > 0.0f) {
        expected.insert(*found);
      }
    }
    std::map<Edge, float> found;
    for (const RefinedCrease& crease : result.creases) {
      EXPECT_TRUE(
          found.emplace(edge_of(crease.vertices[0], crease.vertices[1]), crease.sharpness).second);
    }
    EXPECT_EQ(found, expected);
  }
}

TEST(FinePlaces, AreWhereTheFacesLie) {
  test::Random random(19);
  const std::vector<PolygonSoup> soups{test::grid_soup(5, 4), test::polygon_in_ring_soup(5),
                                       test::with_mixed_faces(test::grid_soup(7, 6), random),
                                       test::trapezohedron_soup(3)};
  for (const PolygonSoup& soup : soups) {
    const auto mesh = test::control_mesh(test::jittered(soup, 0.1, random));
    constexpr int kLevels = 4;
    const test::UniformReference reference(*mesh, kLevels, CornerRule::kSharp);
    const test::UniformHierarchy& hierarchy = reference.hierarchy();
    const auto at_last_level = [&](int level, std::uint32_t v) {
      for (; level < kLevels; ++level) {
        v = hierarchy.child_of_vertex(level, v);
      }
      return v;
    };
    for (int painting = 0; painting < 6; ++painting) {
      SubdivisionSettings settings;
      settings.non_quads =
          painting % 2 == 0 ? NonQuadRule::kWherePainted : NonQuadRule::kUniformFirstStep;
      const auto depths = test::random_depths(*mesh, 0.3, 3, random);
      const auto [labels, given] = test::random_fine_painting(
          hierarchy, *mesh, depths, painting < 2 ? 0 : 5, settings, random);
      RefineLimits limits;
      limits.fine = labels.fine.get();
      limits.levels = painting == 5 ? 2 : kAllLevels;
      IgnoreProgress progress;
      const RefinedMesh result =
          refine(*mesh, labels.legal.labels, settings, limits, progress).value();
      const auto references = reference.references_fine(labels.legal.labels, labels.fine.get(),
                                                        given.labels, settings, limits.levels);
      ASSERT_EQ(references.size(), result.vertex_count());
      std::vector<std::uint32_t> every(result.face_count());
      std::iota(every.begin(), every.end(), 0U);
      const RefinedFrom from{mesh.get(), &labels.legal.labels, labels.fine.get(), limits.levels};
      const auto places = places_of(from, result, every);
      ASSERT_EQ(places.size(), every.size());
      for (const std::uint32_t f : every) {
        ASSERT_EQ(places[f].level, result.face_levels[f]);
        ASSERT_EQ(places[f].control_face, result.face_control_faces[f]);
        ASSERT_TRUE(places[f].level == 0 || is_face_of(*mesh, places[f]));
        auto uniform =
            hierarchy.face_vertices(places[f].level, test::find_face(hierarchy, *mesh, places[f]));
        std::ranges::transform(uniform, uniform.begin(),
                               [&](std::uint32_t v) { return at_last_level(places[f].level, v); });
        const auto common = std::ranges::count_if(result.face(f), [&](std::uint32_t v) {
          const std::uint32_t last = at_last_level(references[v].level, references[v].index);
          return std::ranges::find(uniform, last) != uniform.end();
        });
        // All, but for the coarse quads of Y-elements.
        ASSERT_GE(common + 1, static_cast<std::ptrdiff_t>(result.face(f).size()));
      }
      // The same for some as for all.
      std::vector<std::uint32_t> some;
      std::ranges::copy_if(every, std::back_inserter(some),
                           [&](std::uint32_t) { return random() % 5 == 0; });
      const auto some_places = places_of(from, result, some);
      for (std::size_t i = 0; i < some.size(); ++i) {
        ASSERT_EQ(some_places[i], places[some[i]]);
      }
    }
  }
}

TEST(FineLabels, AreRefusedBeyondTheBudget) {
  const auto mesh = test::cube();
  const std::vector<std::uint8_t> depths(6, 0);
  const LabelsWithDemands labels =
      labels_with_demands(*mesh, depths, FineDemands(std::vector{FineDemand{{0, 0, 1, 0, 0}, 7}}));
  const RefinementPrediction prediction =
      predict_refinement(*mesh, labels.legal.labels, kAllLevels, labels.fine.get());
  RefineLimits limits;
  limits.fine = labels.fine.get();
  limits.face_budget = prediction.faces - 1;
  IgnoreProgress progress;
  EXPECT_EQ(refine(*mesh, labels.legal.labels, {}, limits, progress).error().kind,
            ErrorKind::kOverBudget);
  limits.face_budget = prediction.faces;
  EXPECT_EQ(refine(*mesh, labels.legal.labels, {}, limits, progress)->face_count(),
            prediction.faces);
}

}  // namespace
}  // namespace limn
