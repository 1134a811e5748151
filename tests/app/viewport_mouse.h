#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "ui/input.h"

namespace limn::app {

/// A mouse over the viewport, as the controller hears of it: for fixtures that say where a frame of
/// its input goes.
class ViewportMouse {
 protected:
  ViewportMouse() { held_.is_hovered = true; }
  ~ViewportMouse() = default;

  virtual void frame(const ui::ViewportInput& input) = 0;

  /// The places that it passes within one frame.
  void move_along(std::vector<ui::WindowPoint> path) {
    ui::ViewportInput input = held_;
    input.cursor = cursor_ = path.back();
    input.path = std::move(path);
    frame(input);
  }
  void change(ui::MouseButton button, bool is_down) {
    held_.buttons_down[static_cast<std::size_t>(button)] = is_down;
    ui::ViewportInput input = held_;
    input.cursor = cursor_;
    input.button = ui::ButtonChanged{button, is_down};
    input.owns_drag = true;
    held_.owns_drag = held_.buttons_down[0] || held_.buttons_down[1] || held_.buttons_down[2];
    frame(input);
  }

  ui::ViewportInput held_;  ///< What is held from frame to frame: buttons and modifiers.
  ui::WindowPoint cursor_;
};

}  // namespace limn::app
