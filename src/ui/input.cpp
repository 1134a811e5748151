// A frame swallows events until a button has changed. The ones behind it wait for the next frame,
// so neither ImGui nor the brush can see a press together with a place the cursor went to later. A
// release waits for the frame after the moves before it, so neither misses where a drag ended.

#include "ui/input.h"

namespace limn::ui {
namespace {

std::size_t index(MouseButton button) {
  return static_cast<std::size_t>(button);
}
std::size_t index(Key key) {
  return static_cast<std::size_t>(key);
}

}  // namespace

void InputQueue::push(const InputEvent& event) {
  if (listener_) {
    listener_(event);
  }
  if (!std::holds_alternative<FocusLost>(event.what)) {
    events_.push_back(event);
    return;
  }
  // What is held is known only when the earlier events have been taken: follow them to the end.
  std::array<bool, kMouseButtonCount> buttons = buttons_down_;
  std::bitset<kKeyCount> keys = keys_down_;
  for (const InputEvent& earlier : events_) {
    if (const auto* button = std::get_if<ButtonChanged>(&earlier.what)) {
      buttons[index(button->button)] = button->is_down;
    } else if (const auto* key = std::get_if<KeyChanged>(&earlier.what)) {
      keys.set(index(key->key), key->is_down);
    }
  }
  for (std::size_t k = 0; k < kKeyCount; ++k) {
    if (keys.test(k)) {
      events_.push_back({event.time, {}, KeyChanged{static_cast<Key>(k), false, false}});
    }
  }
  for (std::size_t b = 0; b < kMouseButtonCount; ++b) {
    if (buttons[b]) {
      events_.push_back({event.time, {}, ButtonChanged{static_cast<MouseButton>(b), false}});
    }
  }
  events_.push_back({event.time, {}, FocusLost{}});
}

InputFrame InputQueue::next_frame() {
  InputFrame frame;
  frame.cursor = cursor_;
  std::bitset<kKeyCount> changed_keys;
  while (!events_.empty() && !frame.button) {
    const InputEvent& event = events_.front();
    const auto* key = std::get_if<KeyChanged>(&event.what);
    if (key != nullptr && !key->is_repeat && changed_keys.test(index(key->key))) {
      break;
    }
    // What is dragged must see its last place while it is still held.
    const auto* button = std::get_if<ButtonChanged>(&event.what);
    if (button != nullptr && !button->is_down && buttons_down_[index(button->button)] &&
        !frame.path.empty()) {
      break;
    }
    take(event, frame, changed_keys);
    events_.pop_front();
  }
  frame.time = time_;
  frame.modifiers = modifiers_;
  frame.cursor = cursor_;
  frame.buttons_down = buttons_down_;
  frame.keys_down = keys_down_;
  return frame;
}

void InputQueue::take(const InputEvent& event, InputFrame& frame,
                      std::bitset<kKeyCount>& changed_keys) {
  time_ = event.time;
  modifiers_ = event.modifiers;
  if (const auto* move = std::get_if<MouseMoved>(&event.what)) {
    if (cursor_ != move->to) {
      cursor_ = move->to;
      frame.path.push_back(move->to);
    }
  } else if (std::holds_alternative<MouseLeft>(event.what)) {
    // During a drag the window system goes on reporting; the last place stands until it does.
    if (!buttons_down_[0] && !buttons_down_[1] && !buttons_down_[2]) {
      cursor_.reset();
      frame.path.clear();
    }
  } else if (const auto* button = std::get_if<ButtonChanged>(&event.what)) {
    if (buttons_down_[index(button->button)] != button->is_down) {
      buttons_down_[index(button->button)] = button->is_down;
      frame.button = *button;
    }
  } else if (const auto* wheel = std::get_if<WheelTurned>(&event.what)) {
    frame.wheel.x += wheel->x;
    frame.wheel.y += wheel->y;
  } else if (const auto* key = std::get_if<KeyChanged>(&event.what)) {
    changed_keys.set(index(key->key));
    keys_down_.set(index(key->key), key->is_down);
    if (key->is_down) {
      frame.presses.push_back({key->key, event.modifiers, key->is_repeat});
    }
  } else if (const auto* text = std::get_if<TextTyped>(&event.what)) {
    frame.text.push_back(text->character);
  }
}

ViewportInput InputRouter::route(const InputFrame& frame, bool is_over_viewport) {
  const bool is_pressed = frame.button && frame.button->is_down;
  if (owner_ == Owner::kNobody && is_pressed) {
    owner_ = is_over_viewport ? Owner::kViewport : Owner::kInterface;
  }
  const Owner owner = owner_;
  if (!frame.any_button_down()) {
    owner_ = Owner::kNobody;
  }

  ViewportInput input;
  input.modifiers = frame.modifiers;
  input.cursor = frame.cursor;
  input.owns_drag = owner == Owner::kViewport;
  input.is_hovered = input.owns_drag || (owner == Owner::kNobody && is_over_viewport);
  if (input.is_hovered) {
    input.path = frame.path;
    input.wheel = frame.wheel;
  }
  if (input.owns_drag) {
    input.button = frame.button;
    input.buttons_down = frame.buttons_down;
  }
  return input;
}

}  // namespace limn::ui
