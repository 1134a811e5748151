#pragma once

#include <cstdint>

namespace limn::ui {

/// Which buttons move the camera (mouse_map.h). Alt and the buttons do so under every preset.
enum class NavigationPreset : std::uint8_t {
  kOriginal,   ///< Of the program Limn grew from, and of Maya: Alt and the buttons, or the middle.
  kMouseOnly,  ///< No key is needed: right, middle, and left beside the mesh.
  kClassroom,  ///< Of a course's mesh viewer: left turns, right shifts, middle zooms.
};

struct NavigationSettings {
  NavigationPreset preset = NavigationPreset::kOriginal;
  /// Turn the view around what is under the cursor when the drag begins; otherwise around the
  /// middle of the view.
  bool orbits_around_cursor = true;

  [[nodiscard]] bool operator==(const NavigationSettings&) const = default;
};

}  // namespace limn::ui
