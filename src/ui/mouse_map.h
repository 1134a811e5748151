#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "ui/input.h"
#include "ui/navigation_settings.h"

namespace limn::ui {

/// What a drag does to the camera.
enum class CameraGesture : std::uint8_t { kOrbit, kPan, kZoom };
inline constexpr std::size_t kCameraGestureCount = 3;

/// How the mouse is held when a button goes down in the viewport.
struct MouseGrip {
  bool left = false;
  bool right = false;
  bool middle = false;
  Modifiers modifiers{};
  bool is_beside_mesh = false;  ///< Nothing of the mesh shows under the cursor.
  /// Left has nothing else to do: the orbit tool is taken up, or there is nothing to paint here.
  bool is_left_free = false;
};

/// What the drag does to the camera; nothing: it is the tool's.
[[nodiscard]] std::optional<CameraGesture> camera_gesture(NavigationPreset preset,
                                                          const MouseGrip& grip) noexcept;

/// Whether `camera_gesture` needs to know `is_beside_mesh`.
[[nodiscard]] bool asks_for_background(NavigationPreset preset) noexcept;

/// A line of the help sheet: "Orbit", and "Middle drag, or Alt + left drag".
struct GestureLine {
  CameraGesture gesture;
  std::string_view how;
  std::array<MouseGrip, 3> grips;  ///< The first `grip_count` are what `how` says.
  std::size_t grip_count;
};
/// One line a gesture.
[[nodiscard]] std::span<const GestureLine, kCameraGestureCount> gesture_lines(
    NavigationPreset preset) noexcept;

/// The short form for the status line, behind what the tool does, or alone where left is free:
/// "Alt or middle drag: orbit · Wheel: zoom". `takes_background`: left is the tool's beside the
/// mesh as well.
[[nodiscard]] std::string_view navigation_hint(NavigationPreset preset, bool is_left_free,
                                               bool takes_background = false) noexcept;

}  // namespace limn::ui
