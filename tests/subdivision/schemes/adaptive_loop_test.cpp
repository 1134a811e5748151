#include "limn/subdivision/schemes/adaptive_loop.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <glm/geometric.hpp>

#include "limn/mesh/statistics.h"
#include "limn/subdivision/crack_check.h"
#include "limn/subdivision/settings.h"
#include "scheme_shapes.h"
#include "support/effort.h"
#include "support/surface_match.h"

namespace limn {
namespace {

using test::MeshPointer;
using test::subdivided;
using Depths = std::vector<std::uint8_t>;

RefinedMesh refined(const ControlMesh& mesh, const Depths& depths,
                    const AdaptiveLoopSettings& settings = {}) {
  IgnoreProgress progress;
  return refine_by_loop(mesh, depths, settings, progress).value();
}

/// Closed, open and creased, no two vertices in one place.
std::vector<test::NamedShape> triangle_shapes(test::Random& random) {
  std::vector<test::NamedShape> shapes;
  for (const test::NamedShape& shape : test::shapes_for(Scheme::kLoop)) {
    if (static_cast<double>(shape.mesh->face_count()) < 400 * test::effort()) {
      shapes.push_back({shape.name, test::set_apart(*shape.mesh, 0.01, random)});
      shapes.push_back({shape.name + ", creased",
                        test::with_random_creases(*shapes.back().mesh, 0.3, 0.05, random)});
    }
  }
  return shapes;
}

TEST(BalancedDepths, AreTheLeastThatDifferByOne) {
  test::Random random(51);
  for (const test::NamedShape& shape : triangle_shapes(random)) {
    const ControlMesh& mesh = *shape.mesh;
    for (int round = 0; round < 20; ++round) {
      const Depths depths = test::random_depths(mesh, 0.1, kMaxDepth, random);
      // Faces lifted one by one until none is too low.
      Depths expected = depths;
      for (bool is_lifted = true; is_lifted;) {
        is_lifted = false;
        for (const auto& [one, other] : mesh.topology().edge_corners) {
          if (other == kNone) {
            continue;
          }
          std::uint8_t& a = expected[mesh.topology().corner_faces[one]];
          std::uint8_t& b = expected[mesh.topology().corner_faces[other]];
          std::uint8_t& lower = a < b ? a : b;
          if (std::max(a, b) > lower + 1) {
            lower = static_cast<std::uint8_t>(std::max(a, b) - 1);
            is_lifted = true;
          }
        }
      }
      ASSERT_EQ(balanced_depths(mesh, depths), expected) << shape.name;
    }
  }
}

/// Positions of uniform Loop, level by level.
std::vector<std::vector<glm::dvec3>> uniform_positions(const ControlMesh& mesh, int levels) {
  std::vector<std::vector<glm::dvec3>> positions;
  for (int level = 0; level <= levels; ++level) {
    positions.push_back(test::plain(subdivided(mesh, {.scheme = Scheme::kLoop}, level)).positions);
  }
  return positions;
}

/// Whether each vertex of a level is one of uniform Loop's at that level, and no other's.
void expect_exact(const RefinedMesh& mesh, const std::vector<std::vector<glm::dvec3>>& uniform,
                  double tolerance) {
  for (std::size_t level = 0; level < uniform.size(); ++level) {
    std::vector<glm::dvec3> made;
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
      if (mesh.vertex_levels[v] == level) {
        made.push_back(mesh.position(v));
      }
    }
    ASSERT_EQ(test::matching_vertices(made, uniform[level], tolerance).size(), made.size())
        << "level " << level;
  }
}

TEST(AdaptiveLoop, IsExactAndWithoutCracks) {
  test::Random random(52);
  for (const test::NamedShape& shape : triangle_shapes(random)) {
    const ControlMesh& mesh = *shape.mesh;
    constexpr int kDeepest = 4;
    const auto uniform = uniform_positions(mesh, kDeepest);
    for (int round = 0; round < 4; ++round) {
      SCOPED_TRACE(fmt::format("{}, painting {}", shape.name, round));
      const Depths depths = balanced_depths(
          mesh, test::random_depths(mesh, round == 0 ? 0.02 : 0.15 * round, kDeepest, random));
      const RefinedMesh result = refined(mesh, depths);
      const SchemeCounts foretold = predict_adaptive_loop(mesh, depths);
      const CrackCheck cracks = check_cracks(mesh, result);
      EXPECT_TRUE(cracks.is_watertight());
      const MeshStatistics after = mesh_statistics(*to_control_mesh(result));
      EXPECT_EQ((SchemeCounts{after.vertices, after.edges, after.faces}), foretold);
      EXPECT_EQ(after.faces_by_sides.size(), 1u);
      EXPECT_EQ(after.euler_characteristic, mesh_statistics(mesh).euler_characteristic);
      ASSERT_NO_FATAL_FAILURE(expect_exact(result, uniform, 2e-6 * mesh.bounds().diagonal()));
    }
  }
}

// The level a vertex lies at is that of the deepest face around it.
TEST(AdaptiveLoop, TakesVerticesAsFarAsTheirDeepestFace) {
  test::Random random(53);
  for (const test::NamedShape& shape : triangle_shapes(random)) {
    const Depths depths =
        balanced_depths(*shape.mesh, test::random_depths(*shape.mesh, 0.2, 3, random));
    const RefinedMesh result = refined(*shape.mesh, depths);
    for (std::size_t v = 0; v < shape.mesh->vertex_count(); ++v) {
      const FlatTopology& flat = shape.mesh->topology();
      std::uint8_t deepest = 0;
      for (std::uint32_t i = flat.vertex_offsets[v]; i < flat.vertex_offsets[v + 1]; ++i) {
        deepest = std::max(deepest, depths[flat.corner_faces[flat.vertex_corners[i]]]);
      }
      ASSERT_EQ(result.vertex_levels[v], deepest) << shape.name;
    }
    for (std::size_t f = 0; f < result.face_count(); ++f) {
      ASSERT_EQ(result.face_levels[f], depths[result.face_control_faces[f]]);
    }
  }
}

TEST(AdaptiveLoop, IsUniformWhereAllDepthsAreEqual) {
  test::Random random(54);
  for (const test::NamedShape& shape : triangle_shapes(random)) {
    for (std::uint8_t depth = 0; depth <= 3; ++depth) {
      for (const LoopWeights weights : {LoopWeights::kOriginal, LoopWeights::kWarren}) {
        for (const CornerRule corners : {CornerRule::kSharp, CornerRule::kSmooth}) {
          const RefinedMesh result = refined(*shape.mesh, Depths(shape.mesh->face_count(), depth),
                                             {.weights = weights, .corners = corners});
          const SchemeSettings settings{
              .scheme = Scheme::kLoop, .weights = weights, .corners = corners};
          const RefinedMesh uniform = subdivided(*shape.mesh, settings, depth);
          ASSERT_EQ(test::surface_difference(test::plain(result), test::plain(uniform),
                                             1e-6 * shape.mesh->bounds().diagonal()),
                    "")
              << shape.name << ", depth " << int{depth};
          EXPECT_EQ(result.creases.size(), uniform.creases.size()) << shape.name;
          EXPECT_EQ(result.corners, uniform.corners) << shape.name;
        }
      }
    }
  }
}

// Every sharp edge is drawn once, where the finer side has it.
TEST(AdaptiveLoop, ListsEachSharpEdgeOnce) {
  test::Random random(55);
  for (const test::NamedShape& shape : triangle_shapes(random)) {
    const Depths depths =
        balanced_depths(*shape.mesh, test::random_depths(*shape.mesh, 0.3, 3, random));
    const RefinedMesh result = refined(*shape.mesh, depths);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t f = 0; f < result.face_count(); ++f) {
      const auto face = result.face(f);
      for (std::size_t i = 0; i < 3; ++i) {
        ++edges[std::minmax(face[i], face[(i + 1) % 3])];
      }
    }
    std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
    for (const RefinedCrease& crease : result.creases) {
      const auto edge = std::minmax(crease.vertices[0], crease.vertices[1]);
      EXPECT_EQ(edges[edge], 2) << shape.name;
      EXPECT_TRUE(seen.insert(edge).second) << shape.name;
    }
  }
}

TEST(AdaptiveLoop, GivesTheSameBytesForAnyNumberOfThreads) {
  test::Random random(56);
  const MeshPointer torus =
      make_fit(*test::control_mesh(test::jittered(test::torus_soup(60, 40), 0.01, random)),
               Fitting::kTriangulate);
  const Depths depths = balanced_depths(*torus, test::random_depths(*torus, 0.02, 5, random));
  const auto on_threads = [&](int threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    return arena.execute([&] { return refined(*torus, depths); });
  };
  const RefinedMesh alone = on_threads(1);
  for (const int threads : {2, 7}) {
    const RefinedMesh together = on_threads(threads);
    EXPECT_EQ(alone.polygon_vertices, together.polygon_vertices);
    ASSERT_EQ(alone.vertex_count(), together.vertex_count());
    EXPECT_EQ(std::memcmp(alone.positions.data(), together.positions.data(),
                          alone.vertex_count() * sizeof(glm::vec3)),
              0);
  }
}

TEST(AdaptiveLoop, KeepsToTheBudgetAndToTriangles) {
  const MeshPointer mesh = test::fitted(test::cube(), Scheme::kLoop);
  const Depths depths(mesh->face_count(), 2);
  IgnoreProgress progress;
  const Result<RefinedMesh> over = refine_by_loop(*mesh, depths, {.face_budget = 191}, progress);
  ASSERT_FALSE(over);
  EXPECT_EQ(over.error().kind, ErrorKind::kOverBudget);
  EXPECT_TRUE(refine_by_loop(*mesh, depths, {.face_budget = 192}, progress));
  const Result<RefinedMesh> quads = refine_by_loop(*test::cube(), Depths(6, 1), {}, progress);
  ASSERT_FALSE(quads);
  EXPECT_NE(quads.error().message.find("triangles"), std::string::npos);
}

}  // namespace
}  // namespace limn
