// Chosen depths against what is measured of the refined mesh, against brute force, and by hand.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/comparison/limit_distance.h"
#include "limn/mesh/bundled.h"
#include "limn/painting/auto_depth/budget.h"
#include "limn/painting/auto_depth/depth_curve.h"
#include "limn/painting/auto_depth/screen_size.h"
#include "limn/painting/auto_depth/tolerance.h"
#include "limn/subdivision/face_errors.h"
#include "limn/subdivision/fine_labels.h"
#include "limn/subdivision/label_subdivision.h"
#include "support/attribute_shapes.h"
#include "support/effort.h"
#include "support/shapes.h"

namespace limn {
namespace {

using test::MeshPointer;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;

MeshPointer bundled_mesh(const char* name) {
  return load_bundled_mesh(name).value().mesh;
}

VertexLabels legal(const ControlMesh& mesh, const FaceDepths& depths,
                   const SubdivisionSettings& settings) {
  IgnoreProgress progress;
  return legal_labels(mesh, depths.values(), settings, progress).value().labels;
}

/// The distance of the refined painting to the limit surface.
LimitDistance distance_of(const ControlMesh& mesh, const FaceDepths& depths,
                          const SubdivisionSettings& settings) {
  IgnoreProgress progress;
  const VertexLabels labels = legal(mesh, depths, settings);
  const RefinedMesh refined = refine(mesh, labels, settings, {}, progress).value();
  LimitDistanceLimits limits;  // A quick look: figures to some per cent.
  limits.samples = std::size_t{1} << 13;
  limits.change = 0.1;
  return measure_limit_distance(mesh, labels, settings, refined, progress, limits).value();
}

double measured(const ControlMesh& mesh, const FaceDepths& depths,
                const SubdivisionSettings& settings) {
  return distance_of(mesh, depths, settings).greatest();
}

std::uint64_t faces_of(const ControlMesh& mesh, const FaceDepths& depths,
                       const SubdivisionSettings& settings) {
  return predict_refinement(mesh, legal(mesh, depths, settings)).faces;
}

class Tolerance : public testing::TestWithParam<SurfacePoints> {
 protected:
  [[nodiscard]] static ChosenDepths choose(const ControlMesh& mesh,
                                           const SubdivisionSettings& settings, double distance) {
    IgnoreProgress progress;
    const std::vector<double> distances{distance};
    return depths_for_tolerance(mesh, settings, distances, progress).value();
  }
};

TEST_P(Tolerance, IsKept) {
  std::vector<test::NamedShape> shapes;
  for (const char* name : {"cube", "mixed", "torus_open"}) {
    shapes.push_back({name, bundled_mesh(name)});
  }
  for (test::NamedShape& shape : test::creased_shapes()) {
    if (shape.mesh->face_count() < 9 && test::effort() == 1.0) {
      shapes.push_back(std::move(shape));
    }
  }
  SubdivisionSettings settings;
  settings.points = GetParam();
  shapes.resize(test::effort() < 1.0 ? 2 : shapes.size());
  for (const test::NamedShape& shape : shapes) {
    const double distance = 0.006 * shape.mesh->bounds().diagonal();
    const ChosenDepths chosen = choose(*shape.mesh, settings, distance);
    EXPECT_EQ(chosen.short_faces, 0U) << shape.name;
    EXPECT_LE(chosen.expected_error, distance) << shape.name;
    EXPECT_LE(measured(*shape.mesh, chosen.depths, settings), distance) << shape.name;
  }
}

TEST_P(Tolerance, IsKeptWithFewerFacesWhereItIsMeasured) {
  SubdivisionSettings settings;
  settings.points = GetParam();
  std::uint64_t estimated_faces = 0;
  std::uint64_t measured_faces = 0;
  const std::size_t most = test::effort() < 1.0 ? 1 : 3;
  std::size_t seen = 0;
  for (const test::NamedShape& shape : test::creased_shapes()) {
    // Errors are overestimated most where creases of several kinds wear off.
    if (shape.name.find("loop") == std::string::npos || shape.mesh->face_count() > 8 ||
        (most == 1 && shape.name.find("uneven") == std::string::npos) || seen == most) {
      continue;
    }
    ++seen;
    const std::vector<double> distances{0.006 * shape.mesh->bounds().diagonal()};
    IgnoreProgress progress;
    const ChosenDepths chosen =
        depths_for_measured_tolerance(*shape.mesh, settings, distances, progress).value();
    EXPECT_LE(measured(*shape.mesh, chosen.depths, settings), distances[0]) << shape.name;
    EXPECT_LE(chosen.expected_error, distances[0]) << shape.name;
    const FaceDepths estimated = choose(*shape.mesh, settings, distances[0]).depths;
    for (std::size_t f = 0; f < estimated.size(); ++f) {
      EXPECT_LE(chosen.depths[f], estimated[f]) << shape.name;
    }
    estimated_faces += faces_of(*shape.mesh, estimated, settings);
    measured_faces += faces_of(*shape.mesh, chosen.depths, settings);
  }
  EXPECT_EQ(seen, most);
  EXPECT_LT(measured_faces, estimated_faces);
}

TEST(MeasuredTolerance, KeepsTheUniformStepWhereFacesRelyOnIt) {
  SubdivisionSettings settings;
  settings.points = SurfacePoints::kLimit;
  const MeshPointer mesh = bundled_mesh("mixed");
  IgnoreProgress progress;
  const std::vector<LevelErrors> expected = face_errors(*mesh, {}, progress).value();
  const LargeArray<float> unrefined =
      distance_of(*mesh, FaceDepths(mesh->face_count()), settings).of_faces;
  ASSERT_EQ(unrefined.size(), mesh->face_count());
  // Two faces get the uniform step: the first, which is painted for it, could do without, as it is
  // measured, and the other could not.
  std::vector<double> distances(mesh->face_count(), std::numeric_limits<double>::infinity());
  std::size_t first = 0;
  while (1.1 * unrefined[first] > expected[first][0]) {
    ASSERT_LT(++first, mesh->face_count());
  }
  distances[first] = 0.99 * expected[first][0];
  std::size_t other = first + 1;
  while (0.9 * unrefined[other] < expected[other][1]) {
    ASSERT_LT(++other, mesh->face_count());
  }
  distances[other] = 0.9 * unrefined[other];
  const FaceDepths estimated =
      depths_for_tolerance(*mesh, settings, distances, progress).value().depths;
  ASSERT_EQ(estimated[first], 1);
  ASSERT_EQ(estimated[other], 0);

  const ChosenDepths chosen =
      depths_for_measured_tolerance(*mesh, settings, distances, progress).value();
  EXPECT_GT(chosen.depths.deepest(), 0) << "face " << other << " is too far without the step";
}

TEST(MeasuredTolerance, NeverTakesMoreFacesThanAnEvenPainting) {
  SubdivisionSettings settings;
  settings.points = SurfacePoints::kLimit;
  std::vector<const char*> names{"cube_triangulated", "cube", "torus_open"};
  names.resize(test::effort() < 1.0 ? 1 : names.size());
  for (const char* name : names) {
    const auto mesh = bundled_mesh(name);
    const FaceDepths even(mesh->face_count(), 2);
    const std::vector<double> distances{1.02 * measured(*mesh, even, settings)};
    IgnoreProgress progress;
    const ChosenDepths chosen =
        depths_for_measured_tolerance(*mesh, settings, distances, progress).value();
    EXPECT_LE(faces_of(*mesh, chosen.depths, settings), faces_of(*mesh, even, settings)) << name;
    EXPECT_LE(measured(*mesh, chosen.depths, settings), distances[0]) << name;
  }
}

TEST(MeasuredTolerance, CanBeStoppedAtAnyTime) {
  class StopAfter final : public Progress {
   public:
    explicit StopAfter(int reports) : left_(reports) {}
    [[nodiscard]] bool report(double fraction, std::string_view) override {
      EXPECT_GE(fraction, last_) << "it never falls";
      last_ = fraction;
      return left_-- > 0;
    }

   private:
    int left_;
    double last_ = 0.0;
  };
  const MeshPointer cube = test::cube();
  const std::vector<double> distances{0.05};
  for (const int reports : {0, 1, 5, 25}) {
    StopAfter progress(reports);
    const auto stopped = depths_for_measured_tolerance(*cube, {}, distances, progress);
    if (!stopped) {
      EXPECT_EQ(stopped.error().kind, ErrorKind::kCancelled);
    }
  }
}

TEST_P(Tolerance, IsNotKeptWithALevelLess) {
  // So none of the levels is for nothing, at least where all faces are alike.
  SubdivisionSettings settings;
  settings.points = GetParam();
  const MeshPointer cube = test::cube();
  for (const double share : {0.02, 0.005, 0.001}) {
    const double distance = share * cube->bounds().diagonal();
    FaceDepths depths = choose(*cube, settings, distance).depths;
    ASSERT_GT(depths[0], 0);
    ASSERT_THAT(depths.values(), Each(depths.values()[0]));
    for (std::size_t f = 0; f < 6; ++f) {
      depths.set(f, depths[f] - 1);
    }
    EXPECT_GT(measured(*cube, depths, settings), distance);
  }
}

INSTANTIATE_TEST_SUITE_P(Points, Tolerance,
                         testing::Values(SurfacePoints::kLimit, SurfacePoints::kLevel),
                         [](const auto& points) {
                           return points.param == SurfacePoints::kLimit ? "Limit" : "Level";
                         });

TEST(ToleranceDepths, AreOneLessWhereTheFirstStepIsUniform) {
  const MeshPointer mesh = bundled_mesh("mixed");
  SubdivisionSettings settings;
  settings.points = SurfacePoints::kLimit;
  IgnoreProgress progress;
  const std::vector<double> distances{0.001 * mesh->bounds().diagonal()};
  const FaceDepths first = depths_for_tolerance(*mesh, settings, distances, progress)->depths;
  settings.non_quads = NonQuadRule::kWherePainted;
  const FaceDepths painted = depths_for_tolerance(*mesh, settings, distances, progress)->depths;
  for (std::size_t f = 0; f < first.size(); ++f) {
    EXPECT_EQ(first[f], std::max(0, painted[f] - 1));
  }
}

TEST(ToleranceDepths, PaintOneFaceWhereTheUniformStepIsEnough) {
  const MeshPointer mesh = bundled_mesh("mixed");
  SubdivisionSettings settings;
  IgnoreProgress progress;
  const double unrefined = measured(*mesh, FaceDepths(mesh->face_count()), settings);
  const std::vector<double> distances{0.9 * unrefined};
  const ChosenDepths chosen = depths_for_tolerance(*mesh, settings, distances, progress).value();
  EXPECT_GE(chosen.depths.deepest(), 1);
  EXPECT_LE(measured(*mesh, chosen.depths, settings), 0.9 * unrefined);
}

TEST(ToleranceDepths, TellWhatKMaxDepthIsTooFewFor) {
  IgnoreProgress progress;
  const std::vector<double> distances{1e-12};
  const ChosenDepths chosen = depths_for_tolerance(*test::cube(), {}, distances, progress).value();
  EXPECT_EQ(chosen.short_faces, 6U);
  EXPECT_GT(chosen.expected_error, 1e-12);
  EXPECT_THAT(chosen.depths.values(), Each(kMaxDepth));
}

TEST(Budget, IsNeverExceededAndNearlySpent) {
  test::Random random(11);
  IgnoreProgress progress;
  for (const char* name : {"cube", "creature", "teapot", "torus_open", "mixed", "icosahedron"}) {
    const MeshPointer mesh = bundled_mesh(name);
    for (const FaceBudget::Goal goal :
         {FaceBudget::Goal::kMeanSquare, FaceBudget::Goal::kGreatest}) {
      for (const NonQuadRule rule : {NonQuadRule::kUniformFirstStep, NonQuadRule::kWherePainted}) {
        SubdivisionSettings settings;
        settings.non_quads = rule;
        const std::uint64_t most = 12 * mesh->face_count() + random() % 4000;
        const BudgetedDepths found =
            depths_for_budget(*mesh, settings, {{most, FaceBudget::Unit::kFaces, goal}, {}},
                              progress)
                .value();
        EXPECT_EQ(found.count, faces_of(*mesh, found.chosen.depths, settings));
        EXPECT_LE(found.count, most) << name;
        EXPECT_GE(found.count, most * 6 / 10) << name;
      }
    }
  }
}

TEST(Budget, LeavesLittleUnspent) {
  const MeshPointer mesh = bundled_mesh("creature");
  SubdivisionSettings settings;
  settings.points = SurfacePoints::kLimit;
  IgnoreProgress progress;
  for (const std::uint64_t most : {1'500U, 4'000U, 9'000U, 30'000U, 100'000U}) {
    for (const FaceBudget::Goal goal :
         {FaceBudget::Goal::kMeanSquare, FaceBudget::Goal::kGreatest}) {
      const BudgetedDepths found =
          depths_for_budget(*mesh, settings, {{most, FaceBudget::Unit::kFaces, goal}, {}}, progress)
              .value();
      EXPECT_GE(found.count, most - 3 * most / 100) << most;
      EXPECT_LE(found.count, most);
    }
  }
}

TEST(Budget, LeavesNoMoreErrorThanTheEvenPaintingThatFits) {
  // Detail is even on the creature, and two levels of everything take no seams.
  const MeshPointer mesh = bundled_mesh("creature");
  SubdivisionSettings settings;
  settings.points = SurfacePoints::kLimit;
  IgnoreProgress progress;
  const FaceDepths even(mesh->face_count(), 2);
  const std::uint64_t most = faces_of(*mesh, even, settings) + 50;
  const BudgetedDepths found =
      depths_for_budget(*mesh, settings, {{most, FaceBudget::Unit::kFaces}, {}}, progress).value();
  EXPECT_LE(found.count, most);
  EXPECT_LE(distance_of(*mesh, found.chosen.depths, settings).root_mean_square(),
            1.001 * distance_of(*mesh, even, settings).root_mean_square());
}

TEST(Budget, CountsTriangles) {
  const MeshPointer mesh = bundled_mesh("mixed");
  SubdivisionSettings settings;
  settings.non_quads = NonQuadRule::kWherePainted;
  IgnoreProgress progress;
  const BudgetedDepths found =
      depths_for_budget(*mesh, settings, {{2000, FaceBudget::Unit::kTriangles}, {}}, progress)
          .value();
  const RefinedMesh refined =
      refine(*mesh, legal(*mesh, found.chosen.depths, settings), settings, {}, progress).value();
  std::uint64_t triangles = 0;
  for (std::size_t f = 0; f < refined.face_count(); ++f) {
    triangles += refined.face(f).size() - 2;
  }
  EXPECT_EQ(found.count, triangles);
  EXPECT_LE(triangles, 2000U);
  EXPECT_GT(triangles, 1400U);
}

TEST(Budget, CountsWhatIsPaintedAlready) {
  const MeshPointer mesh = bundled_mesh("creature");
  IgnoreProgress progress;
  FaceDepths painted(mesh->face_count());
  for (std::size_t f = 0; f < 40; ++f) {
    painted.set(f, 3);
  }
  const auto finish = [&](const FaceDepths& proposed) {
    FaceDepths finished = painted;
    for (std::size_t f = 0; f < painted.size(); ++f) {
      finished.set(f, std::max(painted[f], proposed[f]));
    }
    return finished;
  };
  const BudgetedDepths found = depths_for_budget(*mesh, {}, {{10'000}, finish}, progress).value();
  EXPECT_EQ(found.count, faces_of(*mesh, finish(found.chosen.depths), {}));
  EXPECT_LE(found.count, 10'000U);
  EXPECT_GT(found.count, 7'000U);
  const auto refused = depths_for_budget(*mesh, {}, {{3'000}, finish}, progress);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kOverBudget);
  EXPECT_THAT(refused.error().message, HasSubstr("3000"));
}

TEST(Budget, CountsDemandsOnFinerFaces) {
  const MeshPointer mesh = bundled_mesh("creature");
  IgnoreProgress progress;
  FineDemands demands;
  const std::vector<FineDemand> wanted{{{12, 0, 1, 0, 1}, 6}, {{700, 0, 2, 3, 3}, 6}};
  demands.raise(wanted);
  const BudgetedDepths found =
      depths_for_budget(*mesh, {}, {{10'000}, {}, &demands}, progress).value();
  const LabelsWithDemands labels =
      legal_labels(*mesh, found.chosen.depths.values(), demands, {}, progress).value();
  EXPECT_EQ(found.count,
            predict_refinement(*mesh, labels.legal.labels, kAllLevels, labels.fine.get()).faces);
  EXPECT_LE(found.count, 10'000U);
  EXPECT_LT(faces_of(*mesh, found.chosen.depths, {}), found.count);
}

TEST(Budget, LeavesLessErrorThanAnEvenPaintingWithMoreFaces) {
  // A flat plate with one sharp bump: an even painting spends nearly all on the plate.
  PolygonSoup soup = test::grid_soup(20, 20);
  for (glm::dvec3& p : soup.positions) {
    p.z = 3.0 * std::exp(-0.5 * ((p.x - 7.0) * (p.x - 7.0) + (p.y - 9.0) * (p.y - 9.0)));
  }
  const MeshPointer mesh = test::control_mesh(soup);
  SubdivisionSettings settings;
  settings.points = SurfacePoints::kLimit;
  IgnoreProgress progress;
  const FaceDepths even(mesh->face_count(), 2);
  const std::uint64_t quarter = faces_of(*mesh, even, settings) / 4;
  const BudgetedDepths found =
      depths_for_budget(*mesh, settings,
                        {{quarter, FaceBudget::Unit::kFaces, FaceBudget::Goal::kGreatest}, {}},
                        progress)
          .value();
  EXPECT_LT(measured(*mesh, found.chosen.depths, settings), 0.5 * measured(*mesh, even, settings));
}

/// All paintings of a cube, by brute force: hardly any of as few faces has less error.
TEST(Budget, IsNearTheOptimumOnASquashedCube) {
  PolygonSoup soup = test::cube_soup();
  for (glm::dvec3& p : soup.positions) {
    p = {p.x + 0.2 * p.y, 2.0 * p.y, p.z * (p.y > 0 ? 0.4 : 1.0)};
  }
  const MeshPointer mesh = test::control_mesh(soup);
  SubdivisionSettings settings;
  settings.points = SurfacePoints::kLimit;
  IgnoreProgress progress;
  const auto errors = face_errors(*mesh, {}, progress).value();
  const auto error_of = [&](const FaceDepths& depths) {
    double greatest = 0.0;
    for (std::size_t f = 0; f < 6; ++f) {
      greatest = std::max<double>(greatest, errors[f][static_cast<std::size_t>(depths[f])]);
    }
    return greatest;
  };
  for (const std::uint64_t most : {30U, 60U, 120U, 250U, 500U}) {
    const BudgetedDepths found =
        depths_for_budget(*mesh, settings,
                          {{most, FaceBudget::Unit::kFaces, FaceBudget::Goal::kGreatest}, {}},
                          progress)
            .value();
    double optimum = std::numeric_limits<double>::infinity();
    constexpr int kPaintings = 5 * 5 * 5 * 5 * 5 * 5;
    for (int painting = 0; painting < kPaintings; ++painting) {
      FaceDepths depths(6);
      int rest = painting;
      for (std::size_t f = 0; f < 6; ++f, rest /= 5) {
        depths.set(f, rest % 5);
      }
      if (error_of(depths) < optimum && faces_of(*mesh, depths, settings) <= most) {
        optimum = error_of(depths);
      }
    }
    EXPECT_LE(found.chosen.expected_error, 1.05 * optimum) << most;
  }
}

TEST(DepthCurve, IsStraightBetweenPointsAndLevelOutside) {
  const DepthCurve curve = DepthCurve::through({{10.0, 0}, {20.0, 4}, {30.0, 1}}).value();
  EXPECT_EQ(curve(-5.0), 0);
  EXPECT_EQ(curve(10.0), 0);
  EXPECT_EQ(curve(12.4), 1);
  EXPECT_EQ(curve(15.0), 2);
  EXPECT_EQ(curve(20.0), 4);
  EXPECT_EQ(curve(25.0), 3);  // 2.5, rounded.
  EXPECT_EQ(curve(1e300), 1);
  EXPECT_EQ(curve(std::numeric_limits<double>::quiet_NaN()), 0);
}

TEST(DepthCurve, ValuesAreCountedInBins) {
  const std::vector<double> values{-1.0, 0.0, 0.9, 1.0, 3.9, 4.0, 9.0};
  EXPECT_THAT(histogram(values, 0.0, 4.0, 4), ElementsAre(3, 1, 0, 3));
}

/// A camera at a distance on the z axis that looks at the origin: 100 pixels to a unit there.
ScreenView front(double distance) {
  ScreenView view;
  view.eye = {0.0, 0.0, distance};
  view.near_plane = 0.01;
  view.half_height = 5.0 / distance;
  view.width = 1000.0;
  view.height = 1000.0;
  return view;
}

/// A flat grid of 8 x 8 unit squares around the origin, seen from +z.
MeshPointer flat_grid() {
  PolygonSoup soup = test::grid_soup(8, 8);
  for (glm::dvec3& p : soup.positions) {
    p = {p.x - 4.0, p.y - 4.0, 0.0};
  }
  return test::control_mesh(soup);
}

TEST(ScreenSizes, AreThoseOfAPlane) {
  const MeshPointer grid = flat_grid();
  IgnoreProgress progress;
  const std::vector<ScreenView> views{front(20.0)};
  const auto edges =
      screen_sizes(*grid, CornerRule::kSharp, ScreenSize::Of::kEdge, views, progress).value();
  const auto areas =
      screen_sizes(*grid, CornerRule::kSharp, ScreenSize::Of::kArea, views, progress).value();
  EXPECT_NEAR(edges[27], 100.0, 1e-6);  // In the middle.
  EXPECT_NEAR(areas[27], 10000.0, 1e-3);
  ScreenView orthographic = views[0];
  orthographic.is_orthographic = true;
  orthographic.half_height = 10.0;
  EXPECT_NEAR(screen_sizes(*grid, CornerRule::kSharp, ScreenSize::Of::kEdge,
                           std::vector{orthographic}, progress)
                  .value()[27],
              50.0, 1e-6);
}

TEST(ScreenSizes, AreNothingOutsideOfThePicture) {
  const MeshPointer grid = flat_grid();
  IgnoreProgress progress;
  ScreenView view = front(20.0);
  view.half_height /= 5.0;  // Two units are seen of the eight, at five times the size.
  const auto edges =
      screen_sizes(*grid, CornerRule::kSharp, ScreenSize::Of::kEdge, std::vector{view}, progress)
          .value();
  for (std::size_t f = 0; f < edges.size(); ++f) {
    const std::size_t x = f % 8;
    const std::size_t y = f / 8;
    const bool shows = x >= 3 && x <= 4 && y >= 3 && y <= 4;
    EXPECT_NEAR(edges[f], shows ? 500.0 : 0.0, 1e-6) << f;
  }
  // Several cameras: whichever sees it larger.
  const auto both = screen_sizes(*grid, CornerRule::kSharp, ScreenSize::Of::kEdge,
                                 std::vector{view, front(20.0)}, progress)
                        .value();
  EXPECT_NEAR(both[27], 500.0, 1e-6);
  EXPECT_NEAR(both[18], 100.0, 1e-6);
}

TEST(ScreenDepths, HalveSidesUntilTheyAreSmallEnough) {
  const MeshPointer grid = flat_grid();
  IgnoreProgress progress;
  const std::vector<ScreenView> views{front(20.0)};
  const auto depths = [&](const ScreenSize& size) {
    return depths_for_screen(*grid, {}, size, views, progress).value();
  };
  EXPECT_EQ(depths({ScreenSize::Of::kEdge, 100.1, 1})[27], 0);
  EXPECT_EQ(depths({ScreenSize::Of::kEdge, 99.0, 1})[27], 1);
  EXPECT_EQ(depths({ScreenSize::Of::kEdge, 12.6, 1})[27], 3);
  EXPECT_EQ(depths({ScreenSize::Of::kArea, 160.0, 1})[27], 3);
}

TEST(ScreenDepths, LeaveTheBackCoarseAndMakeSilhouettesFiner) {
  const MeshPointer torus = test::control_mesh(test::torus_soup(24, 16));
  IgnoreProgress progress;
  ScreenView view = front(200.0);
  const auto with = [&](int silhouettes) {
    return depths_for_screen(*torus, {}, {ScreenSize::Of::kEdge, 5.0, silhouettes},
                             std::vector{view}, progress)
        .value();
  };
  const FaceDepths plain = with(0);
  const FaceDepths finer = with(2);
  std::size_t back = 0;
  std::size_t raised = 0;
  for (std::size_t f = 0; f < plain.size(); ++f) {
    back += plain[f] == 0 ? 1 : 0;
    raised += finer[f] == plain[f] + 2 ? 1 : 0;
    EXPECT_TRUE(finer[f] == plain[f] || finer[f] == plain[f] + 2);
  }
  EXPECT_GT(back, plain.size() / 4);
  EXPECT_LT(back, plain.size() * 3 / 5);
  EXPECT_GT(raised, 24U);
  EXPECT_LT(raised, plain.size() / 2);
}

TEST(PixelLengths, FollowTheDistanceToTheEye) {
  const MeshPointer grid = flat_grid();
  IgnoreProgress progress;
  const auto near_by =
      pixel_lengths(*grid, CornerRule::kSharp, std::vector{front(20.0)}, progress).value();
  EXPECT_NEAR(near_by[27], 0.01, 1e-9);
  ScreenView behind = front(20.0);
  behind.eye.z = -20.0;  // Looks away.
  const auto nowhere =
      pixel_lengths(*grid, CornerRule::kSharp, std::vector{behind}, progress).value();
  EXPECT_EQ(nowhere[27], std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace limn
