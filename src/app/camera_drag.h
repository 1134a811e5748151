#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "render/coordinates.h"
#include "ui/mouse_map.h"

namespace limn::app {

struct ViewportFrame;

/// Moves the camera while a button is held, and with the wheel. Which button does what is said in
/// ui/mouse_map.h.
class CameraDrag {
 public:
  /// What a press at this place does to the camera; nothing: it is the tool's.
  [[nodiscard]] static std::optional<ui::CameraGesture> gesture_at(const ViewportFrame& frame,
                                                                   render::FramebufferPoint at);

  void begin(ui::CameraGesture gesture, const ViewportFrame& frame, render::FramebufferPoint at);
  void move(const ViewportFrame& frame, render::FramebufferPoint from,
            render::FramebufferPoint to) const;
  /// Whether a second button pressed with Alt makes it another drag.
  [[nodiscard]] bool takes_second_button() const noexcept {
    return gesture_ != ui::CameraGesture::kPan;
  }

  /// Dollies towards what is under the cursor.
  static void turn_wheel(const ViewportFrame& frame, render::FramebufferPoint at, double notches);

 private:
  ui::CameraGesture gesture_ = ui::CameraGesture::kOrbit;
  double grabbed_depth_ = 1.0;       ///< View depth of what a pan holds.
  std::optional<glm::dvec3> pivot_;  ///< What an orbit goes round; nothing: the view's target.
};

}  // namespace limn::app
