#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/mailbox.h"
#include "limn/comparison/sphere_fit.h"
#include "ui/model.h"

namespace limn::app {

/// Compares schemes with spheres on a thread of its own and keeps the last answer.
class SphereJob {
 public:
  /// `wake` is called from the worker whenever there is something new to look at.
  /// `arrivals` is that of its Mailbox, "sphere".
  explicit SphereJob(std::function<void()> wake, Arrivals* arrivals = nullptr)
      : wake_(std::move(wake)), answers_("sphere", arrivals) {}
  /// Gives up what runs and waits for it to notice.
  ~SphereJob() { cancel(); }
  SphereJob(const SphereJob&) = delete;
  SphereJob& operator=(const SphereJob&) = delete;

  /// What is compared; all of `schemes` take the mesh.
  struct Question {
    std::shared_ptr<const ControlMesh> control;
    std::vector<SchemeSettings> schemes;
    int levels = 0;

    [[nodiscard]] bool operator==(const Question&) const = default;
  };
  /// Gives up what runs and begins anew.
  void start(Question question);
  void cancel();
  void wait();
  /// Takes in what was found; true where there was anything.
  bool update();

  /// Whether an answer is on its way.
  [[nodiscard]] bool is_busy() const noexcept { return is_busy_; }
  /// For the panels, where the question is still this one. Spans live until the next `start`.
  [[nodiscard]] ui::SphereStatus status(const Question& current) const;

 private:
  class JobProgress;
  void work(const std::stop_token& stop);

  struct Answer {
    std::vector<ui::SphereSeries> series;
    std::string problem;
  };

  std::function<void()> wake_;
  Mailbox<Answer> answers_;
  Question question_;
  bool is_busy_ = false;
  Answer answer_;  ///< The last one taken in.
  std::atomic<double> fraction_ = 0.0;
  std::jthread worker_;
};

}  // namespace limn::app
