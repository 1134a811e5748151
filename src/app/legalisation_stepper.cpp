// The trace counts over the whole mesh, so it is asked once for each position.
#include "app/legalisation_stepper.h"

#include <algorithm>

namespace limn::app {

void LegalisationStepper::show(bool is_shown) {
  if (is_shown_ == is_shown) {
    return;
  }
  is_shown_ = is_shown;
  trace_.reset();
  labels_revision_ = 0;
  ++revision_;
}

void LegalisationStepper::update(const Document& document, const DerivedLabels* labels,
                                 std::uint64_t revision) {
  if (!is_shown_ || (trace_ && labels_revision_ == revision)) {
    return;
  }
  const bool has_labels = labels != nullptr &&
                          labels->painted.size() == document.control->vertex_count() &&
                          document.settings.scheme == RefinementScheme::kCatmullClark;
  if (!has_labels) {
    if (trace_) {
      trace_.reset();
      ++revision_;
    }
    return;
  }
  trace_.emplace(document.control, labels->painted, labels->legal, document.settings.non_quads,
                 document.settings.legalisation);
  labels_revision_ = revision;
  look();
}

void LegalisationStepper::seek(std::size_t position) {
  if (trace_ && std::min(position, trace_->size()) != trace_->position()) {
    trace_->seek(position);
    look();
  }
}

void LegalisationStepper::look() {
  moment_ = {trace_->illegal_faces(),
             trace_->illegal_vertices(),
             trace_->raised_vertices(),
             trace_->candidates(),
             {}};
  const std::size_t next = trace_->position();
  if (next < trace_->size() && trace_->is_reset(next)) {
    for (const LegalisationStep& step : trace_->move(next)) {
      moment_.falling.push_back(step.vertex);
    }
  }
  ++revision_;
}

ui::StepperStatus LegalisationStepper::status() const {
  ui::StepperStatus status;
  status.is_shown = is_shown_;
  if (!trace_) {
    return status;
  }
  status.has_trace = true;
  status.order = trace_->order();
  status.position = trace_->position();
  status.size = trace_->size();
  status.illegal_faces = moment_.illegal_faces.size();
  status.illegal_vertices = moment_.illegal_vertices.size();
  status.raised = moment_.raised_vertices.size();
  status.candidates = moment_.candidates;
  status.falling = moment_.falling;
  return status;
}

}  // namespace limn::app
