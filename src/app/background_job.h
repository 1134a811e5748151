#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "app/mailbox.h"
#include "limn/error.h"
#include "limn/progress.h"

namespace limn::app {

/// Works out one answer at a time on a thread of its own. What is found is handed over at its end,
/// all at once.
template <class Answer>
class BackgroundJob {
 public:
  /// Errors of kind kCancelled are never seen: they answer nobody.
  using Work = std::function<Result<Answer>(Progress& progress)>;

  /// `wake` is called from the worker whenever there is something new to look at. `name` and
  /// `arrivals` are those of its Mailbox.
  BackgroundJob(std::string name, std::function<void()> wake, Arrivals* arrivals)
      : wake_(std::move(wake)), answers_(std::move(name), arrivals) {}
  /// Gives up what runs and waits for it to notice.
  ~BackgroundJob() { cancel(); }
  BackgroundJob(const BackgroundJob&) = delete;
  BackgroundJob& operator=(const BackgroundJob&) = delete;

  /// Gives up what runs and begins anew. `work` is called from the worker; it must not refer to
  /// anything that changes meanwhile.
  void start(Work work) {
    cancel();
    fraction_ = 0.0;
    is_busy_ = true;
    worker_ = std::jthread([this, work = std::move(work)](const std::stop_token& stop) {
      JobProgress progress(*this, stop);
      Result<Answer> answer = carry_out(work, progress);
      answers_.put(std::move(answer));
      wake_();
    });
  }
  void cancel() {
    worker_.request_stop();
    wait();
    answers_.clear();
    is_busy_ = false;
  }
  void wait() {
    if (worker_.joinable()) {
      worker_.join();
    }
  }
  /// What was found since the last call, if anything.
  [[nodiscard]] std::optional<Result<Answer>> take() {
    std::vector<Result<Answer>> answers = answers_.take();
    if (answers.empty()) {
      return std::nullopt;
    }
    is_busy_ = false;
    return std::move(answers.back());
  }

  /// Whether an answer is on its way.
  [[nodiscard]] bool is_busy() const noexcept { return is_busy_; }
  /// How far it is, 0..1; nothing where none is on its way.
  [[nodiscard]] std::optional<double> running() const noexcept {
    return is_busy_ ? std::optional(fraction_.load()) : std::nullopt;
  }

 private:
  class JobProgress final : public Progress {
   public:
    JobProgress(BackgroundJob& job, const std::stop_token& stop) : job_(job), stop_(stop) {}

    [[nodiscard]] bool report(double fraction, std::string_view) override {
      constexpr auto kBetween = std::chrono::milliseconds(40);
      if (const auto now = std::chrono::steady_clock::now(); now - woken_at_ >= kBetween) {
        woken_at_ = now;
        job_.fraction_ = fraction;
        job_.wake_();
      }
      return !stop_.stop_requested();
    }

   private:
    BackgroundJob& job_;
    const std::stop_token& stop_;
    std::chrono::steady_clock::time_point woken_at_ = std::chrono::steady_clock::now();
  };

  static Result<Answer> carry_out(const Work& work, Progress& progress) {
    try {
      return work(progress);
    } catch (const std::bad_alloc&) {
      return fail(ErrorKind::kFailed, "There is not enough memory for this.");
    }
  }

  std::function<void()> wake_;
  Mailbox<Result<Answer>> answers_;
  bool is_busy_ = false;
  std::atomic<double> fraction_ = 0.0;
  std::jthread worker_;
};

}  // namespace limn::app
