#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "render/camera.h"
#include "render/coordinates.h"
#include "render/picking/brush_capsule.h"
#include "render/picking/face_picker.h"
#include "ui/input.h"

namespace limn::app {

class Session;

/// Answers which faces show where in the viewport, for the camera in force.
class ViewportPicker {
 public:
  virtual ~ViewportPicker() = default;
  [[nodiscard]] virtual std::optional<render::PickedFace> pick(render::FramebufferPoint point) = 0;
  /// Control faces that show under the brush.
  [[nodiscard]] virtual std::vector<std::uint32_t> brush(const render::BrushCapsule& capsule) = 0;
};

/// Where the viewport lies: its rectangle in the window, and its size in pixels. Where it is split,
/// both are of the first half, and the second is as large.
struct ViewportPlace {
  ui::WindowRect rect;
  render::FramebufferSize size;
  std::optional<ui::WindowPoint> second{};  ///< Upper left corner of the second half.

  /// The pixel of the viewport under a window position; may lie outside.
  [[nodiscard]] render::FramebufferPoint to_pixel(ui::WindowPoint point) const noexcept;
  /// Pixels per window unit.
  [[nodiscard]] double density() const noexcept;
};

/// Turns the mouse in the viewport into strokes and camera moves.
///
/// What a drag does is settled when its first button goes down and stays so until the last is up:
/// left uses the tool (Shift or Ctrl lowers), middle or right orbits, with Shift they pan; with
/// Alt, left orbits, middle or left and right together pan, right dollies. The wheel dollies
/// towards what is under the cursor; with Ctrl it sizes the brush. The tools for edges take the
/// edge nearest to the cursor when the button goes down.
///
/// In the second half of a split viewport there is nothing to paint or to pick: every left drag
/// moves the camera there, which is that of both halves.
class ViewportController {
 public:
  /// Plays one frame's input into the session. `picker` sees the session's view as it was before.
  void update(const ui::ViewportInput& input, const ViewportPlace& place, Session& session,
              ViewportPicker& picker);

  /// The brush under the cursor, in pixels of the viewport; nothing where none is at work.
  struct Ring {
    render::FramebufferPoint centre;
    double radius = 0.0;

    [[nodiscard]] bool operator==(const Ring&) const = default;
  };
  [[nodiscard]] std::optional<Ring> ring() const noexcept { return ring_; }
  /// Control faces under the brush.
  [[nodiscard]] std::span<const std::uint32_t> highlighted() const noexcept { return highlighted_; }

 private:
  enum class Drag : std::uint8_t { kNone, kStroke, kPick, kEdge, kOrbit, kPan, kDolly, kIdle };
  struct Context;

  [[nodiscard]] Drag drag_for(const ui::ViewportInput& input, const Session& session) const;
  /// Takes note of the half that the cursor is in.
  void enter(const Context& context, ui::WindowPoint at);
  /// The pixel of the half that the cursor is in.
  [[nodiscard]] render::FramebufferPoint to_pixel(const Context& context, ui::WindowPoint at) const;
  void press(const Context& context);
  void release(const Context& context);
  void move(const Context& context, render::FramebufferPoint to);
  /// What shows at a place of the half that the cursor is in; nothing in the second.
  [[nodiscard]] std::optional<render::PickedFace> pick(const Context& context,
                                                       render::FramebufferPoint at) const;
  void pick_depth(const Context& context, render::FramebufferPoint at);
  void take_edge(const Context& context);
  void turn_wheel(const Context& context);
  void hover(const Context& context);
  /// The edge to take at a place that shows this control face.
  [[nodiscard]] static std::optional<std::uint32_t> edge_at(const Context& context,
                                                            std::uint32_t face,
                                                            render::FramebufferPoint at);

  Drag drag_ = Drag::kNone;
  render::FramebufferPoint last_;  ///< Where the cursor was last, in the half it was in.
  bool is_in_second_ = false;      ///< A drag stays in the half it began in.
  double grabbed_depth_ = 1.0;     ///< View depth of what a pan holds.
  std::optional<Ring> ring_;
  std::vector<std::uint32_t> highlighted_;
};

}  // namespace limn::app
