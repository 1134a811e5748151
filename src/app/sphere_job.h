#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/background_job.h"
#include "limn/comparison/sphere_fit.h"
#include "ui/model.h"

namespace limn::app {

/// Compares schemes with spheres on a thread of its own and keeps the last answer.
class SphereJob {
 public:
  /// `wake` is called from the worker whenever there is something new to look at.
  /// `arrivals` is that of its Mailbox, "sphere".
  explicit SphereJob(std::function<void()> wake, Arrivals* arrivals = nullptr)
      : job_("sphere", std::move(wake), arrivals) {}

  /// What is compared; all of `schemes` take the mesh.
  struct Question {
    std::shared_ptr<const ControlMesh> control;
    std::vector<SchemeSettings> schemes;
    int levels = 0;

    [[nodiscard]] bool operator==(const Question&) const = default;
  };
  /// Gives up what runs and begins anew.
  void start(Question question);
  void cancel() { job_.cancel(); }
  void wait() { job_.wait(); }
  /// Takes in what was found; true where there was anything.
  bool update();

  /// Whether an answer is on its way.
  [[nodiscard]] bool is_busy() const noexcept { return job_.is_busy(); }
  /// For the panels, where the question is still this one. Spans live until the next `start`.
  [[nodiscard]] ui::SphereStatus status(const Question& current) const;

 private:
  struct Answer {
    std::vector<ui::SphereSeries> series;
    std::string problem;  ///< Of what is missing among them.
  };
  [[nodiscard]] static Result<Answer> compare(const Question& question, Progress& progress);

  BackgroundJob<Answer> job_;
  Question question_;
  Answer answer_;  ///< The last one taken in.
};

}  // namespace limn::app
