#include "limn/comparison/limit_distance.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "limn/subdivision/label_subdivision.h"
#include "support/shapes.h"

namespace limn::test {
namespace {

struct Measured {
  RefinedMesh refined;
  LimitDistance distance;
};

Measured measured(const ControlMesh& mesh, const std::vector<std::uint8_t>& depths,
                  const SubdivisionSettings& settings = {},
                  const LimitDistanceLimits& limits = {}) {
  IgnoreProgress nobody;
  const VertexLabels labels = legal_labels(mesh, depths, settings, nobody).value().labels;
  Measured result;
  result.refined = refine(mesh, labels, settings, {}, nobody).value();
  result.distance =
      measure_limit_distance(mesh, labels, settings, result.refined, nobody, limits).value();
  return result;
}

/// The limits of its corners are at half the distance from the centre, those of its faces' middles
/// at 0.8395: worked out from the masks.
TEST(LimitDistance, OfTheCubeItselfIsThatOfItsCorners) {
  const auto [refined, distance] = measured(*cube(), std::vector<std::uint8_t>(6, 0));
  EXPECT_TRUE(distance.is_settled);
  EXPECT_NEAR(distance.to_limit.greatest, std::sqrt(0.75), 1e-6);
  EXPECT_NEAR(distance.from_limit.greatest, 0.5, 1e-6);
  EXPECT_NEAR(distance.to_limit.area, 24.0, 1e-9);
  ASSERT_EQ(distance.of_faces.size(), 6u);
  for (const float of_face : distance.of_faces) {
    EXPECT_NEAR(of_face, std::sqrt(0.75), 1e-6);
  }
  const glm::dvec3 corner = glm::abs(distance.to_limit.from);
  EXPECT_EQ(corner, glm::dvec3(1.0));
  EXPECT_NEAR(glm::distance(glm::abs(distance.to_limit.to), glm::dvec3(0.5)), 0.0, 1e-6);
}

TEST(LimitDistance, FallsToAQuarterWithEveryLevel) {
  for (const SurfacePoints points : {SurfacePoints::kLevel, SurfacePoints::kLimit}) {
    double before = 0.0;
    for (int depth = 2; depth <= 4; ++depth) {
      const auto depths = std::vector<std::uint8_t>(6, static_cast<std::uint8_t>(depth));
      const double now = measured(*cube(), depths, {.points = points}).distance.root_mean_square();
      if (depth > 2) {
        EXPECT_NEAR(now, 0.25 * before, 0.01 * before);
      }
      before = now;
    }
  }
}

TEST(LimitDistance, StopsWhenAsked) {
  class Cancel final : public Progress {
    bool report(double, std::string_view) override { return ++reports_ < 30; }
    int reports_ = 0;
  } cancel;
  IgnoreProgress nobody;
  const VertexLabels labels(8, 2);
  const RefinedMesh refined = refine(*cube(), labels, {}, {}, nobody).value();
  const auto cancelled = measure_limit_distance(*cube(), labels, {}, refined, cancel);
  ASSERT_FALSE(cancelled);
  EXPECT_EQ(cancelled.error().kind, ErrorKind::kCancelled);
}

/// Whatever it is at.
TEST(LimitDistance, CanBeStoppedAtAnyTime) {
  class StopAt final : public Progress {
   public:
    explicit StopAt(int reports) : left_(reports) {}
    bool report(double, std::string_view) override { return --left_ >= 0; }
    [[nodiscard]] bool has_stopped() const { return left_ < 0; }

   private:
    int left_;
  };
  IgnoreProgress nobody;
  const VertexLabels labels(8, 3);
  const RefinedMesh refined = refine(*cube(), labels, {}, {}, nobody).value();
  bool is_stopped = true;
  for (int reports = 0; is_stopped; ++reports) {
    StopAt stop(reports);
    const auto measured = measure_limit_distance(*cube(), labels, {}, refined, stop);
    is_stopped = stop.has_stopped();
    EXPECT_EQ(measured.has_value(), !is_stopped) << reports;
  }
}

TEST(LimitDistance, IsOfCatmullClarkAlone) {
  IgnoreProgress nobody;
  const SubdivisionSettings settings{.scheme = RefinementScheme::kLoop};
  const auto refused =
      measure_limit_distance(*cube(), VertexLabels(8, 0), settings, RefinedMesh{}, nobody);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kUsage);
}

}  // namespace
}  // namespace limn::test
