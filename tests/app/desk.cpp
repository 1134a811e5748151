#include "app/desk.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "limn/document/open.h"
#include "limn/mesh/bundled.h"

namespace limn::app {

namespace {

int pixel(double length) {
  return static_cast<int>(std::lround(length));
}

render::Image cut(const render::Image& from, const ui::WindowRect& part) {
  const int left = pixel(part.origin.x);
  const int top = pixel(part.origin.y);
  render::Image image({pixel(part.size.width), pixel(part.size.height)});
  for (int y = 0; y < image.size.y; ++y) {
    std::copy_n(from.pixel(left, top + y), 4 * image.size.x, image.pixel(0, y));
  }
  return image;
}

}  // namespace

Desk::Desk(ui::WindowSize size, ui::FontFiles fonts, double scale)
    : offscreen_({.wake = [] {}, .fonts = std::move(fonts)}, Preferences{},
                 *open_document(std::string(kDefaultMesh)),
                 {size, {pixel(size.width), pixel(size.height)}, {scale, 1.0}},
                 render::HeadlessKind::kOsmesa) {}

void Desk::push(decltype(ui::InputEvent::what) what) {
  queue_.push({time_ += 0.01, {}, what});
}

void Desk::point_at(std::string_view item) {
  draw_frame();
  draw_frame();
  const auto items = gui().items();
  const auto found = std::ranges::find(items, item, &ui::ItemRect::name);
  ASSERT_NE(found, items.end()) << "no control is called " << item;
  point_at(ui::WindowPoint{found->rect.origin.x + found->rect.size.width / 2.0,
                           found->rect.origin.y + found->rect.size.height / 2.0});
}

void Desk::point_at(ui::WindowPoint point) {
  push(ui::MouseMoved{point});
}

void Desk::click() {
  push(ui::ButtonChanged{ui::MouseButton::kLeft, true});
  push(ui::ButtonChanged{ui::MouseButton::kLeft, false});
  while (queue_.has_pending()) {
    draw_frame();
  }
}

void Desk::press(ui::WindowPoint point) {
  point_at(point);
  push(ui::ButtonChanged{ui::MouseButton::kLeft, true});
  while (queue_.has_pending()) {
    draw_frame();
  }
}

void Desk::drag(ui::WindowPoint from, ui::WindowPoint to) {
  press(from);
  point_at(ui::WindowPoint{(from.x + to.x) / 2.0, (from.y + to.y) / 2.0});
  point_at(to);
  push(ui::ButtonChanged{ui::MouseButton::kLeft, false});
  while (queue_.has_pending()) {
    draw_frame();
  }
}

void Desk::draw_frame() {
  offscreen_.frame(queue_.next_frame(), time_ += 0.1);
}

render::Image Desk::picture() {
  session().finish_refinement();
  // Long enough for toasts to go, and in the frames for tooltips to come.
  session().update(time_ += 1000.0);
  for (int i = 0; i < 10; ++i) {
    draw_frame();
  }
  return offscreen_.picture();
}

ui::WindowRect Desk::viewport() const {
  return offscreen_.workbench().place().rect;
}

render::Image Desk::viewport_of(const render::Image& picture) const {
  ui::WindowRect whole = viewport();
  if (const auto& second = offscreen_.workbench().place().second) {
    whole.size.width += second->x - whole.origin.x;
  }
  return cut(picture, whole);
}

render::Image Desk::panel_of(const render::Image& picture) const {
  const ui::WindowRect whole = viewport();
  const auto& second = offscreen_.workbench().place().second;
  const double left = (second ? second->x : whole.origin.x) + whole.size.width;
  return cut(picture, {{left, whole.origin.y},
                       {offscreen_.screen().window.width - left, whole.size.height}});
}

}  // namespace limn::app
