// One thread a question. What it has found is handed over at its end, all at once.
#include "app/distance_job.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <utility>

#include "limn/progress.h"

namespace limn::app {

class DistanceJob::JobProgress final : public Progress {
 public:
  JobProgress(DistanceJob& job, const std::stop_token& stop) : job_(job), stop_(stop) {}

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
  DistanceJob& job_;
  const std::stop_token& stop_;
  std::chrono::steady_clock::time_point woken_at_ = std::chrono::steady_clock::now();
};

void DistanceJob::start(Question question) {
  cancel();
  question_ = std::move(question);
  answer_ = {};
  ++revision_;
  fraction_ = 0.0;
  is_answered_ = false;
  is_busy_ = true;
  worker_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
}

void DistanceJob::cancel() {
  worker_.request_stop();
  wait();
  answers_.clear();
  is_busy_ = false;
}

void DistanceJob::give_up() {
  cancel();
  answer_ = {nullptr, "The measurement was stopped."};
  is_answered_ = true;
}

void DistanceJob::wait() {
  if (worker_.joinable()) {
    worker_.join();
  }
}

bool DistanceJob::update() {
  std::vector<Answer> answers = answers_.take();
  if (answers.empty()) {
    return false;
  }
  answer_ = std::move(answers.back());
  ++revision_;
  is_busy_ = false;
  is_answered_ = true;
  return true;
}

ui::DistanceStatus DistanceJob::status(const Question& current) const {
  ui::DistanceStatus status;
  if (question_ != current) {
    return status;
  }
  if (is_busy_) {
    status.running = fraction_.load();
  } else if (is_answered_) {
    status.problem = answer_.problem;
    if (const LimitDistance* distance = answer_.distance.get()) {
      status.figures =
          ui::DistanceFigures{distance->to_limit, distance->from_limit,
                              question_.control->bounds().diagonal(), distance->is_settled};
    }
  }
  return status;
}

void DistanceJob::work(const std::stop_token& stop) {
  JobProgress progress(*this, stop);
  Answer answer;
  try {
    VertexLabels labels = question_.labels->legal.labels;
    for (std::uint8_t& label : labels) {
      label = static_cast<std::uint8_t>(std::min<int>(label, question_.levels));
    }
    Result<LimitDistance> measured = measure_limit_distance(
        *question_.control, labels, question_.settings, *question_.mesh, progress);
    if (measured) {
      answer.distance = std::make_shared<const LimitDistance>(*std::move(measured));
    } else if (measured.error().kind != ErrorKind::kCancelled) {
      answer.problem = std::move(measured.error().message);
    }
  } catch (const std::bad_alloc&) {
    answer = {nullptr, "There is not enough memory to measure this mesh."};
  }
  answers_.put(std::move(answer));
  wake_();
}

}  // namespace limn::app
