#pragma once

#include <optional>

#include "limn/document/view_state.h"

namespace limn::app {

/// The view in force and, while it glides, where it is going.
class CameraMotion {
 public:
  [[nodiscard]] const ViewState& view() const noexcept { return view_; }
  /// Where the view will come to rest.
  [[nodiscard]] const ViewState& goal() const noexcept { return glide_ ? glide_->to : view_; }
  [[nodiscard]] bool is_gliding() const noexcept { return glide_.has_value(); }

  /// At once, ending any glide: the mouse moves the camera.
  void set(const ViewState& view);
  /// Within 150 ms from `now` (seconds).
  void glide_to(const ViewState& view, double now);
  /// Moves on to `now`; returns true where the view changed.
  bool update(double now);

 private:
  struct Glide {
    ViewState from;
    ViewState to;
    double start = 0.0;
  };

  ViewState view_;
  std::optional<Glide> glide_;
};

}  // namespace limn::app
