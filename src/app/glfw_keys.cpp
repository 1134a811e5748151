// GLFW numbers printable keys by their ASCII code and the others in runs that follow the keyboard,
// so ranges cover most of them.
#include "app/glfw_keys.h"

#include <GLFW/glfw3.h>

namespace limn::app {
namespace {

using ui::Key;

struct Range {
  int first;
  int last;
  Key key;  ///< Of `first`; the others follow in our order.
};

constexpr Range kRanges[] = {
    {GLFW_KEY_A, GLFW_KEY_Z, Key::kA},
    {GLFW_KEY_0, GLFW_KEY_9, Key::k0},
    {GLFW_KEY_F1, GLFW_KEY_F12, Key::kF1},
    {GLFW_KEY_KP_0, GLFW_KEY_KP_9, Key::kNumpad0},
};

struct Single {
  int glfw;
  Key key;
};

constexpr Single kSingles[] = {
    {GLFW_KEY_KP_DECIMAL, Key::kNumpadDecimal},
    {GLFW_KEY_KP_DIVIDE, Key::kNumpadDivide},
    {GLFW_KEY_KP_MULTIPLY, Key::kNumpadMultiply},
    {GLFW_KEY_KP_SUBTRACT, Key::kNumpadSubtract},
    {GLFW_KEY_KP_ADD, Key::kNumpadAdd},
    {GLFW_KEY_KP_ENTER, Key::kNumpadEnter},
    {GLFW_KEY_SPACE, Key::kSpace},
    {GLFW_KEY_ENTER, Key::kEnter},
    {GLFW_KEY_ESCAPE, Key::kEscape},
    {GLFW_KEY_TAB, Key::kTab},
    {GLFW_KEY_BACKSPACE, Key::kBackspace},
    {GLFW_KEY_DELETE, Key::kDelete},
    {GLFW_KEY_INSERT, Key::kInsert},
    {GLFW_KEY_HOME, Key::kHome},
    {GLFW_KEY_END, Key::kEnd},
    {GLFW_KEY_PAGE_UP, Key::kPageUp},
    {GLFW_KEY_PAGE_DOWN, Key::kPageDown},
    {GLFW_KEY_LEFT, Key::kLeftArrow},
    {GLFW_KEY_RIGHT, Key::kRightArrow},
    {GLFW_KEY_UP, Key::kUpArrow},
    {GLFW_KEY_DOWN, Key::kDownArrow},
    {GLFW_KEY_LEFT_BRACKET, Key::kLeftBracket},
    {GLFW_KEY_RIGHT_BRACKET, Key::kRightBracket},
    {GLFW_KEY_PERIOD, Key::kPeriod},
    {GLFW_KEY_COMMA, Key::kComma},
    {GLFW_KEY_SLASH, Key::kSlash},
    {GLFW_KEY_MINUS, Key::kMinus},
    {GLFW_KEY_EQUAL, Key::kEqual},
    {GLFW_KEY_SEMICOLON, Key::kSemicolon},
    {GLFW_KEY_APOSTROPHE, Key::kApostrophe},
    {GLFW_KEY_GRAVE_ACCENT, Key::kGrave},
    {GLFW_KEY_BACKSLASH, Key::kBackslash},
};

}  // namespace

std::optional<ui::Key> key_from_glfw(int glfw_key) {
  for (const Range& range : kRanges) {
    if (glfw_key >= range.first && glfw_key <= range.last) {
      return static_cast<Key>(static_cast<int>(range.key) + glfw_key - range.first);
    }
  }
  for (const Single& single : kSingles) {
    if (single.glfw == glfw_key) {
      return single.key;
    }
  }
  return std::nullopt;
}

std::optional<ui::MouseButton> button_from_glfw(int glfw_button) {
  switch (glfw_button) {
    case GLFW_MOUSE_BUTTON_LEFT:
      return ui::MouseButton::kLeft;
    case GLFW_MOUSE_BUTTON_RIGHT:
      return ui::MouseButton::kRight;
    case GLFW_MOUSE_BUTTON_MIDDLE:
      return ui::MouseButton::kMiddle;
    default:
      return std::nullopt;
  }
}

ui::Modifiers modifiers_from_glfw(int glfw_modifiers) {
  return {(glfw_modifiers & GLFW_MOD_SHIFT) != 0, (glfw_modifiers & GLFW_MOD_CONTROL) != 0,
          (glfw_modifiers & GLFW_MOD_ALT) != 0, (glfw_modifiers & GLFW_MOD_SUPER) != 0};
}

ui::Modifiers with_key(ui::Modifiers modifiers, int glfw_key, bool is_down) {
  switch (glfw_key) {
    case GLFW_KEY_LEFT_SHIFT:
    case GLFW_KEY_RIGHT_SHIFT:
      modifiers.shift = is_down;
      break;
    case GLFW_KEY_LEFT_CONTROL:
    case GLFW_KEY_RIGHT_CONTROL:
      modifiers.ctrl = is_down;
      break;
    case GLFW_KEY_LEFT_ALT:
    case GLFW_KEY_RIGHT_ALT:
      modifiers.alt = is_down;
      break;
    case GLFW_KEY_LEFT_SUPER:
    case GLFW_KEY_RIGHT_SUPER:
      modifiers.super = is_down;
      break;
    default:
      break;
  }
  return modifiers;
}

}  // namespace limn::app
