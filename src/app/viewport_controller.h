#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "app/camera_drag.h"
#include "app/paint_tools/paint_tools.h"
#include "app/viewport_frame.h"

namespace limn::app {

class Session;

/// Turns the mouse in the viewport into strokes and camera moves, by handing each drag to whom it
/// belongs: the camera, the tools that paint, or those for edges.
///
/// What a drag does is settled when its first button goes down and stays so until the last is up:
/// left uses the tool (Shift or Ctrl lowers), the other buttons move the camera, and with Alt every
/// one does (ui/mouse_map.h). The wheel dollies towards what is under the cursor; with Ctrl it
/// sizes the brush.
///
/// In the second half of a split viewport there is nothing to paint or to pick: every left drag
/// moves the camera there, which is that of both halves.
class ViewportController {
 public:
  /// Plays one frame's input into the session. `picker` sees the session's view as it was before.
  void update(const ui::ViewportInput& input, const ViewportPlace& place, Session& session,
              ViewportPicker& picker);

  /// The brush under the cursor; nothing where none is at work.
  [[nodiscard]] const std::optional<BrushRing>& ring() const noexcept { return tools_.ring(); }
  /// What a rectangle, lasso or straight stroke would go along; empty where there is none.
  [[nodiscard]] const Outline& outline() const noexcept { return tools_.outline(); }
  /// Control faces that a click would reach.
  [[nodiscard]] std::span<const std::uint32_t> highlighted() const noexcept {
    return tools_.highlighted();
  }
  /// Faces of the mesh shown that it would instead, where one paints on such; null otherwise.
  [[nodiscard]] const ShownFaces* lit() const noexcept { return tools_.lit(); }

 private:
  enum class Drag : std::uint8_t { kNone, kCamera, kPaint, kEdge, kIdle };

  /// Takes note of the half that the cursor is in.
  void enter(ViewportFrame& frame, ui::WindowPoint at);
  void press(const ViewportFrame& frame);
  void release(const ViewportFrame& frame);
  void move(const ViewportFrame& frame, render::FramebufferPoint to);
  void turn_wheel(const ViewportFrame& frame);
  void hover(const ViewportFrame& frame);

  CameraDrag camera_;
  PaintTools tools_;
  Drag drag_ = Drag::kNone;
  render::FramebufferPoint last_;  ///< Where the cursor was last, in the half it was in.
  bool is_in_second_ = false;      ///< A drag stays in the half it began in.
};

}  // namespace limn::app
