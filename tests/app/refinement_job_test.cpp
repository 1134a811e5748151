// The worker against the same steps done in one thread, and what happens when requests come fast.
#include "app/refinement_job.h"

#include <atomic>

#include <gtest/gtest.h>

#include "limn/mesh/bundled.h"
#include "limn/subdivision/label_subdivision.h"

namespace limn::app {
namespace {

std::shared_ptr<const ControlMesh> bundled(std::string_view name) {
  return load_bundled_mesh(name).value().mesh;
}

JobRequest request_of(const std::shared_ptr<const ControlMesh>& control, std::uint64_t serial,
                      int depth) {
  JobRequest request;
  request.serial = serial;
  request.control = control;
  request.depths = FaceDepths(control->face_count());
  request.depths.set(0, depth);
  request.levels = kAllLevels;
  return request;
}

TEST(RefinementJob, GivesWhatTheSameStepsGiveInOneThread) {
  const auto control = bundled("torus_open");
  const JobRequest request = request_of(control, 7, 3);
  std::atomic<int> wakes = 0;
  RefinementJob job([&] { ++wakes; });
  job.submit(request);
  job.wait_until_idle();
  const auto result = job.take_result();
  ASSERT_NE(result, nullptr);
  EXPECT_EQ(result->serial, 7u);
  EXPECT_TRUE(result->is_final);
  EXPECT_EQ(result->illegal_left, 0u);
  EXPECT_GT(wakes.load(), 0);

  IgnoreProgress ignore;
  const auto labels = legal_labels(*control, request.depths.values(), {}, ignore);
  ASSERT_TRUE(labels.has_value());
  const auto mesh = refine(*control, labels->labels, {}, {}, ignore);
  ASSERT_TRUE(mesh.has_value());
  ASSERT_NE(result->refinement, nullptr);
  EXPECT_EQ(result->refinement->mesh->quads, mesh->quads);
  EXPECT_EQ(result->refinement->mesh->positions, mesh->positions);
  EXPECT_EQ(result->prediction.faces, mesh->face_count());
  EXPECT_TRUE(result->refinement->cracks.is_watertight());
  EXPECT_EQ(job.take_result(), nullptr) << "handed out once";
}

TEST(RefinementJob, NewestRequestWins) {
  const auto control = bundled("torus_open");
  RefinementJob job([] {});
  for (std::uint64_t serial = 1; serial <= 50; ++serial) {
    job.submit(request_of(control, serial, static_cast<int>(serial % 5)));
    if (const auto result = job.take_result()) {
      EXPECT_LE(result->serial, serial);
    }
  }
  job.wait_until_idle();
  const auto result = job.take_result();
  ASSERT_NE(result, nullptr);
  EXPECT_EQ(result->serial, 50u);
  EXPECT_TRUE(result->is_final);
}

TEST(RefinementJob, CancelledWorkLeavesNothing) {
  const auto control = bundled("torus_open");
  RefinementJob job([] {});
  job.submit(request_of(control, 1, 10));
  job.cancel();
  job.wait_until_idle();
  const auto result = job.take_result();
  EXPECT_TRUE(result == nullptr || result->refinement == nullptr);
  EXPECT_FALSE(job.take_error().has_value()) << "cancelling is no failure";
  EXPECT_FALSE(job.status().is_busy);
}

TEST(RefinementJob, AboveTheBudgetItOnlyPredicts) {
  const auto control = bundled("cube");
  JobRequest request = request_of(control, 1, 6);
  request.face_budget = 9075;
  RefinementJob job([] {});
  job.submit(request);
  job.wait_until_idle();
  auto result = job.take_result();
  ASSERT_NE(result, nullptr);
  EXPECT_TRUE(result->is_over_budget);
  EXPECT_EQ(result->prediction.faces, 9076u);
  EXPECT_EQ(result->refinement, nullptr);

  request.face_budget = 9076;
  job.submit(request);
  job.wait_until_idle();
  result = job.take_result();
  ASSERT_NE(result, nullptr);
  ASSERT_NE(result->refinement, nullptr);
  EXPECT_EQ(result->refinement->mesh->face_count(), 9076u);
}

TEST(RefinementJob, LabelsOnlyWhereNoLevelIsAskedFor) {
  JobRequest request = request_of(bundled("cube"), 1, 2);
  request.levels = 0;
  RefinementJob job([] {});
  job.submit(request);
  job.wait_until_idle();
  const auto result = job.take_result();
  ASSERT_NE(result, nullptr);
  EXPECT_TRUE(result->is_final);
  EXPECT_EQ(result->refinement, nullptr);
  EXPECT_EQ(result->labels->prediction.faces, 76u);
}

TEST(RefinementJob, EndsInTheMiddleOfWork) {
  RefinementJob job([] {});
  job.submit(request_of(bundled("cube"), 1, 10));
}

}  // namespace
}  // namespace limn::app
