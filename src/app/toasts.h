#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "ui/model.h"

namespace limn::app {

/// Short messages in the upper middle of the window, each for as long as it takes to read.
class Toasts {
 public:
  /// `now` in seconds. The newest few are kept; one that says the same again replaces the old.
  void add(ui::Toast::Kind kind, std::string text, double now);
  /// Drops those whose time is over; returns true where there were any.
  bool expire(double now);
  /// When the next one ends; infinity where there is none.
  [[nodiscard]] double next_end() const noexcept;
  [[nodiscard]] std::span<const ui::Toast> shown() const noexcept { return shown_; }

 private:
  std::vector<ui::Toast> shown_;
  std::vector<double> ends_;  ///< One per toast.
};

}  // namespace limn::app
