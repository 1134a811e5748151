#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/refinement_job.h"
#include "limn/document/document.h"
#include "ui/model.h"

namespace limn::app {

/// Keeps the refined mesh of a document up to date off the main thread, and remembers the last good
/// one meanwhile.
class LiveRefinement {
 public:
  static constexpr std::uint64_t kDefaultBudget = 5'000'000;

  /// `wake` is called from the worker's thread when `update` has something to do.
  /// `name` and `arrivals` are those of the job's Mailbox.
  explicit LiveRefinement(std::function<void()> wake, std::string name = "refinement",
                          Arrivals* arrivals = nullptr)
      : job_(std::move(wake), std::move(name), arrivals) {}

  struct Wish {
    bool is_stroking = false;    ///< Wait for what runs instead of starting over at every dab.
    bool needs_refined = false;  ///< Refine to the end even at stage 0, for an export.
    /// This scheme and level instead of what the document shows.
    struct Other {
      SchemeSettings scheme;
      int levels = 0;
    };
    std::optional<Other> other{};
  };
  /// Starts over where the document is not what was last worked on.
  void follow(const Document& document, const Wish& wish);
  /// Takes in what the worker has found; returns true where there was anything.
  bool update();

  /// Gives up what runs. The next change of the document starts afresh.
  void cancel();
  /// Works on the same state again, after a cancel or a declined question.
  void restart();
  void wait_until_idle() const { job_.wait_until_idle(); }

  /// Whether something was asked for that has not come yet, and was not given up.
  [[nodiscard]] bool is_busy() const noexcept { return is_waiting_; }
  /// Whether all that was asked for is there: nothing runs, nothing was given up.
  [[nodiscard]] bool is_up_to_date() const noexcept;
  /// Labels of the newest painting they are known for; null before the first.
  [[nodiscard]] const DerivedLabels* labels() const noexcept;
  /// The newest refinement of the control mesh in force; null where there is none.
  [[nodiscard]] const JobResult* refined() const noexcept { return refined_.get(); }
  /// The same for whoever keeps it.
  [[nodiscard]] const std::shared_ptr<const JobResult>& shared_refined() const noexcept {
    return refined_;
  }
  /// Counts up with every new refined mesh or its going away.
  [[nodiscard]] std::uint64_t refined_revision() const noexcept { return refined_revision_; }
  /// `Revisions::depths` of the painting that `refined` was made from; 0 where there is none.
  [[nodiscard]] std::uint64_t refined_depths() const noexcept { return refined_depths_; }
  /// Counts up with new labels.
  [[nodiscard]] std::uint64_t labels_revision() const noexcept { return labels_revision_; }

  /// Set while a refinement above the budget waits for an answer.
  [[nodiscard]] std::optional<ui::OverBudgetQuestion> question() const;
  /// Goes on, and lets this document's refinements grow to twice as many faces unasked.
  void accept();
  /// Leaves the last good result; asks no more until something fits the budget again.
  void decline();

  /// Most bytes of a refined mesh, whatever the person agrees to; without, what the machine can
  /// spare at the time.
  void set_memory_budget(std::uint64_t bytes) noexcept { memory_budget_ = bytes; }
  void set_face_budget(std::uint64_t faces) noexcept { budget_ = faces; }
  [[nodiscard]] std::uint64_t face_budget() const noexcept { return budget_; }

  /// Why the last refinement failed, once.
  [[nodiscard]] std::optional<Error> take_error() { return std::exchange(error_, std::nullopt); }

  /// For the panels. Pointers in it live until the next `update`.
  [[nodiscard]] ui::RefinementStatus status() const;

 private:
  void set_refined(std::shared_ptr<const JobResult> result);

  RefinementJob job_;
  std::uint64_t budget_ = kDefaultBudget;
  std::optional<std::uint64_t> memory_budget_;
  std::uint64_t raised_budget_ = 0;  ///< What the person has agreed to for this control mesh.

  std::shared_ptr<const ControlMesh> control_;  ///< What was last submitted.
  Revisions submitted_;
  std::optional<SchemeSettings> submitted_scheme_;
  int submitted_levels_ = -1;  ///< -1: submit at the next opportunity.
  std::uint64_t serial_ = 0;
  bool is_waiting_ = false;  ///< For what was last submitted.
  std::optional<Error> error_;

  std::shared_ptr<const JobResult> newest_;
  std::shared_ptr<const JobResult> refined_;
  std::uint64_t refined_revision_ = 0;
  std::uint64_t refined_depths_ = 0;
  std::uint64_t labels_revision_ = 0;
  bool is_silenced_ = false;  ///< The question was declined.
};

}  // namespace limn::app
