#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "limn/comparison/sphere_fit.h"
#include "ui/model.h"

namespace limn::app {

/// Compares schemes with spheres on a thread of its own and keeps the last answer.
class SphereJob {
 public:
  /// `wake` is called from the worker whenever there is something new to look at.
  explicit SphereJob(std::function<void()> wake) : wake_(std::move(wake)) {}
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

  [[nodiscard]] bool is_busy() const;
  /// For the panels, where the question is still this one. Spans live until the next `start`.
  [[nodiscard]] ui::SphereStatus status(const Question& current) const;

 private:
  class JobProgress;
  void work(const std::stop_token& stop);

  std::function<void()> wake_;
  Question question_;
  mutable std::mutex mutex_;
  std::optional<double> fraction_;  ///< While it runs.
  std::vector<ui::SphereSeries> series_;
  std::string problem_;
  std::jthread worker_;
};

}  // namespace limn::app
