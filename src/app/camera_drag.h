#pragma once

#include <cstdint>

#include "render/coordinates.h"

namespace limn::ui {
struct ViewportInput;
}

namespace limn::app {

struct ViewportFrame;

/// Moves the camera while a button is held, and with the wheel.
class CameraDrag {
 public:
  enum class Kind : std::uint8_t { kOrbit, kPan, kDolly };

  /// What a drag of the camera does that begins with these buttons and modifiers: with Alt, left
  /// orbits, middle or left and right together pan, right dollies; without, every button orbits,
  /// and with Shift pans.
  [[nodiscard]] static Kind kind_of(const ui::ViewportInput& input) noexcept;

  void begin(Kind kind, const ViewportFrame& frame, render::FramebufferPoint at);
  void move(const ViewportFrame& frame, render::FramebufferPoint from,
            render::FramebufferPoint to) const;
  /// Whether a second button pressed with Alt makes it another drag.
  [[nodiscard]] bool takes_second_button() const noexcept { return kind_ != Kind::kPan; }

  /// Dollies towards what is under the cursor.
  static void turn_wheel(const ViewportFrame& frame, render::FramebufferPoint at, double notches);

 private:
  Kind kind_ = Kind::kOrbit;
  double grabbed_depth_ = 1.0;  ///< View depth of what a pan holds.
};

}  // namespace limn::app
