// Refinements made by compute shaders against those of the CPU: the same numbers everywhere, and
// positions to 1e-6 of the diagonal.
#include "render/refinement/gpu_refiner.h"

#include <array>
#include <cmath>
#include <memory>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "limn/mesh/bundled.h"
#include "limn/subdivision/labels.h"
#include "support/attribute_shapes.h"
#include "support/effort.h"
#include "support/gl_fixture.h"
#include "support/shapes.h"

namespace limn::render {
namespace {

using test::MeshPointer;
using Depths = std::vector<std::uint8_t>;

class GpuRefinementTest : public test::GlFixture {
 protected:
  // One for all tests: software drivers take seconds to compile its programs.
  static void SetUpTestSuite() {
    GlFixture::SetUpTestSuite();
    refiner = std::make_unique<GpuRefiner>();
    surface = std::make_unique<SurfaceBuffers>();
  }
  static void TearDownTestSuite() {
    refiner.reset();
    surface.reset();
    GlFixture::TearDownTestSuite();
  }

  void expect_same(const ControlMesh& mesh, const VertexLabels& labels,
                   const SubdivisionSettings& settings = {}, const RefineLimits& limits = {}) {
    IgnoreProgress progress;
    const Result<RefinedMesh> expected = refine(mesh, labels, settings, limits, progress);
    ASSERT_TRUE(expected);
    const GpuRefinementRequest request{mesh, labels, settings, limits, 1, true};
    const auto counts = refiner->refine(request, progress, *surface);
    ASSERT_TRUE(counts) << to_string(counts.error());
    const RefinedMesh actual = refiner->read_back(request, *surface);
    EXPECT_EQ(counts->vertices, expected->vertex_count());
    EXPECT_EQ(counts->quads, expected->quads.size());
    EXPECT_TRUE(actual.quads == expected->quads);
    EXPECT_TRUE(actual.polygon_offsets == expected->polygon_offsets);
    EXPECT_TRUE(actual.polygon_vertices == expected->polygon_vertices);
    EXPECT_TRUE(actual.face_control_faces == expected->face_control_faces);
    EXPECT_TRUE(actual.face_levels == expected->face_levels);
    EXPECT_TRUE(actual.vertex_levels == expected->vertex_levels);
    EXPECT_TRUE(actual.creases == expected->creases);
    EXPECT_TRUE(actual.corners == expected->corners);
    ASSERT_EQ(actual.vertex_count(), expected->vertex_count());
    expect_same_normals(actual, *expected);
    const double diagonal = mesh.bounds().diagonal();
    for (std::size_t v = 0; v < actual.vertex_count(); ++v) {
      const double off = glm::distance(actual.position(v), expected->position(v)) / diagonal;
      // Written so that a number that is none fails too.
      ASSERT_TRUE(off <= 1e-6) << "vertex " << v << " of level " << int{expected->vertex_levels[v]}
                               << " is " << off << " off";
    }
  }

  void expect_same(const ControlMesh& mesh, const Depths& depths,
                   const SubdivisionSettings& settings, int levels) {
    IgnoreProgress progress;
    const auto legal = legal_labels(mesh, depths, settings, progress);
    ASSERT_TRUE(legal);
    RefineLimits limits;
    limits.levels = levels;
    expect_same(mesh, legal->labels, settings, limits);
    limits.normals = true;
    expect_same(mesh, legal->labels, settings, limits);
    SubdivisionSettings on_limit = settings;
    on_limit.points = SurfacePoints::kLimit;
    expect_same(mesh, legal->labels, on_limit, limits);
  }

  /// To 0.1 degree, where there is a tangent plane.
  static void expect_same_normals(const RefinedMesh& actual, const RefinedMesh& expected) {
    ASSERT_EQ(actual.normals.size(), expected.normals.size());
    for (std::size_t v = 0; v < expected.normals.size(); ++v) {
      const glm::dvec3 normal(expected.normals[v]);
      const glm::dvec3 other(actual.normals[v]);
      if (normal != glm::dvec3(0.0)) {
        ASSERT_NEAR(glm::length(other), 1.0, 1e-5) << "vertex " << v;
        ASSERT_LE(glm::length(glm::cross(normal, other)), std::sin(glm::radians(0.1)))
            << "vertex " << v << " of level " << int{expected.vertex_levels[v]};
        ASSERT_GT(glm::dot(normal, other), 0.0);
      } else {
        ASSERT_EQ(other, normal) << "vertex " << v;
      }
    }
  }

  static inline std::unique_ptr<GpuRefiner> refiner;
  static inline std::unique_ptr<SurfaceBuffers> surface;
};

Depths even(const ControlMesh& mesh, std::uint8_t depth) {
  return Depths(mesh.face_count(), depth);
}

TEST_F(GpuRefinementTest, UniformCubes) {
  const MeshPointer cube = test::cube();
  for (std::uint8_t depth = 0; depth <= 6; ++depth) {
    SCOPED_TRACE(int{depth});
    expect_same(*cube, even(*cube, depth), {}, kAllLevels);
  }
}

TEST_F(GpuRefinementTest, RegularTorus) {
  const MeshPointer torus = test::control_mesh(test::torus_soup(7, 5));
  for (const int depth : {1, 2, 5}) {
    expect_same(*torus, even(*torus, static_cast<std::uint8_t>(depth)), {}, kAllLevels);
  }
}

TEST_F(GpuRefinementTest, OpenGrid) {
  const MeshPointer grid = test::control_mesh(test::grid_soup(4, 3));
  for (const CornerRule corners : {CornerRule::kSharp, CornerRule::kSmooth}) {
    expect_same(*grid, even(*grid, 4), {.corners = corners}, kAllLevels);
  }
}

TEST_F(GpuRefinementTest, CubeWithOnePaintedFace) {
  const MeshPointer cube = test::cube();
  for (std::uint8_t depth = 1; depth <= 8; ++depth) {
    SCOPED_TRACE(int{depth});
    Depths depths = even(*cube, 0);
    depths[0] = depth;
    expect_same(*cube, depths, {}, kAllLevels);
  }
}

/// Calls `visit` with all labels 0..greatest of a mesh that are legal.
template <class Visit>
void for_each_legal(const ControlMesh& mesh, std::uint8_t greatest, const Visit& visit) {
  VertexLabels labels(mesh.vertex_count(), 0);
  while (true) {
    if (illegal_faces(mesh, labels, LegalisationMethod::kLookAhead).empty()) {
      visit(labels);
    }
    auto digit = labels.begin();
    while (digit != labels.end() && *digit == greatest) {
      *digit++ = 0;
    }
    if (digit == labels.end()) {
      return;
    }
    ++*digit;
  }
}

TEST_F(GpuRefinementTest, EveryLegalLabellingOfOneQuadAndOfTwo) {
  const MeshPointer one = test::grid(1);
  for_each_legal(*one, 3, [&](const VertexLabels& labels) { expect_same(*one, labels); });
  const MeshPointer two = test::control_mesh(test::grid_soup(2, 1));
  for_each_legal(*two, 2, [&](const VertexLabels& labels) { expect_same(*two, labels); });
}

TEST_F(GpuRefinementTest, FacesThatAreNoQuads) {
  const MeshPointer prism = test::mixed_prism();
  for (const NonQuadRule rule : {NonQuadRule::kUniformFirstStep, NonQuadRule::kWherePainted}) {
    expect_same(*prism, even(*prism, 3), {.non_quads = rule}, kAllLevels);
    for (std::size_t f = 0; f < prism->face_count(); ++f) {
      Depths depths = even(*prism, 0);
      depths[f] = 3;
      expect_same(*prism, depths, {.non_quads = rule}, kAllLevels);
    }
  }
}

TEST_F(GpuRefinementTest, CreasedShapes) {
  for (const auto& [name, mesh] : test::creased_shapes()) {
    SCOPED_TRACE(name);
    expect_same(*mesh, even(*mesh, 4), {}, kAllLevels);
    test::Random random(7);
    expect_same(*mesh, test::random_depths(*mesh, 0.3, 4, random), {}, kAllLevels);
  }
}

TEST_F(GpuRefinementTest, RandomPaintings) {
  test::Random random(20261122);
  const int count = static_cast<int>(40 * test::effort());
  for (int i = 0; i < count; ++i) {
    SCOPED_TRACE(i);
    PolygonSoup soup = i % 2 == 0 ? test::torus_soup(6, 5) : test::grid_soup(6, 5);
    if (i % 4 == 1) {
      soup = test::random_quads(soup, random);
    } else if (i % 4 == 2) {
      soup = test::with_mixed_faces(soup, random);
    }
    if (i % 6 == 5) {
      soup = test::with_holes(soup, 3, random);
    }
    MeshPointer mesh = test::control_mesh(test::jittered(soup, 0.1, random));
    if (i % 3 == 2) {
      mesh = test::with_random_creases(*mesh, 0.2, 0.05, random);
    }
    const Depths depths = test::random_depths(*mesh, i % 8 < 3 ? 0.05 : 0.3, 1 + i % 5, random);
    SubdivisionSettings settings;
    settings.non_quads = i % 3 == 0 ? NonQuadRule::kUniformFirstStep : NonQuadRule::kWherePainted;
    settings.legalisation =
        i % 5 < 3 ? LegalisationMethod::kLookAhead : LegalisationMethod::kGreedy;
    expect_same(*mesh, depths, settings, i % 7 == 0 ? 2 : kAllLevels);
    if (HasFatalFailure()) {
      return;
    }
  }
}

TEST_F(GpuRefinementTest, BundledCreature) {
  const Result<ImportedMesh> creature = load_bundled_mesh("creature");
  ASSERT_TRUE(creature);
  test::Random random(3);
  expect_same(*creature->mesh, test::random_depths(*creature->mesh, 0.05, 5, random), {},
              kAllLevels);
}

TEST_F(GpuRefinementTest, TheSameBytesEveryTime) {
  const MeshPointer prism = test::mixed_prism();
  VertexLabels labels(prism->vertex_count(), 3);
  labels.front() = 5;
  IgnoreProgress progress;
  RefineLimits limits;
  limits.normals = true;
  const GpuRefinementRequest request{*prism, labels, {}, limits};
  const auto bytes_of_run = [&] {
    EXPECT_TRUE(refiner->refine(request, progress, *surface));
    return std::array{
        surface->positions().read<std::uint32_t>(), surface->normals().read<std::uint32_t>(),
        surface->corners().read<std::uint32_t>(), surface->faces().read<std::uint32_t>()};
  };
  const auto first = bytes_of_run();
  EXPECT_GT(first[0].size(), 1000U);
  ASSERT_TRUE(refiner->refine({*test::cube(), VertexLabels(8, 4), {}, {}}, progress, *surface));
  EXPECT_TRUE(bytes_of_run() == first);
}

TEST_F(GpuRefinementTest, SmallerAfterLarger) {
  // Buffers keep what they had.
  const MeshPointer cube = test::cube();
  const MeshPointer prism = test::mixed_prism();
  for (const int depth : {5, 0, 3, 1}) {
    SCOPED_TRACE(depth);
    expect_same(*cube, even(*cube, static_cast<std::uint8_t>(depth)), {}, kAllLevels);
    expect_same(*prism, even(*prism, static_cast<std::uint8_t>(depth)), {}, kAllLevels);
  }
}

TEST_F(GpuRefinementTest, FarFromTheOrigin) {
  PolygonSoup soup = test::cube_soup();
  for (glm::dvec3& position : soup.positions) {
    position += glm::dvec3(1e6, -2e6, 5e5);
  }
  const MeshPointer cube = test::control_mesh(soup);
  expect_same(*cube, even(*cube, 5), {}, kAllLevels);
}

TEST_F(GpuRefinementTest, RefusesWhatIsOverTheBudget) {
  const MeshPointer cube = test::cube();
  IgnoreProgress progress;
  const VertexLabels labels(8, 5);
  const auto result =
      refiner->refine({*cube, labels, {}, {.face_budget = 6143}}, progress, *surface);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::kOverBudget);
  EXPECT_THAT(result.error().message, testing::HasSubstr("6144 faces"));
}

TEST_F(GpuRefinementTest, NamesTheLimitThatDoesNotSuffice) {
  // 151 million faces: more than any driver lets a shader see, whose corners are 2.4 GB.
  IgnoreProgress progress;
  const MeshPointer torus = test::control_mesh(test::torus_soup(12, 12));
  const VertexLabels labels(torus->vertex_count(), 10);
  const auto refused = refiner->refine({*torus, labels, {}, {}}, progress, *surface);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kEnvironment);
  EXPECT_THAT(refused.error().message, testing::HasSubstr("GL_MAX_SHADER_STORAGE_BLOCK_SIZE"));
}

}  // namespace
}  // namespace limn::render
