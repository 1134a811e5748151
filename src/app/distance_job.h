#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "app/background_job.h"
#include "limn/comparison/limit_distance.h"
#include "limn/document/refinement.h"
#include "ui/model.h"

namespace limn::app {

/// Measures how far a refined mesh is from its limit surface, on a thread of its own, and keeps the
/// last answer.
class DistanceJob {
 public:
  /// `wake` is called from the worker whenever there is something new to look at.
  /// `arrivals` is that of its Mailbox, "distance".
  explicit DistanceJob(std::function<void()> wake, Arrivals* arrivals = nullptr)
      : job_("distance", std::move(wake), arrivals) {}

  /// What is measured: a refinement of what is painted, to so many levels, or the control mesh.
  struct Question {
    std::shared_ptr<const ControlMesh> control;
    std::shared_ptr<const DerivedLabels> labels;  ///< Null, as the next, for the control mesh.
    std::shared_ptr<const RefinedMesh> mesh;
    SubdivisionSettings settings;
    int levels = 0;

    [[nodiscard]] bool operator==(const Question&) const = default;
  };
  /// Gives up what runs and begins anew.
  void start(Question question);
  void cancel() { job_.cancel(); }
  /// The same for good: the question counts as asked.
  void give_up();
  void wait() { job_.wait(); }
  /// Takes in what was found; true where there was anything.
  bool update();

  /// Whether an answer is on its way.
  [[nodiscard]] bool is_busy() const noexcept { return job_.is_busy(); }
  /// Whether this has been asked, whatever came of it.
  [[nodiscard]] bool has_been_asked(const Question& question) const {
    return question_ == question && (is_busy() || is_answered_);
  }
  /// For the panels, where the question is still this one.
  [[nodiscard]] ui::DistanceStatus status(const Question& current) const;
  /// Of the faces of `mesh`; null where they are not known.
  [[nodiscard]] const LimitDistance* distance(const RefinedMesh* mesh) const noexcept {
    return mesh != nullptr && question_.mesh.get() == mesh ? answer_.distance.get() : nullptr;
  }
  /// Of the faces of the control mesh itself.
  [[nodiscard]] const LimitDistance* distance(const ControlMesh* control) const noexcept {
    return question_.mesh == nullptr && question_.control.get() == control ? answer_.distance.get()
                                                                           : nullptr;
  }
  /// Counts up with every answer.
  [[nodiscard]] std::uint64_t revision() const noexcept { return revision_; }

 private:
  struct Answer {
    std::shared_ptr<const LimitDistance> distance;  ///< Null where it could not be measured.
    std::string problem;
  };

  BackgroundJob<std::shared_ptr<const LimitDistance>> job_;
  Question question_;
  bool is_answered_ = false;
  Answer answer_;  ///< The last one taken in.
  std::uint64_t revision_ = 0;
};

}  // namespace limn::app
