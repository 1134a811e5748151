#pragma once

#include <optional>

#include "ui/input.h"

namespace limn::app {

/// Our name for a GLFW key; nothing for keys that Limn has no use for.
[[nodiscard]] std::optional<ui::Key> key_from_glfw(int glfw_key);

/// Our name for a GLFW mouse button; nothing for the fourth and later.
[[nodiscard]] std::optional<ui::MouseButton> button_from_glfw(int glfw_button);

/// From GLFW's modifier bits.
[[nodiscard]] ui::Modifiers modifiers_from_glfw(int glfw_modifiers);

/// `modifiers` as they are once this key has gone down or up. GLFW's bits tell the state before the
/// event on some window systems and after it on others.
[[nodiscard]] ui::Modifiers with_key(ui::Modifiers modifiers, int glfw_key, bool is_down);

}  // namespace limn::app
