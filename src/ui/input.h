#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "ui/window_geometry.h"

namespace limn::ui {

enum class MouseButton : std::uint8_t { kLeft, kRight, kMiddle };
inline constexpr std::size_t kMouseButtonCount = 3;

/// Keys Limn has a use for. Letters by what the keyboard's layout prints on them, where the window
/// system tells (Ctrl+Z is Z on a German keyboard too); the others by their place on a US keyboard.
enum class Key : std::uint8_t {
  // clang-format off
  kA, kB, kC, kD, kE, kF, kG, kH, kI, kJ, kK, kL, kM,
  kN, kO, kP, kQ, kR, kS, kT, kU, kV, kW, kX, kY, kZ,
  k0, k1, k2, k3, k4, k5, k6, k7, k8, k9,
  kF1, kF2, kF3, kF4, kF5, kF6, kF7, kF8, kF9, kF10, kF11, kF12,
  kNumpad0, kNumpad1, kNumpad2, kNumpad3, kNumpad4,
  kNumpad5, kNumpad6, kNumpad7, kNumpad8, kNumpad9,
  kNumpadDecimal, kNumpadDivide, kNumpadMultiply, kNumpadSubtract, kNumpadAdd, kNumpadEnter,
  kSpace, kEnter, kEscape, kTab, kBackspace, kDelete, kInsert,
  kHome, kEnd, kPageUp, kPageDown, kLeftArrow, kRightArrow, kUpArrow, kDownArrow,
  kLeftBracket, kRightBracket, kPeriod, kComma, kSlash, kMinus, kEqual, kSemicolon, kApostrophe,
  kGrave, kBackslash,
  // clang-format on
};
inline constexpr std::size_t kKeyCount = static_cast<std::size_t>(Key::kBackslash) + 1;

/// The modifier keys held while something happened, left and right alike.
struct Modifiers {
  bool shift = false;
  bool ctrl = false;
  bool alt = false;
  bool super = false;

  [[nodiscard]] bool operator==(const Modifiers&) const = default;
};

/// What the window system reports, as plain data: it can be written down and played back.
/// A button event has no position: it happened where the last cursor event was.
struct MouseMoved {
  WindowPoint to;
  [[nodiscard]] bool operator==(const MouseMoved&) const = default;
};
struct MouseLeft {  ///< The cursor left the window.
  [[nodiscard]] bool operator==(const MouseLeft&) const = default;
};
struct ButtonChanged {
  MouseButton button = MouseButton::kLeft;
  bool is_down = false;
  [[nodiscard]] bool operator==(const ButtonChanged&) const = default;
};
struct WheelTurned {  ///< In notches; y is positive away from the person.
  double x = 0.0;
  double y = 0.0;
  [[nodiscard]] bool operator==(const WheelTurned&) const = default;
};
struct KeyChanged {
  Key key = Key::kEscape;
  bool is_down = false;
  bool is_repeat = false;  ///< Held down long enough for the system to repeat it.
  [[nodiscard]] bool operator==(const KeyChanged&) const = default;
};
struct TextTyped {
  char32_t character = 0;
  [[nodiscard]] bool operator==(const TextTyped&) const = default;
};
struct FocusLost {  ///< Everything that was held counts as let go.
  [[nodiscard]] bool operator==(const FocusLost&) const = default;
};

struct InputEvent {
  double time = 0.0;  ///< Seconds, from any fixed beginning; never falls.
  Modifiers modifiers;
  std::variant<MouseMoved, MouseLeft, ButtonChanged, WheelTurned, KeyChanged, TextTyped, FocusLost>
      what;

  [[nodiscard]] bool operator==(const InputEvent&) const = default;
};

/// A key going down (or repeating), with what was held beside it.
struct KeyPress {
  Key key = Key::kEscape;
  Modifiers modifiers;
  bool is_repeat = false;

  [[nodiscard]] bool operator==(const KeyPress&) const = default;
};

/// What one frame of the program sees. At most one button changes in it, and `cursor` is where that
/// happened, however many events piled up behind it.
struct InputFrame {
  double time = 0.0;                  ///< Of the last event in it, or of the frame before.
  Modifiers modifiers;                ///< At the end of the frame; at the button change, if any.
  std::optional<WindowPoint> cursor;  ///< Empty while it is outside the window.
  std::vector<WindowPoint> path;      ///< Every place it passed this frame, in order, `cursor` last
                                      ///< where it moved; empty where it did not.
  std::optional<ButtonChanged> button;  ///< The change of this frame.
  std::array<bool, kMouseButtonCount> buttons_down{};
  WheelTurned wheel;  ///< Sum over the frame.
  std::vector<KeyPress> presses;
  std::bitset<kKeyCount> keys_down;
  std::u32string text;

  [[nodiscard]] bool is_down(MouseButton b) const noexcept {
    return buttons_down[static_cast<std::size_t>(b)];
  }
  [[nodiscard]] bool any_button_down() const noexcept {
    return buttons_down[0] || buttons_down[1] || buttons_down[2];
  }
};

/// Stands between the window system's callbacks and the frames of the program, so that a slow
/// frame loses and misplaces nothing: a click on A followed by a move to B is a click on A.
///
/// A frame takes events in order and ends with a button change; it also ends before a key that
/// already changed in it changes again. Moves in between are kept as a path. Not thread-safe:
/// window callbacks come on the main thread.
class InputQueue {
 public:
  /// Hears of every event as it comes. One at a time; empty: nobody.
  void set_listener(std::function<void(const InputEvent&)> listener) {
    listener_ = std::move(listener);
  }
  void push(const InputEvent& event);

  /// Takes the events of the next frame. With nothing pending: the state as it was, no changes.
  [[nodiscard]] InputFrame next_frame();

  /// Events that are left for a further frame: the program must not wait for new ones then.
  [[nodiscard]] bool has_pending() const noexcept { return !events_.empty(); }

 private:
  void take(const InputEvent& event, InputFrame& frame, std::bitset<kKeyCount>& changed_keys);

  std::function<void(const InputEvent&)> listener_;
  std::deque<InputEvent> events_;
  double time_ = 0.0;
  Modifiers modifiers_;
  std::optional<WindowPoint> cursor_;
  std::array<bool, kMouseButtonCount> buttons_down_{};
  std::bitset<kKeyCount> keys_down_;
};

/// The part of a frame's input that is the viewport's: what began on a panel is left out.
struct ViewportInput {
  bool is_hovered = false;  ///< The cursor is over the viewport and over nothing on top of it,
                            ///< or a drag that began there goes on.
  bool owns_drag = false;   ///< Buttons are held that were pressed on the viewport. Still true in
                            ///< the frame that lets the last one go.
  Modifiers modifiers;
  std::optional<WindowPoint> cursor;
  std::vector<WindowPoint> path;        ///< As in InputFrame; filled where hovered or owning.
  std::optional<ButtonChanged> button;  ///< A change that belongs to the viewport.
  std::array<bool, kMouseButtonCount> buttons_down{};  ///< Those pressed on the viewport.
  WheelTurned wheel;                                   ///< Zero unless hovered or owning.

  [[nodiscard]] bool is_down(MouseButton b) const noexcept {
    return buttons_down[static_cast<std::size_t>(b)];
  }
};

/// Decides frame by frame whose the mouse is. A drag belongs to what it began on until every
/// button is released, wherever the cursor goes meanwhile.
class InputRouter {
 public:
  /// `is_over_viewport`: the cursor is in the viewport and no panel, menu or dialog lies there.
  [[nodiscard]] ViewportInput route(const InputFrame& frame, bool is_over_viewport);

 private:
  enum class Owner : std::uint8_t { kNobody, kInterface, kViewport };
  Owner owner_ = Owner::kNobody;
};

}  // namespace limn::ui
