// Single facts about a refinement that can be said in numbers; the broad comparison with OpenSubdiv
// is in exactness_test.cpp.
#include "limn/subdivision/label_subdivision.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/subdivision/crack_check.h"
#include "support/shapes.h"

namespace limn {
namespace {

using test::MeshPointer;

RefinedMesh refined(const ControlMesh& mesh, const std::vector<std::uint8_t>& depths,
                    const SubdivisionSettings& settings = {}, const RefineLimits& limits = {}) {
  IgnoreProgress progress;
  const auto legal = legal_labels(mesh, depths, settings, progress);
  return refine(mesh, legal.value().labels, settings, limits, progress).value();
}

std::vector<std::uint8_t> even(const ControlMesh& mesh, std::uint8_t depth) {
  return std::vector<std::uint8_t>(mesh.face_count(), depth);
}

std::size_t count_near(const RefinedMesh& mesh, const glm::vec3& place) {
  return static_cast<std::size_t>(std::ranges::count_if(mesh.positions, [&](const glm::vec3& p) {
    const glm::vec3 gap = p - place;
    return std::max({std::abs(gap.x), std::abs(gap.y), std::abs(gap.z)}) < 1e-6f;
  }));
}

TEST(LabelSubdivision, CubeWithOnePaintedFaceHasTheKnownCounts) {
  const MeshPointer cube = test::cube();
  const std::vector<std::pair<std::size_t, std::size_t>> known{
      {24, 26}, {76, 78}, {228, 230}, {724, 726}, {2484, 2486}, {9076, 9078}};
  for (std::uint8_t depth = 1; depth <= 6; ++depth) {
    std::vector<std::uint8_t> depths(6, 0);
    depths[0] = depth;
    IgnoreProgress progress;
    const auto legal =
        legal_labels(*cube, depths, {.legalisation = LegalisationMethod::kGreedy}, progress);
    ASSERT_TRUE(legal);
    EXPECT_EQ(legal->steps.size(), 3u);
    const auto mesh = refine(*cube, legal->labels, {}, {}, progress);
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->face_count(), known[depth - 1u].first);
    EXPECT_EQ(mesh->vertex_count(), known[depth - 1u].second);
    EXPECT_TRUE(check_cracks(*cube, *mesh).is_watertight());
  }
}

TEST(LabelSubdivision, CubeCornerMovesToFiveNinths) {
  const MeshPointer cube = test::cube();
  const RefinedMesh mesh = refined(*cube, even(*cube, 1));
  ASSERT_EQ(mesh.vertex_count(), 26u);
  for (std::uint32_t v = 0; v < 8; ++v) {
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_FLOAT_EQ(mesh.positions[v][axis],
                      static_cast<float>(cube->positions()[v][axis] * 5.0 / 9.0));
    }
  }
  EXPECT_EQ(count_near(mesh, {0.0f, 0.75f, -0.75f}), 1u);
  EXPECT_EQ(count_near(mesh, {0.0f, 0.0f, 1.0f}), 1u);
}

TEST(LabelSubdivision, YElementHasItsThreeQuads) {
  // Only the first corner of one quad is positive: (v1 e5 c e8), (e5 v2 v3 c), (e8 c v3 v4).
  PolygonSoup soup;
  soup.positions = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  soup.add_face(std::vector<std::uint32_t>{0, 1, 2, 3});
  const MeshPointer mesh = test::control_mesh(soup);
  IgnoreProgress progress;
  const auto result = refine(*mesh, {1, 0, 0, 0}, {}, {}, progress);
  ASSERT_TRUE(result);
  ASSERT_EQ(result->quads.size(), 3u);
  const auto place = [&](std::size_t f, std::size_t i) {
    return result->positions[result->quads[f][i]];
  };
  EXPECT_EQ(place(0, 0), glm::vec3(0, 0, 0));
  EXPECT_EQ(place(0, 1), glm::vec3(2, 0, 0));
  EXPECT_EQ(place(0, 2), glm::vec3(2, 2, 0));
  EXPECT_EQ(place(0, 3), glm::vec3(0, 2, 0));
  EXPECT_THAT(result->quads[1],
              ::testing::ElementsAre(result->quads[0][1], 1, 2, result->quads[0][2]));
  EXPECT_THAT(result->quads[2],
              ::testing::ElementsAre(result->quads[0][3], result->quads[0][2], 2, 3));
  EXPECT_THAT(result->vertex_levels, ::testing::ElementsAre(1, 1, 0, 1, 1, 1, 1));
}

TEST(LabelSubdivision, BoundaryIsACubicBSpline) {
  const MeshPointer mesh = test::control_mesh(test::grid_soup(2, 1));
  SubdivisionSettings settings;
  const RefinedMesh sharp = refined(*mesh, even(*mesh, 1), settings);
  const auto& control = mesh->positions();
  const auto expect_at = [&](const RefinedMesh& refined_mesh, std::uint32_t v,
                             const glm::dvec3& place) {
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(refined_mesh.positions[v][axis], place[axis], 1e-6) << "vertex " << v;
    }
  };
  expect_at(sharp, 0, control[0]);
  expect_at(sharp, 1, (control[0] + 6.0 * control[1] + control[2]) / 8.0);
  settings.corners = CornerRule::kSmooth;
  const RefinedMesh smooth = refined(*mesh, even(*mesh, 1), settings);
  expect_at(smooth, 0, (control[1] + 6.0 * control[0] + control[3]) / 8.0);
}

TEST(LabelSubdivision, UnpaintedMeshComesOutAsItIs) {
  const MeshPointer mesh = test::control_mesh(test::prism_soup(5));
  const RefinedMesh same = refined(*mesh, even(*mesh, 0));
  EXPECT_EQ(same.quads.size(), 5u);
  EXPECT_EQ(same.polygon_count(), 2u);
  ASSERT_EQ(same.face_control_faces.size(), 7u);
  for (std::size_t f = 0; f < 7; ++f) {
    const auto control = mesh->face(same.face_control_faces[f]);
    EXPECT_TRUE(std::ranges::equal(same.face(f), control));
  }
  EXPECT_THAT(same.vertex_levels, ::testing::Each(0));
  EXPECT_THAT(same.face_levels, ::testing::Each(0));
}

TEST(LabelSubdivision, PolygonsAwayFromPaintStayWherePainted) {
  const MeshPointer mesh = test::control_mesh(test::prism_soup(6));
  SubdivisionSettings settings;
  settings.non_quads = NonQuadRule::kWherePainted;
  std::vector<std::uint8_t> depths(mesh->face_count(), 0);
  depths[0] = 2;  // One hexagon; the ring becomes illegal, and the other hexagon follows.
  const RefinedMesh all = refined(*mesh, depths, settings);
  EXPECT_EQ(all.polygon_count(), 0u);
  // On a mesh of two components the far one is left alone.
  PolygonSoup two = test::prism_soup(6);
  const PolygonSoup other = test::prism_soup(5);
  const auto shift = static_cast<std::uint32_t>(two.positions.size());
  two.positions.insert(two.positions.end(), other.positions.begin(), other.positions.end());
  for (std::size_t f = 0; f < other.face_count(); ++f) {
    std::vector<std::uint32_t> face(other.face(f).begin(), other.face(f).end());
    std::ranges::for_each(face, [&](std::uint32_t& v) { v += shift; });
    two.add_face(face);
  }
  const MeshPointer pair = test::control_mesh(two);
  depths.assign(pair->face_count(), 0);
  depths[0] = 2;
  const RefinedMesh half = refined(*pair, depths, settings);
  EXPECT_EQ(half.polygon_count(), 2u);
  EXPECT_THAT(half.face(half.face_count() - 1), ::testing::SizeIs(5));
}

TEST(LabelSubdivision, StopsAfterTheLevelsAskedFor) {
  const MeshPointer cube = test::cube();
  RefineLimits limits;
  limits.levels = 0;
  EXPECT_EQ(refined(*cube, even(*cube, 4), {}, limits).face_count(), 6u);
  limits.levels = 1;
  const RefinedMesh one = refined(*cube, even(*cube, 4), {}, limits);
  EXPECT_EQ(one.face_count(), 24u);
  EXPECT_THAT(one.face_levels, ::testing::Each(1));
  limits.levels = 3;
  EXPECT_EQ(refined(*cube, even(*cube, 4), {}, limits).face_count(), 384u);
}

TEST(LabelSubdivision, HalfedgesOfARefinedClosedMeshAreClosed) {
  test::Random random(31);
  const MeshPointer mesh =
      test::control_mesh(test::with_mixed_faces(test::torus_soup(7, 6), random));
  SubdivisionSettings settings;
  settings.non_quads = NonQuadRule::kWherePainted;
  const RefinedMesh result = refined(*mesh, test::random_depths(*mesh, 0.2, 3, random), settings);
  const HalfedgeMesh halfedges = to_halfedge_mesh(result);
  ASSERT_EQ(halfedges.n_vertices(), result.vertex_count());
  ASSERT_EQ(halfedges.n_faces(), result.face_count());
  for (const auto edge : halfedges.edges()) {
    EXPECT_FALSE(halfedges.is_boundary(edge));
  }
  for (const auto vertex : halfedges.vertices()) {
    EXPECT_TRUE(halfedges.is_manifold(vertex));
    EXPECT_GE(halfedges.valence(vertex), 2u);
  }
  EXPECT_EQ(halfedges.n_vertices() + halfedges.n_faces(), halfedges.n_edges());  // A torus.
}

TEST(Budget, RefusesBeforeAnyWorkAndTellsTheCount) {
  class Count final : public Progress {
   public:
    bool report(double, std::string_view) override {
      ++reports;
      return true;
    }
    int reports = 0;
  };
  const MeshPointer cube = test::cube();
  const VertexLabels labels(8, 4);
  Count progress;
  RefineLimits limits;
  limits.face_budget = 1535;
  const auto refused = refine(*cube, labels, {}, limits, progress);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kOverBudget);
  EXPECT_THAT(refused.error().message, ::testing::HasSubstr("1536"));
  EXPECT_THAT(refused.error().message, ::testing::HasSubstr("1535"));
  EXPECT_LT(progress.reports, 10);  // Counted, and nothing made.
  limits.face_budget = 1536;
  EXPECT_TRUE(refine(*cube, labels, {}, limits, progress));
  EXPECT_GT(progress.reports, 0);
}

TEST(Budget, RefusesWhatCannotBeNumbered) {
  const MeshPointer mesh = test::control_mesh(test::torus_soup(64, 64));
  IgnoreProgress progress;
  const auto refused = refine(*mesh, VertexLabels(64 * 64, kMaxDepth), {}, {}, progress);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kOverBudget);
  EXPECT_THAT(refused.error().message, ::testing::HasSubstr("4294967296"));
}

TEST(Cancelling, WorksAtEveryReport) {
  class StopAfter final : public Progress {
   public:
    explicit StopAfter(int allowed) : left_(allowed) {}
    bool report(double fraction, std::string_view stage) override {
      EXPECT_GE(fraction, last_);
      EXPECT_LE(fraction, 1.0);
      EXPECT_FALSE(stage.empty());
      last_ = fraction;
      ++reports;
      return left_-- > 0;
    }
    int reports = 0;

   private:
    int left_;
    double last_ = 0.0;
  };
  test::Random random(32);
  const MeshPointer mesh = test::control_mesh(test::grid_soup(9, 9));
  const auto depths = test::random_depths(*mesh, 0.3, 3, random);
  IgnoreProgress ignore;
  const auto legal = legal_labels(*mesh, depths, {}, ignore);
  ASSERT_TRUE(legal);
  StopAfter never(1 << 30);
  ASSERT_TRUE(refine(*mesh, legal->labels, {}, {}, never));
  ASSERT_GE(never.reports, 10);
  for (int reports = 0; reports < never.reports; ++reports) {
    StopAfter stop(reports);
    const auto result = refine(*mesh, legal->labels, {}, {}, stop);
    ASSERT_FALSE(result) << "stopped after " << reports;
    EXPECT_EQ(result.error().kind, ErrorKind::kCancelled);
    EXPECT_EQ(stop.reports, reports + 1);  // Told once, it asks no more.
  }
}

}  // namespace
}  // namespace limn
