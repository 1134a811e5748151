// Alt first, which means the same everywhere; then left where it is free; then each preset's own.

#include "ui/mouse_map.h"

namespace limn::ui {
namespace {

using enum CameraGesture;

constexpr Modifiers kAlt{.alt = true};
constexpr Modifiers kWithShift{.shift = true};
constexpr MouseGrip kAltLeft{.left = true, .modifiers = kAlt};
constexpr MouseGrip kAltMiddle{.middle = true, .modifiers = kAlt};
constexpr MouseGrip kAltRight{.right = true, .modifiers = kAlt};
constexpr MouseGrip kAltBoth{.left = true, .right = true, .modifiers = kAlt};
constexpr MouseGrip kMiddle{.middle = true};
constexpr MouseGrip kRight{.right = true};
constexpr MouseGrip kBeside{.left = true, .is_beside_mesh = true};

constexpr std::array<GestureLine, kCameraGestureCount> kOriginalLines{
    {{kOrbit, "Middle drag, or Alt + left drag", {kMiddle, kAltLeft, kRight}, 3},
     {kPan,
      "Shift + middle drag, or Alt + middle drag",
      {MouseGrip{.middle = true, .modifiers = kWithShift}, kAltMiddle, kAltBoth},
      3},
     {kZoom, "Wheel, or Alt + right drag", {kAltRight, {}, {}}, 1}}};

constexpr std::array<GestureLine, kCameraGestureCount> kMouseOnlyLines{
    {{kOrbit, "Right drag, or left drag beside the mesh", {kRight, kBeside, kAltLeft}, 3},
     {kPan,
      "Middle drag, or Shift + right drag",
      {kMiddle, MouseGrip{.right = true, .modifiers = kWithShift}, kAltMiddle},
      3},
     {kZoom,
      "Wheel, or Ctrl + right drag",
      {MouseGrip{.right = true, .modifiers = {.ctrl = true}}, kAltRight, {}},
      2}}};

constexpr std::array<GestureLine, kCameraGestureCount> kClassroomLines{
    {{kOrbit,
      "Left drag with the orbit tool, or beside the mesh",
      {MouseGrip{.left = true, .is_left_free = true}, kBeside, kAltLeft},
      3},
     {kPan, "Right drag, or Alt + middle drag", {kRight, kAltMiddle, kAltBoth}, 3},
     {kZoom, "Wheel, middle drag, or Page Up and Page Down", {kMiddle, kAltRight, {}}, 2}}};

}  // namespace

std::optional<CameraGesture> camera_gesture(NavigationPreset preset,
                                            const MouseGrip& grip) noexcept {
  const Modifiers& held = grip.modifiers;
  if (held.alt) {
    return grip.middle || (grip.left && grip.right) ? kPan : grip.left ? kOrbit : kZoom;
  }
  if (grip.left) {
    const bool is_beside =
        grip.is_beside_mesh && asks_for_background(preset) && !held.shift && !held.ctrl;
    if (!grip.is_left_free && !is_beside) {
      return std::nullopt;
    }
    return held.shift ? kPan : kOrbit;
  }
  switch (preset) {
    case NavigationPreset::kOriginal:
      return held.shift ? kPan : kOrbit;
    case NavigationPreset::kMouseOnly:
      if (grip.middle) {
        return held.shift ? kOrbit : kPan;
      }
      return held.shift ? kPan : held.ctrl ? kZoom : kOrbit;
    case NavigationPreset::kClassroom:
      return grip.middle ? kZoom : kPan;
  }
  return std::nullopt;
}

bool asks_for_background(NavigationPreset preset) noexcept {
  return preset != NavigationPreset::kOriginal;
}

std::span<const GestureLine, kCameraGestureCount> gesture_lines(NavigationPreset preset) noexcept {
  switch (preset) {
    case NavigationPreset::kMouseOnly:
      return kMouseOnlyLines;
    case NavigationPreset::kClassroom:
      return kClassroomLines;
    case NavigationPreset::kOriginal:
      break;
  }
  return kOriginalLines;
}

std::string_view navigation_hint(NavigationPreset preset, bool is_left_free,
                                 bool takes_background) noexcept {
  if (takes_background && preset != NavigationPreset::kOriginal) {
    return preset == NavigationPreset::kMouseOnly
               ? "Right drag: orbit · Middle drag: pan · Wheel: zoom"
               : "Alt + left drag: orbit · Right drag: pan · Middle or wheel: zoom";
  }
  switch (preset) {
    case NavigationPreset::kMouseOnly:
      return is_left_free ? "Left or right drag: orbit · Middle drag: pan · Wheel: zoom"
                          : "Right drag, or beside the mesh: orbit · Middle: pan · Wheel: zoom";
    case NavigationPreset::kClassroom:
      return is_left_free ? "Left drag: orbit · Right drag: pan · Middle drag or wheel: zoom"
                          : "Beside the mesh: orbit · Right drag: pan · Middle or wheel: zoom";
    case NavigationPreset::kOriginal:
      break;
  }
  return is_left_free ? "Left or middle drag: orbit · Shift + middle drag: pan · Wheel: zoom"
                      : "Alt or middle drag: orbit · Wheel: zoom";
}

}  // namespace limn::ui
