// As in refinement_job.cpp: a question is taken out of `waiting_` under a ticket, and an answer is
// put into the mailbox under the same lock that says whether its ticket is still the last one.
#include "app/paint_tools/forecast_job.h"

#include <new>
#include <string_view>
#include <utility>

#include "limn/document/refinement.h"
#include "limn/progress.h"

namespace limn::app {

/// Tells work that it went stale.
class ForecastJob::Watch final : public Progress {
 public:
  Watch(const ForecastJob& job, const std::stop_token& stop, std::uint64_t ticket)
      : job_(job), stop_(stop), ticket_(ticket) {}

  [[nodiscard]] bool report(double, std::string_view) override {
    if (stop_.stop_requested()) {
      return false;
    }
    const std::lock_guard lock(job_.mutex_);
    return job_.ticket_ == ticket_;
  }

 private:
  const ForecastJob& job_;
  const std::stop_token& stop_;
  std::uint64_t ticket_;
};

ForecastJob::ForecastJob(std::function<void()> wake, Arrivals* arrivals)
    : wake_(std::move(wake)),
      answers_("forecast", arrivals),
      worker_([this](const std::stop_token& stop) { work(stop); }) {}

ForecastJob::~ForecastJob() {
  forget();
  worker_.request_stop();
  worker_.join();
}

void ForecastJob::ask(Question question) {
  if (question == asked_) {
    return;
  }
  asked_ = question;
  added_.reset();
  {
    const std::lock_guard lock(mutex_);
    ++ticket_;
    answers_.clear();
    waiting_ = std::move(question);
  }
  changed_.notify_all();
}

void ForecastJob::forget() {
  if (asked_.control == nullptr) {
    return;
  }
  asked_ = {};
  added_.reset();
  const std::lock_guard lock(mutex_);
  ++ticket_;
  answers_.clear();
  waiting_.reset();
}

bool ForecastJob::update() {
  const std::vector<std::int64_t> answers = answers_.take();
  if (answers.empty()) {
    return false;
  }
  added_ = answers.back();
  return true;
}

void ForecastJob::wait_until_idle() const {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !waiting_ && !is_working_; });
}

void ForecastJob::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (changed_.wait(lock, stop, [this] { return waiting_.has_value(); })) {
    const Question question = *std::exchange(waiting_, std::nullopt);
    const std::uint64_t ticket = ticket_;
    is_working_ = true;
    lock.unlock();
    std::optional<std::int64_t> added;
    try {
      Watch watch(*this, stop, ticket);
      added = answer(question, watch);
    } catch (const std::bad_alloc&) {
      known_ = {};  // Then nothing is foretold.
    }
    lock.lock();
    is_working_ = false;
    if (added && ticket == ticket_) {
      answers_.put(*added);
      wake_();
    }
    changed_.notify_all();
  }
}

std::optional<std::int64_t> ForecastJob::answer(const Question& question, Watch& watch) {
  const auto faces_of = [&](const FaceDepths& depths,
                            const FineDemands& demands) -> std::optional<std::uint64_t> {
    const auto labels =
        derive_labels(*question.control, depths.values(), question.settings, watch, demands);
    if (!labels) {
      return std::nullopt;
    }
    return predict_derived(*question.control, *labels, question.levels).faces;
  };
  if (known_.control != question.control || known_.depths != question.depths ||
      known_.settings != question.settings || known_.levels != question.levels ||
      known_.demands != question.demands) {
    const auto faces = faces_of(question.depths, question.demands);
    if (!faces) {
      return std::nullopt;
    }
    known_ = {question.control, question.depths,  {}, question.settings,
              question.levels,  question.demands, {}};
    known_faces_ = *faces;
  }
  FaceDepths changed = question.depths;
  apply_edits(changed, question.edits);
  FineDemands demands = question.demands;
  demands.apply(question.demand_edits);
  const auto faces = faces_of(changed, demands);
  // Counts stop at 2^64 - 1; beyond 2^63 there is nothing that anyone would draw.
  constexpr auto kMost = static_cast<std::uint64_t>(INT64_MAX);
  if (!faces || *faces > kMost || known_faces_ > kMost) {
    return std::nullopt;
  }
  return static_cast<std::int64_t>(*faces) - static_cast<std::int64_t>(known_faces_);
}

}  // namespace limn::app
