#pragma once

namespace limn::ui {

/// A place in window coordinates: the units the window system reports the cursor in, origin upper
/// left, y downwards. Not pixels: on a display with a framebuffer scale of 2 a unit has 2x2 pixels.
struct WindowPoint {
  double x = 0.0;
  double y = 0.0;

  [[nodiscard]] bool operator==(const WindowPoint&) const = default;
};

/// Width and height in window coordinates.
struct WindowSize {
  double width = 0.0;
  double height = 0.0;

  [[nodiscard]] bool operator==(const WindowSize&) const = default;
};

/// An upright rectangle in window coordinates; holds its left and upper edge, not the others.
struct WindowRect {
  WindowPoint origin;
  WindowSize size;

  [[nodiscard]] bool contains(WindowPoint p) const noexcept {
    return p.x >= origin.x && p.y >= origin.y && p.x < origin.x + size.width &&
           p.y < origin.y + size.height;
  }
  [[nodiscard]] bool operator==(const WindowRect&) const = default;
};

}  // namespace limn::ui
