// What holds for every scheme, on shapes of every kind.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "limn/mesh/statistics.h"
#include "limn/subdivision/schemes/uniform.h"
#include "scheme_shapes.h"
#include "support/effort.h"
#include "support/surface_match.h"

namespace limn {
namespace {

using test::MeshPointer;
using test::subdivided;

std::string test_name(Scheme scheme) {
  std::string name(scheme_info(scheme).name);
  std::erase(name, '-');
  return name;
}

/// Levels after which a shape still has few faces.
int few_levels(const ControlMesh& mesh) {
  return mesh.topology().corner_vertices.size() < 400 ? 3 : 2;
}

class EveryScheme : public testing::TestWithParam<Scheme> {
 protected:
  static SchemeSettings settings(CornerRule corners = CornerRule::kSharp) {
    SchemeSettings settings;
    settings.scheme = GetParam();
    settings.corners = corners;
    return settings;
  }
};

INSTANTIATE_TEST_SUITE_P(Schemes, EveryScheme,
                         testing::Values(Scheme::kLinear, Scheme::kCatmullClark, Scheme::kLoop,
                                         Scheme::kButterfly, Scheme::kKobbelt, Scheme::kSqrt3,
                                         Scheme::kDooSabin, Scheme::kMidedge, Scheme::kBiquartic),
                         [](const auto& with) { return test_name(with.param); });

TEST_P(EveryScheme, HasAnEntry) {
  const SchemeInfo& info = scheme_info(GetParam());
  EXPECT_EQ(info.scheme, GetParam());
  EXPECT_EQ(scheme_named(info.name), GetParam());
  for (const std::string_view text :
       {info.title, info.makes, info.continuity, info.boundary, info.source}) {
    EXPECT_FALSE(text.empty()) << info.name;
  }
}

TEST(Schemes, UnknownNamesAreNone) {
  EXPECT_FALSE(scheme_named("catmull").has_value());
}

// A closed surface stays closed, a boundary keeps its loops, and the counts are those foretold.
TEST_P(EveryScheme, MakesTheManifoldThatWasForetold) {
  for (const CornerRule corners : {CornerRule::kSharp, CornerRule::kSmooth}) {
    for (const test::NamedShape& shape : test::shapes_for(GetParam())) {
      const MeshStatistics before = mesh_statistics(*shape.mesh);
      const int levels = few_levels(*shape.mesh) + 1;
      const auto foretold = predict_scheme(*shape.mesh, settings(corners), levels);
      ASSERT_EQ(foretold.size(), static_cast<std::size_t>(levels) + 1);
      for (int level = 0; level <= levels; ++level) {
        SCOPED_TRACE(fmt::format("{}, level {}", shape.name, level));
        const RefinedMesh result = subdivided(*shape.mesh, settings(corners), level);
        const MeshStatistics after = mesh_statistics(*to_control_mesh(result));
        const SchemeCounts counts{after.vertices, after.edges, after.faces};
        ASSERT_EQ(foretold[static_cast<std::size_t>(level)].vertices, counts.vertices);
        ASSERT_EQ(foretold[static_cast<std::size_t>(level)].edges, counts.edges);
        ASSERT_EQ(foretold[static_cast<std::size_t>(level)].faces, counts.faces);
        ASSERT_EQ(after.boundary_loops, before.boundary_loops);
        ASSERT_EQ(after.components, before.components);
        ASSERT_EQ(after.euler_characteristic, before.euler_characteristic);
        ASSERT_EQ(result.face_control_faces.size(), result.face_count());
        ASSERT_TRUE(std::ranges::all_of(result.face_control_faces, [&](std::uint32_t f) {
          return f < shape.mesh->face_count();
        }));
      }
    }
  }
}

// Vertices between two edges only: a face around one would have two sides.
TEST_P(EveryScheme, TakesVerticesOfTwoEdges) {
  if (scheme_info(GetParam()).takes == FaceKinds::kTriangles) {
    return;  // Only a pair back to back has them, and is refused.
  }
  // Two squares back to back, and a cube with a pillar of three more vertices on an edge.
  const MeshPointer pillow = test::control_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.5}},
                                                {{0, 1, 2, 3}, {3, 2, 1, 0}});
  PolygonSoup tent;
  tent.positions = {{0, 0, 0},   {4, 0, 0},   {4, 4, 0},   {0, 4, 0},
                    {1, 2.1, 3}, {2, 2.2, 3}, {3, 2.1, 3}, {2, 2, 2}};
  tent.add_face(std::array{3U, 2U, 1U, 0U});
  tent.add_face(std::array{0U, 1U, 6U, 5U, 4U});
  tent.add_face(std::array{2U, 3U, 4U, 5U, 6U});
  tent.add_face(std::array{1U, 2U, 6U});
  tent.add_face(std::array{3U, 0U, 4U});
  for (const MeshPointer& shape : {pillow, test::control_mesh(tent)}) {
    if (!check_fits(*shape, GetParam())) {
      continue;
    }
    const auto foretold = predict_scheme(*shape, settings(), 3);
    for (int level = 1; level <= 3; ++level) {
      const MeshStatistics after =
          mesh_statistics(*to_control_mesh(subdivided(*shape, settings(), level)));
      const SchemeCounts counts{after.vertices, after.edges, after.faces};
      EXPECT_EQ(foretold[static_cast<std::size_t>(level)], counts) << level;
      EXPECT_EQ(after.euler_characteristic, 2) << level;
      EXPECT_EQ(after.boundary_edges, 0u) << level;
    }
  }
}

TEST_P(EveryScheme, KeepsOldVerticesIfItInterpolates) {
  for (const test::NamedShape& shape : test::shapes_for(GetParam())) {
    // Without sharp corners, in which even a spline interpolates.
    const RefinedMesh result = subdivided(*shape.mesh, settings(CornerRule::kSmooth), 2);
    double farthest = 0.0;
    if (scheme_info(GetParam()).splits_vertices) {
      continue;
    }
    for (std::size_t v = 0; v < shape.mesh->vertex_count(); ++v) {
      farthest = std::max(farthest, glm::distance(result.position(v), shape.mesh->positions()[v]));
    }
    EXPECT_EQ(scheme_info(GetParam()).interpolates,
              farthest < 1e-6 * shape.mesh->bounds().diagonal())
        << shape.name;
  }
}

TEST_P(EveryScheme, CommutesWithAffineMaps) {
  const glm::dmat3 turn(0.3, -0.7, 0.2, 1.1, 0.4, -0.5, 0.1, 0.9, 0.8);
  const glm::dvec3 shift(0.4, -1.2, 0.7);
  for (const test::NamedShape& shape : test::shapes_for(GetParam())) {
    PolygonSoup moved;
    for (const glm::dvec3& p : shape.mesh->positions()) {
      moved.positions.push_back(turn * p + shift);
    }
    for (std::size_t f = 0; f < shape.mesh->face_count(); ++f) {
      moved.add_face(shape.mesh->face(f));
    }
    const MeshPointer image = test::control_mesh(moved);
    const RefinedMesh result = subdivided(*image, settings(), 2);
    const RefinedMesh before = subdivided(*shape.mesh, settings(), 2);
    ASSERT_EQ(result.vertex_count(), before.vertex_count());
    double farthest = 0.0;
    for (std::size_t v = 0; v < result.vertex_count(); ++v) {
      farthest =
          std::max(farthest, glm::distance(result.position(v), turn * before.position(v) + shift));
    }
    EXPECT_LT(farthest, 2e-6 * image->bounds().diagonal()) << shape.name;
  }
}

/// The largest angle between faces that share an edge, in radians.
double sharpest_edge(const RefinedMesh& mesh) {
  const auto control = to_control_mesh(mesh);
  const auto normal = [&control](std::uint32_t corner) {
    const auto face = control->face(control->topology().corner_faces[corner]);
    glm::dvec3 sum(0.0);
    for (std::size_t i = 2; i < face.size(); ++i) {
      sum += glm::cross(control->positions()[face[i - 1]] - control->positions()[face[0]],
                        control->positions()[face[i]] - control->positions()[face[0]]);
    }
    return glm::normalize(sum);
  };
  double largest = 0.0;
  for (const auto& [one, other] : control->topology().edge_corners) {
    if (other != kNone) {
      const double sine = glm::length(glm::cross(normal(one), normal(other)));
      const double cosine = glm::dot(normal(one), normal(other));
      largest = std::max(largest, std::atan2(sine, cosine));
    }
  }
  return largest;
}

// A surface with tangent planes everywhere gets flatter and flatter under the microscope, also at
// irregular vertices and faces.
TEST_P(EveryScheme, IsSmoothAsItsEntrySays) {
  const bool is_smooth = scheme_info(GetParam()).continuity.substr(0, 2) != "C0";
  // One will do where the tests watch the code.
  const std::vector<std::uint32_t> valences =
      test::effort() < 1.0 ? std::vector{5u} : std::vector{3u, 5u, 6u, 7u};
  for (const std::uint32_t poles : valences) {
    const MeshPointer mesh =
        test::fitted(test::control_mesh(test::trapezohedron_soup(poles)), GetParam());
    const int more = GetParam() == Scheme::kSqrt3 || GetParam() == Scheme::kMidedge ? 2 : 0;
    const double before = sharpest_edge(subdivided(*mesh, settings(), 3 + more));
    const double after = sharpest_edge(subdivided(*mesh, settings(), 5 + 2 * more));
    EXPECT_EQ(is_smooth, after < 0.6 * before) << poles << ": " << before << " to " << after;
  }
}

TEST_P(EveryScheme, KeepsSharpCornersOfTheBoundary) {
  const MeshPointer grid = test::fitted(test::grid(3), GetParam());
  for (int level = 1; level <= 4; ++level) {
    const RefinedMesh result = subdivided(*grid, settings(), level);
    for (const std::uint32_t corner : {0u, 3u, 12u, 15u}) {
      double nearest = 1.0;
      for (std::size_t v = 0; v < result.vertex_count(); ++v) {
        nearest = std::min(nearest, glm::distance(result.position(v), grid->positions()[corner]));
      }
      // Cut into triangles, two of the corners have two faces.
      const FlatTopology& flat = grid->topology();
      if (flat.vertex_offsets[corner + 1] - flat.vertex_offsets[corner] == 1) {
        EXPECT_LT(nearest, 1e-6) << "level " << level << ", corner " << corner;
      }
    }
  }
}

// So that meshes that share a boundary go on sharing it.
TEST_P(EveryScheme, DrawsTheBoundaryFromTheBoundaryAlone) {
  PolygonSoup soup = test::grid_soup(4, 3);
  const MeshPointer flat = test::fitted(test::control_mesh(soup), GetParam());
  PolygonSoup raised;
  raised.positions.assign(flat->positions().begin(), flat->positions().end());
  for (std::size_t v = 0; v < flat->vertex_count(); ++v) {
    const FlatTopology& topology = flat->topology();
    if (topology.corner_twins[topology.vertex_corners[topology.vertex_offsets[v]]] != kNone) {
      raised.positions[v] += glm::dvec3(0.1, -0.2, 2.0);
    }
  }
  for (std::size_t f = 0; f < flat->face_count(); ++f) {
    raised.add_face(flat->face(f));
  }
  const MeshPointer bump = test::control_mesh(raised);
  for (const CornerRule corners : {CornerRule::kSharp, CornerRule::kSmooth}) {
    for (int level = 1; level <= 3; ++level) {
      const auto one = test::boundary_positions(subdivided(*flat, settings(corners), level));
      const auto other = test::boundary_positions(subdivided(*bump, settings(corners), level));
      EXPECT_EQ(test::matching_vertices(one, other, 1e-6).size(), one.size()) << level;
    }
  }
}

template <class Array>
bool same_bytes(const Array& a, const Array& b) {
  return a.size() == b.size() &&
         (a.empty() ||
          std::memcmp(a.data(), b.data(), a.size() * sizeof(typename Array::value_type)) == 0);
}

void expect_same_bytes(const RefinedMesh& a, const RefinedMesh& b) {
  EXPECT_TRUE(same_bytes(a.positions, b.positions));
  EXPECT_TRUE(same_bytes(a.quads, b.quads));
  EXPECT_TRUE(same_bytes(a.polygon_offsets, b.polygon_offsets));
  EXPECT_TRUE(same_bytes(a.polygon_vertices, b.polygon_vertices));
  EXPECT_TRUE(same_bytes(a.face_control_faces, b.face_control_faces));
  EXPECT_TRUE(same_bytes(a.face_levels, b.face_levels));
  EXPECT_TRUE(same_bytes(a.vertex_levels, b.vertex_levels));
  EXPECT_EQ(a.creases, b.creases);
}

TEST_P(EveryScheme, GivesTheSameBytesForAnyNumberOfThreads) {
  test::Random random(35);
  const MeshPointer torus =
      test::fitted(test::with_random_creases(
                       *test::control_mesh(test::jittered(test::torus_soup(40, 24), 0.02, random)),
                       0.1, 0.02, random),
                   GetParam());
  const auto on_threads = [&](int threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    return arena.execute([&] { return subdivided(*torus, settings(), 3); });
  };
  const RefinedMesh alone = on_threads(1);
  for (const int threads : {2, 7}) {
    expect_same_bytes(alone, on_threads(threads));
  }
}

TEST_P(EveryScheme, GoesLevelByLevelToTheSame) {
  for (const test::NamedShape& shape : test::shapes_for(GetParam())) {
    SchemeLevels levels(*shape.mesh, settings());
    IgnoreProgress progress;
    for (int level = 0; level <= few_levels(*shape.mesh); ++level) {
      SCOPED_TRACE(fmt::format("{}, level {}", shape.name, level));
      EXPECT_EQ(levels.level(), level);
      const RefinedMesh mesh = levels.mesh();
      EXPECT_EQ(levels.counts().faces, mesh.face_count());
      expect_same_bytes(mesh, subdivided(*shape.mesh, settings(), level));
      ASSERT_TRUE(levels.advance(1'000'000, progress));
    }
  }
}

TEST_P(EveryScheme, KeepsToTheBudget) {
  const MeshPointer mesh = test::fitted(test::cube(), GetParam());
  const auto counts = predict_scheme(*mesh, settings(), 3);
  IgnoreProgress progress;
  const Result<RefinedMesh> over = subdivide(*mesh, settings(), {3, counts[3].faces - 1}, progress);
  ASSERT_FALSE(over);
  EXPECT_EQ(over.error().kind, ErrorKind::kOverBudget);
  EXPECT_NE(over.error().message.find(std::to_string(counts[3].faces)), std::string::npos);
  EXPECT_TRUE(subdivide(*mesh, settings(), {3, counts[3].faces}, progress));

  SchemeLevels levels(*mesh, settings());
  ASSERT_TRUE(levels.advance(counts[1].faces, progress));
  ASSERT_FALSE(levels.advance(counts[2].faces - 1, progress));
  EXPECT_EQ(levels.level(), 1);
}

class StopsAtOnce final : public Progress {
 public:
  bool report(double, std::string_view) override { return false; }
};

TEST_P(EveryScheme, CanBeCancelled) {
  const MeshPointer mesh = test::fitted(test::cube(), GetParam());
  StopsAtOnce stop;
  const Result<RefinedMesh> result = subdivide(*mesh, settings(), {.levels = 3}, stop);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::kCancelled);
}

TEST_P(EveryScheme, RefusesWhatItCannotTake) {
  const FaceKinds kinds = scheme_info(GetParam()).takes;
  const MeshPointer prism = test::control_mesh(test::prism_soup(5));
  const Result<void> fits = check_fits(*prism, GetParam());
  EXPECT_EQ(fits.has_value(), kinds == FaceKinds::kAny);
  if (!fits) {
    EXPECT_NE(fits.error().message.find("face 0 has"), std::string::npos) << fits.error().message;
    EXPECT_NE(
        fits.error().message.find(kinds == FaceKinds::kTriangles ? "Triangulate" : "Catmull-Clark"),
        std::string::npos);
    EXPECT_TRUE(check_fits(*make_fit(*prism, fitting_for(kinds)), GetParam()));
  }
}

TEST(Schemes, OnTrianglesRefuseAPairBackToBack) {
  const MeshPointer pair =
      test::control_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 1, 0}});
  for (const Scheme scheme : {Scheme::kLoop, Scheme::kButterfly, Scheme::kSqrt3}) {
    const Result<void> fits = check_fits(*pair, scheme);
    ASSERT_FALSE(fits);
    EXPECT_NE(fits.error().message.find("back to back"), std::string::npos);
  }
  EXPECT_TRUE(check_fits(*pair, Scheme::kDooSabin));
}

}  // namespace
}  // namespace limn
