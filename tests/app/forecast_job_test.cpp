#include "app/paint_tools/forecast_job.h"

#include <atomic>
#include <chrono>
#include <vector>

#include <gtest/gtest.h>

#include "limn/document/refinement.h"
#include "limn/progress.h"
#include "support/shapes.h"

namespace limn::app {
namespace {

ForecastJob::Question question(const test::MeshPointer& mesh, test::Random& random) {
  ForecastJob::Question question;
  question.control = mesh;
  question.depths = FaceDepths(mesh->face_count());
  for (std::uint32_t f = 0; f < mesh->face_count(); ++f) {
    question.depths.set(f, random() % 3 == 0 ? static_cast<int>(random() % 4) : 0);
    if (random() % 4 == 0) {
      const auto before = static_cast<std::uint8_t>(question.depths[f]);
      question.edits.push_back({f, before, static_cast<std::uint8_t>(random() % 5)});
    }
  }
  question.settings.legalisation =
      random() % 2 == 0 ? LegalisationMethod::kGreedy : LegalisationMethod::kLookAhead;
  question.levels = random() % 2 == 0 ? kAllLevels : 2;
  return question;
}

std::int64_t faces(const ForecastJob::Question& question, const FaceDepths& depths) {
  IgnoreProgress progress;
  const auto labels =
      derive_labels(*question.control, depths.values(), question.settings, progress).value();
  return static_cast<std::int64_t>(
      predict_derived(*question.control, labels, question.levels).faces);
}

std::int64_t expected(const ForecastJob::Question& question) {
  FaceDepths after = question.depths;
  apply_edits(after, question.edits);
  return faces(question, after) - faces(question, question.depths);
}

TEST(ForecastJob, ForetellsTheDifferenceExactly) {
  test::Random random(21);
  ForecastJob job([] {});
  for (int round = 0; round < 30; ++round) {
    auto soup = round % 2 == 0 ? test::torus_soup(8, 6) : test::grid_soup(7, 6);
    const auto mesh = test::control_mesh(test::with_mixed_faces(soup, random));
    ForecastJob::Question asked = question(mesh, random);
    job.ask(asked);
    job.wait_until_idle();
    EXPECT_TRUE(job.update());
    EXPECT_EQ(job.added_faces(), expected(asked));
    asked.edits.resize(asked.edits.size() / 2);  // The same painting, other faces under the brush.
    job.ask(asked);
    EXPECT_EQ(job.added_faces(), std::nullopt) << "nothing is told of a question not answered yet";
    job.wait_until_idle();
    job.update();
    EXPECT_EQ(job.added_faces(), expected(asked));
  }
}

TEST(ForecastJob, OnlyTheLastQuestionIsAnswered) {
  test::Random random(22);
  const auto mesh = test::control_mesh(test::torus_soup(40, 30));
  std::atomic<int> woken = 0;
  ForecastJob job([&woken] { ++woken; });
  ForecastJob::Question last;
  for (int round = 0; round < 50; ++round) {
    last = question(mesh, random);
    job.ask(last);
    job.update();
  }
  job.wait_until_idle();
  job.update();
  EXPECT_EQ(job.added_faces(), expected(last));
  EXPECT_GE(woken, 1);
}

TEST(ForecastJob, TheSameQuestionIsNotAskedTwice) {
  test::Random random(23);
  const auto mesh = test::control_mesh(test::torus_soup(8, 6));
  ForecastJob job([] {});
  const ForecastJob::Question asked = question(mesh, random);
  job.ask(asked);
  job.wait_until_idle();
  job.update();
  job.ask(asked);
  EXPECT_EQ(job.added_faces(), expected(asked)) << "what is known stays known";
  job.forget();
  EXPECT_EQ(job.added_faces(), std::nullopt);
  job.ask(asked);
  EXPECT_EQ(job.added_faces(), std::nullopt);
  job.wait_until_idle();
  EXPECT_TRUE(job.update());
  EXPECT_EQ(job.added_faces(), expected(asked));
}

TEST(ForecastJob, ForgettingKeepsALateAnswerOut) {
  test::Random random(24);
  const auto mesh = test::control_mesh(test::torus_soup(20, 20));
  for (int round = 0; round < 20; ++round) {
    ForecastJob job([] {});
    job.ask(question(mesh, random));
    job.forget();
    job.wait_until_idle();
    EXPECT_FALSE(job.update());
    EXPECT_EQ(job.added_faces(), std::nullopt);
  }
}

TEST(ForecastJob, WhatCannotBeRefinedHasNoForecast) {
  test::Random random(25);
  ForecastJob job([] {});
  ForecastJob::Question asked = question(test::grid(4), random);
  asked.settings.scheme = RefinementScheme::kLoop;  // Quads.
  job.ask(asked);
  job.wait_until_idle();
  EXPECT_FALSE(job.update());
  EXPECT_EQ(job.added_faces(), std::nullopt);
}

}  // namespace
}  // namespace limn::app
