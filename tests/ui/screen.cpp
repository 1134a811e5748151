#include "ui/screen.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>

#include "limn/contract.h"
#include "limn/mesh/build.h"

namespace limn::ui {
namespace {

Document cube_document() {
  PolygonSoup soup;
  for (int i = 0; i < 8; ++i) {
    soup.positions.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  }
  constexpr std::array<std::array<std::uint32_t, 4>, 6> kFaces{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (const auto& face : kFaces) {
    soup.add_face(face);
  }
  Result<ImportedMesh> imported = build_control_mesh(soup);
  LIMN_EXPECTS(imported.has_value());
  Document document;
  document.control = imported->mesh;
  document.opened = imported->mesh;
  document.depths = FaceDepths(imported->mesh->face_count());
  document.name = "cube";
  return document;
}

}  // namespace

Screen::Screen(WindowSize window_size, Scale scale, FontFiles fonts)
    : document(cube_document()),
      statistics(mesh_statistics(*document.control)),
      model{.document = document, .statistics = statistics},
      window(window_size),
      gui_(std::move(fonts), scale) {
  prediction.faces = 24;
  prediction.vertices = 26;
  prediction.uniform_faces = 96;
  model.depth_counts[0] = 6;
  model.refinement.prediction = &prediction;
  model.frame_seconds = 1.0 / 60.0;
  // Windows know where they are from their second frame on.
  frame();
  frame();
  actions_.clear();
}

const GuiFrame& Screen::frame() {
  model.bundled_meshes = bundled;
  model.recent_files = recent;
  model.toasts = toasts;
  last_ = gui_.frame(model, queue_.next_frame(), window);
  actions_.insert(actions_.end(), last_.actions.begin(), last_.actions.end());
  return last_;
}

void Screen::settle() {
  do {
    frame();
  } while (queue_.has_pending());
  frame();
}

InputEvent Screen::event(Modifiers modifiers) {
  time_ += 0.01;
  InputEvent next;
  next.time = time_;
  next.modifiers = modifiers;
  return next;
}

void Screen::move(WindowPoint to) {
  InputEvent next = event();
  next.what = MouseMoved{to};
  queue_.push(next);
}

void Screen::button(MouseButton which, bool is_down) {
  InputEvent next = event();
  next.what = ButtonChanged{which, is_down};
  queue_.push(next);
}

void Screen::click(WindowPoint at) {
  move(at);
  settle();
  button(MouseButton::kLeft, true);
  button(MouseButton::kLeft, false);
  settle();
}

void Screen::click(std::string_view name) {
  click(middle(name));
}

void Screen::key(Key which, Modifiers modifiers) {
  InputEvent next = event(modifiers);
  next.what = KeyChanged{which, true, false};
  queue_.push(next);
  next = event(modifiers);
  next.what = KeyChanged{which, false, false};
  queue_.push(next);
  next = event();
  next.what = KeyChanged{which, false, false};
  queue_.push(next);
  settle();
}

void Screen::type(std::u32string_view text) {
  for (const char32_t character : text) {
    const bool is_letter = character >= U'a' && character <= U'z';
    const Key typed =
        is_letter ? static_cast<Key>(static_cast<int>(Key::kA) + static_cast<int>(character - U'a'))
                  : Key::kPeriod;
    InputEvent next = event();
    next.what = KeyChanged{typed, true, false};
    queue_.push(next);
    next.what = TextTyped{character};
    queue_.push(next);
    next.what = KeyChanged{typed, false, false};
    queue_.push(next);
  }
  settle();
}

bool Screen::has(std::string_view name) const {
  const std::span<const ItemRect> items = gui_.items();
  return std::any_of(items.begin(), items.end(),
                     [name](const ItemRect& item) { return item.name == name; });
}

WindowRect Screen::rect(std::string_view name) const {
  for (const ItemRect& item : gui_.items()) {
    if (item.name == name) {
      return item.rect;
    }
  }
  ADD_FAILURE() << "no control is called " << name;
  return {};
}

WindowPoint Screen::middle(std::string_view name) const {
  const WindowRect at = rect(name);
  return {at.origin.x + at.size.width / 2.0, at.origin.y + at.size.height / 2.0};
}

std::vector<Action> Screen::take_actions() {
  return std::exchange(actions_, {});
}

}  // namespace limn::ui
