#pragma once

#include "limn/progress.h"

namespace limn {

/// Shows an algorithm's 0..1 as a part, `from`..`to`, of a longer run.
class PartOfProgress final : public Progress {
 public:
  PartOfProgress(Progress& whole, double from, double to) : whole_(&whole), from_(from), to_(to) {}
  [[nodiscard]] bool report(double fraction, std::string_view stage) override {
    return whole_->report(from_ + (to_ - from_) * fraction, stage);
  }

 private:
  Progress* whole_;
  double from_;
  double to_;
};

}  // namespace limn
