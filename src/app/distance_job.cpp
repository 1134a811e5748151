#include "app/distance_job.h"

#include <utility>

#include "limn/document/measured_refinement.h"

namespace limn::app {
namespace {

Result<std::shared_ptr<const LimitDistance>> measure(const DistanceJob::Question& question,
                                                     Progress& progress) {
  const auto keep = [](LimitDistance distance) {
    return std::make_shared<const LimitDistance>(std::move(distance));
  };
  if (question.mesh == nullptr) {
    Document unpainted;
    unpainted.control = question.control;
    unpainted.settings = question.settings;
    DerivedLabels labels;
    labels.legal.labels.resize(question.control->vertex_count(), 0);
    return measure_refinement(unpainted, labels, 0, nullptr, progress)
        .map([&](MeasuredRefinement measured) { return keep(std::move(measured.distance)); });
  }
  return measure_limit_distance(*question.control, labels_up_to(*question.labels, question.levels),
                                question.settings, *question.mesh, progress)
      .map(keep);
}

}  // namespace

void DistanceJob::start(Question question) {
  question_ = std::move(question);
  answer_ = {};
  ++revision_;
  is_answered_ = false;
  job_.start([asked = question_](Progress& progress) { return measure(asked, progress); });
}

void DistanceJob::give_up() {
  cancel();
  answer_ = {nullptr, "The measurement was stopped."};
  is_answered_ = true;
}

bool DistanceJob::update() {
  std::optional<Result<std::shared_ptr<const LimitDistance>>> answer = job_.take();
  if (!answer) {
    return false;
  }
  answer_ = *answer ? Answer{**std::move(answer), {}} : Answer{nullptr, answer->error().message};
  ++revision_;
  is_answered_ = true;
  return true;
}

ui::DistanceStatus DistanceJob::status(const Question& current) const {
  ui::DistanceStatus status;
  if (question_ != current) {
    return status;
  }
  status.running = job_.running();
  if (is_answered_) {
    status.problem = answer_.problem;
    if (const LimitDistance* distance = answer_.distance.get()) {
      status.figures =
          ui::DistanceFigures{distance->to_limit, distance->from_limit,
                              question_.control->bounds().diagonal(), distance->is_settled};
    }
  }
  return status;
}

}  // namespace limn::app
