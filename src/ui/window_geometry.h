#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

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

/// The viewport, or its two halves of one size where it is split.
struct ViewportHalves {
  WindowRect first;
  std::optional<WindowRect> second;
};
[[nodiscard]] inline ViewportHalves viewport_halves(const WindowRect& viewport, bool is_split) {
  if (!is_split) {
    return {viewport, std::nullopt};
  }
  const double width = std::max(1.0, std::floor(viewport.size.width / 2.0));
  const WindowSize half{width, viewport.size.height};
  const double right = viewport.origin.x + viewport.size.width - width;
  return {{viewport.origin, half}, WindowRect{{right, viewport.origin.y}, half}};
}

}  // namespace limn::ui
