// One thread a question. What it has found is handed over at its end, all at once.
#include "app/sphere_job.h"

#include <chrono>
#include <new>
#include <utility>

#include "limn/progress.h"

namespace limn::app {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kWakeInterval = std::chrono::milliseconds(40);

}  // namespace

/// The progress of one scheme of several, passed on to the owner.
class SphereJob::JobProgress final : public Progress {
 public:
  JobProgress(SphereJob& job, const std::stop_token& stop) : job_(job), stop_(stop) {}

  void begin(std::size_t scheme) { scheme_ = scheme; }

  [[nodiscard]] bool report(double fraction, std::string_view) override {
    if (const auto now = Clock::now(); now - woken_at_ >= kWakeInterval) {
      woken_at_ = now;
      job_.fraction_ = (static_cast<double>(scheme_) + fraction) /
                       static_cast<double>(job_.question_.schemes.size());
      job_.wake_();
    }
    return !stop_.stop_requested();
  }

 private:
  SphereJob& job_;
  const std::stop_token& stop_;
  std::size_t scheme_ = 0;
  Clock::time_point woken_at_ = Clock::now();
};

void SphereJob::start(Question question) {
  cancel();
  question_ = std::move(question);
  answer_ = {};
  fraction_ = 0.0;
  is_busy_ = true;
  worker_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
}

void SphereJob::cancel() {
  worker_.request_stop();
  wait();
  answers_.clear();
  is_busy_ = false;
}

void SphereJob::wait() {
  if (worker_.joinable()) {
    worker_.join();
  }
}

bool SphereJob::update() {
  std::vector<Answer> answers = answers_.take();
  if (answers.empty()) {
    return false;
  }
  answer_ = std::move(answers.back());
  is_busy_ = false;
  return true;
}

ui::SphereStatus SphereJob::status(const Question& current) const {
  ui::SphereStatus status;
  if (question_ != current) {
    return status;
  }
  if (is_busy_) {
    status.running = fraction_.load();
  } else {
    status.series = answer_.series;
    status.problem = answer_.problem;
  }
  return status;
}

void SphereJob::work(const std::stop_token& stop) {
  JobProgress progress(*this, stop);
  Answer answer;
  try {
    for (std::size_t i = 0; i < question_.schemes.size(); ++i) {
      progress.begin(i);
      auto rows =
          compare_with_sphere(*question_.control, question_.schemes[i], question_.levels, progress);
      if (rows) {
        answer.series.push_back({question_.schemes[i], *std::move(rows)});
      } else if (rows.error().kind != ErrorKind::kCancelled) {
        answer.problem = std::move(rows.error().message);
      }
    }
  } catch (const std::bad_alloc&) {
    answer = {{}, "There is not enough memory to compare so many levels."};
  }
  answers_.put(std::move(answer));
  wake_();
}

}  // namespace limn::app
