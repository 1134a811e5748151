// Limit positions and normals against OpenSubdiv: every refined vertex is followed down to the last
// level of the uniform hierarchy, where nothing semi-sharp is left, and compared there.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <glm/geometric.hpp>

#include "exactness_check.h"
#include "hierarchy_labels.h"
#include "hierarchy_rings.h"
#include "limn/mesh/import.h"
#include "support/attribute_shapes.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/shapes.h"

namespace limn {
namespace {

using test::MeshPointer;

constexpr double kPositionTolerance = 1e-6;                         // Of the diagonal.
constexpr double kNormalTolerance = 0.01 * std::numbers::pi / 180;  // 0.01 degrees.

/// What has been compared, so that no comparison passes for want of cases.
struct Compared {
  std::size_t positions = 0;
  std::size_t smooth_normals = 0;
  std::size_t boundary_normals = 0;
  std::size_t crease_normals = 0;
  std::size_t undecided =
      0;  ///< Normals where tangents are so nearly parallel that rounding rules.
  std::size_t unmatched = 0;  ///< Refinements whose vertices could not be told apart.
};

bool has_two_faces_inside(const VertexRing& ring) {
  return ring.face_count() == 2 && !ring.is_boundary();
}

/// The limits of all vertices of one level of the hierarchy.
class LimitReference {
 public:
  LimitReference(const ControlMesh& mesh, int levels, CornerRule corners)
      : mesh_(&mesh),
        corners_(corners),
        uniform_(mesh, levels, corners),
        limits_(uniform_.hierarchy().limits(mesh.positions())) {}

  [[nodiscard]] const test::UniformReference& uniform() const { return uniform_; }

  /// Empty if all is well, else the first difference.
  [[nodiscard]] std::string compare(const RefinedMesh& refined,
                                    const std::vector<test::ReferenceMesh::Vertex>& references,
                                    Compared& compared) const {
    for (std::size_t v = 0; v < refined.vertex_count(); ++v) {
      const std::uint32_t last = at_last_level(references[v]);
      const VertexRing ring = ring_of(last);
      const test::Feature feature(ring);
      const std::string where = fmt::format("vertex {} of level {} ({} faces{}), {} sharp edges{}",
                                            v, references[v].level, ring.face_count(),
                                            ring.is_boundary() ? ", boundary" : "", feature.count,
                                            feature.is_corner ? ", corner" : "");
      // There OpenSubdiv's is an approximation that gets better from level to level.
      const bool is_approximate = feature.is_dart() || has_two_faces_inside(ring);
      const glm::dvec3 expected =
          is_approximate ? limit_of(ring).position : limits_.positions[last];
      const double distance = glm::distance(refined.position(v), expected);
      if (!(distance <= kPositionTolerance * mesh_->bounds().diagonal())) {
        return fmt::format("{}: {} off", where, distance / mesh_->bounds().diagonal());
      }
      ++compared.positions;
      const double angle = angle_to_expected(glm::dvec3(refined.normals[v]), ring, feature,
                                             limits_.normals[last], compared);
      if (!(angle <= kNormalTolerance)) {
        return fmt::format("{}: normal {} degrees off", where, angle * 180 / std::numbers::pi);
      }
    }
    return "";
  }

 private:
  [[nodiscard]] std::uint32_t at_last_level(const test::ReferenceMesh::Vertex& vertex) const {
    std::uint32_t index = vertex.index;
    for (int level = vertex.level; level < uniform_.hierarchy().levels(); ++level) {
      index = uniform_.hierarchy().child_of_vertex(level, index);
    }
    return index;
  }
  [[nodiscard]] VertexRing ring_of(std::uint32_t vertex) const {
    return test::ring_at(uniform_.hierarchy(), uniform_.positions().back(),
                         uniform_.hierarchy().levels(), vertex);
  }
  [[nodiscard]] LimitPoint limit_of(const VertexRing& ring) const {
    return ring.limit(mesh_->creases().method, corners_);
  }

  /// With every edge point moved by as much as rounding may in some steps.
  [[nodiscard]] VertexRing shaken(const VertexRing& ring) const {
    const double amount = 1e-13 * mesh_->bounds().diagonal();
    VertexRing result = ring;
    for (std::size_t i = 0; i < result.edges().size(); ++i) {
      result.edges()[i][static_cast<int>(i % 3)] += amount;
    }
    return result;
  }

  /// 0 where the surface has no tangent plane.
  [[nodiscard]] double angle_to_expected(const glm::dvec3& normal, const VertexRing& ring,
                                         const test::Feature& feature,
                                         const glm::dvec3& opensubdivs, Compared& compared) const;

  const ControlMesh* mesh_;
  CornerRule corners_;
  test::UniformReference uniform_;
  test::ReferenceLimits limits_;
};

/// The same ring of an interior vertex, counted from edge `first` on.
VertexRing turned(const VertexRing& ring, std::size_t first) {
  VertexRing result = ring;
  const auto turn = [first](auto values) {
    std::rotate(values.begin(), values.begin() + static_cast<long>(first), values.end());
  };
  turn(result.edges());
  turn(result.centroids());
  turn(result.edge_sharpness());
  return result;
}

double LimitReference::angle_to_expected(const glm::dvec3& normal, const VertexRing& ring,
                                         const test::Feature& feature,
                                         const glm::dvec3& opensubdivs, Compared& compared) const {
  const glm::dvec3 of_ring = limit_of(ring).normal;
  if (feature.is_corner || of_ring == glm::dvec3(0.0) || !std::isfinite(glm::length(opensubdivs))) {
    return std::abs(glm::length(normal) - 1.0) < 1e-6 || normal == glm::dvec3(0.0) ? 0.0 : 1.0;
  }
  if (test::angle_between(of_ring, limit_of(shaken(ring)).normal) > kNormalTolerance) {
    ++compared.undecided;
    return 0.0;
  }
  if (feature.is_crease() && !ring.is_boundary()) {
    ++compared.crease_normals;  // Of either side.
    return std::min(test::angle_between(normal, of_ring),
                    test::angle_between(normal, limit_of(turned(ring, feature.last)).normal));
  }
  ++(feature.is_crease() ? compared.boundary_normals : compared.smooth_normals);
  const bool is_exact = feature.has_exact_normal_mask() && !has_two_faces_inside(ring);
  return test::angle_between(normal, is_exact ? opensubdivs : of_ring);
}

RefineLimits with_normals() {
  RefineLimits limits;
  limits.normals = true;
  return limits;
}

RefinedMesh refined(const ControlMesh& mesh, const VertexLabels& labels,
                    const SubdivisionSettings& settings, const RefineLimits& limits) {
  IgnoreProgress progress;
  auto result = refine(mesh, labels, settings, limits, progress);
  EXPECT_TRUE(result);
  return *std::move(result);
}

/// Random paintings of a mesh whose sharpness has worn off after `levels`.
void expect_limits(const ControlMesh& mesh, const std::string& name, int levels, int paintings,
                   test::Random& random, Compared& compared) {
  for (const CornerRule corners : {CornerRule::kSharp, CornerRule::kSmooth}) {
    const LimitReference reference(mesh, levels, corners);
    for (int painting = 0; painting < paintings; ++painting) {
      SubdivisionSettings settings;
      settings.corners = corners;
      settings.points = SurfacePoints::kLimit;
      settings.non_quads =
          painting % 2 == 0 ? NonQuadRule::kWherePainted : NonQuadRule::kUniformFirstStep;
      const bool has_first_step =
          !mesh.is_all_quads() && settings.non_quads == NonQuadRule::kUniformFirstStep;
      const int deepest = std::min(5, levels - (has_first_step ? 1 : 0));
      const double probability = painting % 4 == 3 ? 1.0 : std::pow(0.5, 1 + painting % 4);
      const auto depths = test::random_depths(mesh, probability, deepest, random);
      // Every other one with demands on finer faces.
      const auto [painted, given] =
          test::random_fine_painting(reference.uniform().hierarchy(), mesh, depths,
                                     painting % 2 == 0 || levels < 2 ? 0 : 8, settings, random);
      const VertexLabels& labels = painted.legal.labels;
      RefineLimits plainly;
      plainly.fine = painted.fine.get();
      RefineLimits with_normals = plainly;
      with_normals.normals = true;
      SCOPED_TRACE(fmt::format("{}, painting {}", name, painting));
      const auto references = reference.uniform().references_fine(
          labels, painted.fine.get(), given.labels, settings, kAllLevels);
      if (references.empty()) {
        ++compared.unmatched;
        continue;
      }
      const RefinedMesh limit = refined(mesh, labels, settings, with_normals);
      ASSERT_EQ(limit.normals.size(), limit.vertex_count());
      ASSERT_EQ(reference.compare(limit, references, compared), "");

      // Neither changes what it need not.
      settings.points = SurfacePoints::kLevel;
      const RefinedMesh plain = refined(mesh, labels, settings, plainly);
      const RefinedMesh shaded = refined(mesh, labels, settings, with_normals);
      ASSERT_TRUE(plain.normals.empty());
      ASSERT_EQ(shaded.positions, plain.positions);
      ASSERT_EQ(shaded.normals, limit.normals);
      ASSERT_EQ(shaded.quads, limit.quads);
      ASSERT_EQ(shaded.vertex_levels, limit.vertex_levels);
    }
  }
}

/// The level at which no semi-sharp crease or corner is left.
int worn_level(const ControlMesh& mesh) {
  float greatest = 0.0f;
  for (const auto* list : {&mesh.creases().edge_sharpness, &mesh.creases().vertex_sharpness}) {
    for (const float sharpness : *list) {
      greatest = std::max(greatest, sharpness < kInfiniteSharpness ? sharpness : 0.0f);
    }
  }
  return static_cast<int>(std::ceil(greatest));
}

/// As deep as about so many uniform faces allow.
int affordable_levels(const ControlMesh& mesh, double faces) {
  const double corners = static_cast<double>(mesh.topology().corner_vertices.size());
  return std::clamp(
      1 + static_cast<int>(std::floor(std::log(test::effort() * faces / corners) / std::log(4))), 0,
      5);
}

TEST(Limit, IsOpenSubdivsOnShapesOfEveryKind) {
  test::Random random(11);
  Compared compared;
  const auto mixed = [&](const PolygonSoup& soup) { return test::with_mixed_faces(soup, random); };
  const std::vector<std::pair<std::string, PolygonSoup>> shapes{
      {"cube", test::cube_soup()},
      {"single quad", test::grid_soup(1, 1)},
      {"grid", test::grid_soup(6, 5)},
      {"torus", test::torus_soup(9, 6)},
      {"triangle", test::polygon_in_ring_soup(3)},
      {"heptagon", test::polygon_in_ring_soup(7)},
      {"prism of 5", test::prism_soup(5)},
      {"poles of 3", test::trapezohedron_soup(3)},
      {"poles of 12", test::trapezohedron_soup(12)},
      {"mixed grid", mixed(test::grid_soup(6, 6))},
      {"mixed torus", mixed(test::torus_soup(8, 6))},
      {"holes", test::with_holes(test::torus_soup(9, 7), 9, random)},
      {"mixed holes", test::with_holes(mixed(test::torus_soup(9, 7)), 7, random)},
      {"random quads", test::random_quads(test::torus_soup(4, 3), random)},
  };
  for (const auto& [name, soup] : shapes) {
    const MeshPointer mesh = test::control_mesh(test::jittered(soup, 0.1, random));
    expect_limits(*mesh, name, affordable_levels(*mesh, 12000), 4, random, compared);
  }
  EXPECT_GT(static_cast<double>(compared.smooth_normals), 10000 * test::effort());
  EXPECT_GT(static_cast<double>(compared.boundary_normals), 1000 * test::effort());
  EXPECT_EQ(compared.undecided, 0u);
  EXPECT_EQ(compared.unmatched, 0u);
}

TEST(Limit, IsOpenSubdivsBesideCreases) {
  test::Random random(12);
  Compared compared;
  for (const auto& [name, mesh] : test::creased_shapes()) {
    const int levels = std::max(worn_level(*mesh), affordable_levels(*mesh, 6000));
    expect_limits(*mesh, name, levels, 3, random, compared);
  }
  EXPECT_GT(static_cast<double>(compared.smooth_normals), 10000 * test::effort());
  EXPECT_GT(static_cast<double>(compared.crease_normals), 500 * test::effort());
  EXPECT_EQ(compared.undecided, 0u);
  EXPECT_EQ(compared.unmatched, 0u);
}

TEST(Limit, IsOpenSubdivsOnBundledMeshes) {
  test::Random random(13);
  Compared compared;
  for (const auto& file : test::bundled_mesh_files()) {
    const auto imported = import_mesh(file);
    ASSERT_TRUE(imported) << to_string(imported.error());
    const int levels = affordable_levels(*imported->mesh, 40000);
    if (levels >= 2) {
      expect_limits(*imported->mesh, file.filename().string(), levels, 2, random, compared);
    }
  }
  EXPECT_GT(compared.positions, 10000u);
}

TEST(Limit, IsOpenSubdivsOnTheCorpus) {
  if (!test::corpus_folder()) {
    GTEST_SKIP() << "no corpus of meshes: set LIMN_CORPUS or put one at ../shared/corpus";
  }
  test::Random random(14);
  Compared compared;
  for (const auto& file : test::corpus_files(".obj")) {
    const auto imported = import_mesh(file);
    if (!imported) {
      continue;
    }
    const int levels = std::max(2, worn_level(*imported->mesh));
    if (levels <= affordable_levels(*imported->mesh, 60000)) {
      expect_limits(*imported->mesh, file.filename().string(), levels, 1, random, compared);
    }
  }
  EXPECT_GT(compared.positions, 10000u);
  EXPECT_GT(compared.crease_normals, 0u);
  EXPECT_LT(compared.undecided, compared.positions / 1000);
}

TEST(Limit, IsTheSameForAnyNumberOfThreads) {
  const MeshPointer mesh = test::control_mesh(test::torus_soup(12, 8));
  VertexLabels labels(mesh->vertex_count(), 7);
  labels[3] = 6;
  SubdivisionSettings settings;
  settings.points = SurfacePoints::kLimit;
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return refined(*mesh, labels, settings, with_normals());
  };
  const RefinedMesh one = with_threads(1);
  for (const std::size_t threads : {2u, 7u}) {
    const RefinedMesh other = with_threads(threads);
    EXPECT_EQ(other.positions, one.positions);
    EXPECT_EQ(other.normals, one.normals);
  }
}

TEST(Limit, OfAFlatUnpaintedMeshIsThere) {
  const MeshPointer mesh =
      test::control_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
  SubdivisionSettings settings;
  settings.corners = CornerRule::kSmooth;
  settings.points = SurfacePoints::kLimit;
  const RefinedMesh limit = refined(*mesh, VertexLabels(4, 0), settings, with_normals());
  EXPECT_EQ(limit.normals[0], glm::vec3(0, 0, 1));
  EXPECT_LE(glm::distance(limit.position(0), glm::dvec3(1.0 / 6, 1.0 / 6, 0)), 1e-7);
}

}  // namespace
}  // namespace limn
