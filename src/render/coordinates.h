#pragma once

#include <cstddef>

namespace limn::render {

/// A place in the image that is drawn: from the upper left corner, x to the right, y down, in
/// pixels. Pixel (i, j) covers [i, i + 1) x [j, j + 1) and has its centre at (i + 0.5, j + 0.5).
struct FramebufferPoint {
  double x = 0.0;
  double y = 0.0;
  [[nodiscard]] bool operator==(const FramebufferPoint&) const = default;
};

/// Size in pixels; 0 while the window is minimised.
struct FramebufferSize {
  int width = 0;
  int height = 0;

  [[nodiscard]] bool is_empty() const noexcept { return width <= 0 || height <= 0; }
  /// Width over height; 1 where the size is empty.
  [[nodiscard]] double aspect() const noexcept {
    return is_empty() ? 1.0 : static_cast<double>(width) / static_cast<double>(height);
  }
  [[nodiscard]] bool operator==(const FramebufferSize&) const = default;
};

/// Whole pixels: columns x .. x + width - 1, rows y .. y + height - 1 from the top.
struct PixelRect {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  [[nodiscard]] bool is_empty() const noexcept { return width <= 0 || height <= 0; }
  [[nodiscard]] std::size_t area() const noexcept {
    return is_empty() ? 0 : static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  [[nodiscard]] bool operator==(const PixelRect&) const = default;
};

}  // namespace limn::render
