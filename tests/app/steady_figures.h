#pragma once

#include <vector>

#include "ui/model.h"

namespace limn::app {

/// For pictures: nothing in them may depend on how fast the machine is. Must outlive the frame.
class SteadyFigures {
 public:
  void operator()(ui::Model& model) {
    model.frame_seconds = 0.016;
    model.stroke_seconds = 0.033;
    if (model.refinement.result) {
      model.refinement.result->legalise_seconds = 0.0012;
      model.refinement.result->refine_seconds = 0.0031;
    }
    model.refinement.running.reset();
    steps_.assign(model.scheme.steps.begin(), model.scheme.steps.end());
    for (SchemeStep& step : steps_) {
      step.seconds = 1e-7 * static_cast<double>(step.counts.faces);
    }
    model.scheme.steps = steps_;
  }

 private:
  std::vector<SchemeStep> steps_;
};

}  // namespace limn::app
