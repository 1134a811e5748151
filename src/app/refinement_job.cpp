// One worker, one mutex. A request is taken out of `waiting_` under a ticket; every report of
// progress and every result compares its ticket with the current one, so a submit or cancel makes
// all older work stop at its next report and keeps its late results out.
#include "app/refinement_job.h"

#include <new>
#include <utility>

#include "limn/painting/fine_paint.h"
#include "limn/progress.h"
#include "limn/subdivision/labels.h"
#include "limn/subdivision/prediction.h"
#include "render/surface/face_order.h"
#include "render/surface/surface.h"

namespace limn::app {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kReportInterval = std::chrono::milliseconds(40);

/// What a uniform scheme will give. There is nothing to compare it with.
RefinementPrediction predict_uniform(const ControlMesh& control, const SchemeSettings& settings,
                                     int levels) {
  const SchemeCounts counts = predict_scheme(control, settings, levels).back();
  RefinementPrediction prediction;
  prediction.faces = counts.faces;
  prediction.vertices = counts.vertices;
  prediction.edges = counts.edges;
  prediction.bytes = scheme_bytes(counts);
  prediction.levels = levels;
  return prediction;
}

}  // namespace

/// Passes progress on to the owner, a few times a second at most, and says when work went stale.
class RefinementJob::JobProgress final : public Progress {
 public:
  JobProgress(RefinementJob& job, const std::stop_token& stop, std::uint64_t ticket)
      : job_(job), stop_(stop), ticket_(ticket) {}

  [[nodiscard]] bool report(double fraction, std::string_view stage) override {
    if (stop_.stop_requested()) {
      return false;
    }
    const auto now = Clock::now();
    bool is_shown = false;
    {
      const std::lock_guard lock(job_.mutex_);
      if (job_.ticket_ != ticket_) {
        return false;
      }
      if (now - shown_at_ >= kReportInterval) {
        shown_at_ = now;
        is_shown = true;
        job_.status_.fraction = fraction;
        job_.status_.stage = stage;
      }
    }
    if (is_shown) {
      job_.wake_();
    }
    return true;
  }

 private:
  RefinementJob& job_;
  const std::stop_token& stop_;
  std::uint64_t ticket_;
  Clock::time_point shown_at_ = Clock::now();
};

RefinementJob::RefinementJob(std::function<void()> wake, std::string name, Arrivals* arrivals)
    : wake_(std::move(wake)),
      news_(std::move(name), arrivals),
      worker_([this](const std::stop_token& stop) { work(stop); }) {}

RefinementJob::~RefinementJob() {
  cancel();
  worker_.request_stop();
  worker_.join();
}

void RefinementJob::submit(JobRequest request) {
  {
    const std::lock_guard lock(mutex_);
    ++ticket_;
    news_.clear();
    waiting_ = std::move(request);
  }
  changed_.notify_all();
}

void RefinementJob::cancel() {
  {
    const std::lock_guard lock(mutex_);
    ++ticket_;
    news_.clear();
    waiting_.reset();
  }
  changed_.notify_all();
}

JobStatus RefinementJob::status() const {
  const std::lock_guard lock(mutex_);
  JobStatus status = status_;
  status.is_busy = status_.is_busy || waiting_.has_value();
  if (status_.is_busy) {
    status.running_for = Clock::now() - started_;
  }
  return status;
}

void RefinementJob::wait_until_idle() const {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !waiting_ && !status_.is_busy; });
}

std::shared_ptr<const JobResult> RefinementJob::take_result() {
  std::shared_ptr<const JobResult> newest;
  for (News& piece : news_.take()) {
    if (auto* error = std::get_if<Error>(&piece)) {
      error_ = std::move(*error);
    } else {
      newest = std::get<std::shared_ptr<const JobResult>>(std::move(piece));
    }
  }
  return newest;
}

std::optional<Error> RefinementJob::take_error() {
  return std::exchange(error_, std::nullopt);
}

void RefinementJob::work(const std::stop_token& stop) {
  while (true) {
    JobRequest request;
    std::uint64_t ticket = 0;
    {
      std::unique_lock lock(mutex_);
      if (!changed_.wait(lock, stop, [this] { return waiting_.has_value(); })) {
        return;
      }
      request = std::move(*waiting_);
      waiting_.reset();
      ticket = ticket_;
      started_ = Clock::now();
      status_ = JobStatus{true, request.serial, 0.0, "Labels", {}};
    }
    try {
      carry_out(request, stop, ticket);
    } catch (const std::bad_alloc&) {
      publish(ticket, Error{ErrorKind::kFailed,
                            "There is not enough memory for this refinement. Paint less deep, or "
                            "stop after fewer levels.",
                            {},
                            0});
    }
    {
      const std::lock_guard lock(mutex_);
      status_ = JobStatus{};
    }
    changed_.notify_all();
    wake_();
  }
}

void RefinementJob::publish(std::uint64_t ticket, News news) {
  {
    const std::lock_guard lock(mutex_);
    if (ticket != ticket_) {
      return;
    }
    news_.put(std::move(news));
  }
  wake_();
}

void RefinementJob::carry_out(const JobRequest& request, const std::stop_token& stop,
                              std::uint64_t ticket) {
  JobProgress progress(*this, stop, ticket);
  const ControlMesh& control = *request.control;
  const auto publish_error = [&](Error error) {
    if (error.kind != ErrorKind::kCancelled) {
      publish(ticket, std::move(error));
    }
  };

  SubdivisionSettings settings = request.settings;
  if (request.scheme) {
    settings.scheme = RefinementScheme::kCatmullClark;  // Labels are shown, and take any mesh.
  }
  auto labels =
      derive_labels(control, request.depths.values(), settings, progress, request.demands);
  if (!labels) {
    publish_error(std::move(labels.error()));
    return;
  }
  JobResult result;
  result.serial = request.serial;
  result.control = request.control;
  result.scheme = request.scheme;
  result.labels = std::make_shared<const DerivedLabels>(std::move(*labels));
  const VertexLabels& legal = result.labels->legal.labels;
  result.illegal_left = illegal_faces(control, legal, request.settings.legalisation).size();
  result.prediction = request.scheme && request.levels > 0
                          ? predict_uniform(control, *request.scheme, request.levels)
                          : predict_derived(control, *result.labels, request.levels);
  if (request.levels > 0 && result.prediction.bytes > request.memory_budget) {
    result.memory_budget = request.memory_budget;
  }
  result.is_over_budget = request.levels > 0 && (result.memory_budget > 0 ||
                                                 result.prediction.faces > request.face_budget);
  result.is_final = request.levels == 0 || result.is_over_budget;
  publish(ticket, std::make_shared<const JobResult>(result));
  if (result.is_final) {
    return;
  }

  if (auto refined = refine(request, result, progress); !refined) {
    publish_error(std::move(refined.error()));
    return;
  }
  if (!progress.report(1.0, "Preparing the picture")) {
    return;
  }
  render::Surface surface =
      render::make_surface(*result.mesh, control.bounds().centre(), control.face_count());
  if (result.labels->fine != nullptr && result.refinement != nullptr) {
    const Painting painting{control, request.depths, request.demands, request.settings.non_quads};
    const RefinedFrom from{&control, &legal, result.labels->fine.get(), result.prediction.levels};
    surface.face_demands = render::in_drawn_order(surface, *result.mesh,
                                                  demanded_depths(painting, from, *result.mesh));
  }
  result.surface = std::make_shared<const render::Surface>(std::move(surface));
  result.is_final = true;
  publish(ticket, std::make_shared<const JobResult>(result));
}

Result<void> RefinementJob::refine(const JobRequest& request, JobResult& result,
                                   Progress& progress) {
  const ControlMesh& control = *request.control;
  if (request.scheme) {
    return derive_scheme(control, *request.scheme, {request.levels, request.face_budget}, progress)
        .map([&](SchemeRefinement made) {
          result.mesh = std::move(made.mesh);
          result.steps = std::move(made.steps);
        });
  }
  return source_
      .derive(control, *result.labels, {request.settings, request.levels, request.face_budget},
              progress)
      .map([&](Refinement made) {
        result.refinement = std::make_shared<const Refinement>(std::move(made));
        result.mesh = result.refinement->mesh;
      });
}

}  // namespace limn::app
