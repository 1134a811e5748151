#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "render/coordinates.h"

namespace limn::app {

struct ViewportFrame;
class Session;

/// The brush under the cursor, in pixels of the viewport.
struct BrushRing {
  render::FramebufferPoint centre;
  double radius = 0.0;

  [[nodiscard]] bool operator==(const BrushRing&) const = default;
};

/// What the left button does with the tools that paint: strokes of the brush, and taking up a
/// depth. A stroke covers the whole way between two places of the cursor, so it leaves no gaps.
class PaintTools {
 public:
  void press(const ViewportFrame& frame, render::FramebufferPoint at);
  void move(const ViewportFrame& frame, render::FramebufferPoint from, render::FramebufferPoint to);
  void release(Session& session);
  /// Whether what was begun has been given up by Esc.
  [[nodiscard]] bool is_given_up(const Session& session) const;

  /// Shows what a click here would reach.
  void hover(const ViewportFrame& frame, render::FramebufferPoint at);
  void leave();

  [[nodiscard]] const std::optional<BrushRing>& ring() const noexcept { return ring_; }
  [[nodiscard]] std::span<const std::uint32_t> highlighted() const noexcept { return highlighted_; }

 private:
  bool is_stroke_ = false;
  std::optional<BrushRing> ring_;
  std::vector<std::uint32_t> highlighted_;
};

}  // namespace limn::app
