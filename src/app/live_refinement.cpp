// A document's revisions tell whether it changed; a serial number per submission tells whether a
// result belongs to the newest one.
#include "app/live_refinement.h"

#include <algorithm>
#include <utility>

#include "limn/document/memory_budget.h"

namespace limn::app {
namespace {

/// Anything shorter needs no progress bar.
constexpr auto kShownAfter = std::chrono::milliseconds(200);

bool same(const Revisions& a, const Revisions& b) {
  return a.control == b.control && a.depths == b.depths && a.stage == b.stage;
}

ui::RefinementResult result_of(const JobResult& job) {
  ui::RefinementResult result;
  result.faces = job.mesh->face_count();
  result.vertices = job.mesh->vertex_count();
  result.bytes = job.mesh->bytes();
  result.uniform_faces = job.prediction.uniform_faces;
  result.levels = job.prediction.levels;
  result.legalise_seconds = job.labels->seconds;
  if (job.refinement != nullptr) {
    result.refine_seconds = job.refinement->refine_seconds;
    result.cracks = &job.refinement->cracks;
  }
  for (const SchemeStep& step : job.steps) {
    result.refine_seconds += step.seconds;
  }
  return result;
}

}  // namespace

void LiveRefinement::follow(const Document& document, const Wish& wish) {
  const std::optional<SchemeSettings> scheme =
      wish.other ? wish.other->scheme : shown_scheme(document);
  int levels = wish.other ? wish.other->levels : document.stage.levels;
  if (levels == 0 && wish.needs_refined && !scheme) {
    levels = kAllLevels;
  }
  if (control_ == document.control && submitted_scheme_ == scheme && submitted_levels_ == levels &&
      same(submitted_, document.revisions)) {
    return;
  }
  if (wish.is_stroking && is_waiting_) {
    return;
  }
  // Other creases give another refinement of the same surface: the last one stays until it is
  // there.
  const bool is_same_surface =
      control_ != nullptr && &control_->topology() == &document.control->topology();
  if (!is_same_surface) {
    newest_.reset();
    set_refined(nullptr);
    ++labels_revision_;
    raised_budget_ = 0;
    is_silenced_ = false;
  }
  control_ = document.control;
  submitted_ = document.revisions;
  submitted_scheme_ = scheme;
  submitted_levels_ = levels;
  is_waiting_ = true;
  job_.submit({++serial_, document.control, document.depths, document.demands, document.settings,
               scheme, levels, std::max(budget_, raised_budget_),
               memory_budget_ ? *memory_budget_ : memory_budget()});
}

bool LiveRefinement::update() {
  const auto result = job_.take_result();
  if (auto error = job_.take_error()) {
    error_ = std::move(error);
    is_waiting_ = false;
  }
  if (!result || result->control != control_) {
    return false;
  }
  if (result->is_final) {
    is_waiting_ = false;
  }
  if (!newest_ || newest_->labels != result->labels) {
    ++labels_revision_;
  }
  newest_ = result;
  if (!result->is_over_budget) {
    is_silenced_ = false;
  }
  if (result->mesh) {
    set_refined(result);
    if (result->serial == serial_) {
      refined_depths_ = submitted_.depths;
    }
  } else if (result->is_final && !result->is_over_budget) {
    set_refined(nullptr);
  }
  return true;
}

void LiveRefinement::set_refined(std::shared_ptr<const JobResult> result) {
  if (refined_ != result) {
    refined_ = std::move(result);
    ++refined_revision_;
    refined_depths_ = 0;
  }
}

void LiveRefinement::cancel() {
  is_waiting_ = false;
  job_.cancel();
}

void LiveRefinement::restart() {
  submitted_levels_ = -1;
  is_silenced_ = false;
}

bool LiveRefinement::is_up_to_date() const noexcept {
  return newest_ && newest_->serial == serial_ && newest_->is_final && !newest_->is_over_budget &&
         submitted_levels_ >= 0;
}

const DerivedLabels* LiveRefinement::labels() const noexcept {
  return newest_ ? newest_->labels.get() : nullptr;
}

std::optional<ui::OverBudgetQuestion> LiveRefinement::question() const {
  if (!newest_ || newest_->serial != serial_ || !newest_->is_over_budget || is_silenced_) {
    return std::nullopt;
  }
  return ui::OverBudgetQuestion{newest_->prediction.faces, newest_->prediction.bytes,
                                std::max(budget_, raised_budget_), newest_->memory_budget};
}

void LiveRefinement::accept() {
  if (newest_) {
    raised_budget_ = 2 * newest_->prediction.faces;
    submitted_levels_ = -1;
  }
}

void LiveRefinement::decline() {
  is_silenced_ = true;
}

ui::RefinementStatus LiveRefinement::status() const {
  ui::RefinementStatus status;
  const JobStatus job = job_.status();
  if (job.is_busy && job.running_for >= kShownAfter) {
    status.running = ui::RunningRefinement{job.fraction, job.stage};
  }
  if (newest_) {
    const DerivedLabels& labels = *newest_->labels;
    status.prediction = &labels.prediction;
    status.legality = ui::LegalityStatus{
        labels.illegal_faces.size(), labels.illegal_vertices.size(), labels.raised_vertices.size(),
        labels.deepened_faces, newest_->illegal_left};
  }
  if (refined_) {
    status.result = result_of(*refined_);
  }
  return status;
}

}  // namespace limn::app
