#include "app/desk.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glad/gl.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include "render/gl/framebuffer.h"
#include "render/gl/texture.h"

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

Desk::Desk(ui::WindowSize size, ui::FontFiles fonts)
    : context_(render::create_headless_context(render::HeadlessKind::kOsmesa)),
      size_(size),
      gui_(std::move(fonts), {}),
      imgui_renderer_(std::make_unique<ImguiRenderer>()),
      scene_(std::make_unique<ViewportScene>()),
      session_({[] {}, {}}) {}

Desk::~Desk() = default;

void Desk::lose_graphics() {
  scene_.reset();
  imgui_renderer_.reset();
  context_.reset();
  context_ = render::create_headless_context(render::HeadlessKind::kOsmesa);
  imgui_renderer_ = std::make_unique<ImguiRenderer>();
  scene_ = std::make_unique<ViewportScene>();
}

void Desk::point_at(std::string_view item) {
  static_cast<void>(frame());
  static_cast<void>(frame());
  const auto items = gui_.items();
  const auto found = std::ranges::find(items, item, &ui::ItemRect::name);
  ASSERT_NE(found, items.end()) << "no control is called " << item;
  ui::InputEvent event;
  event.time = time_ += 0.01;
  event.what = ui::MouseMoved{{found->rect.origin.x + found->rect.size.width / 2.0,
                               found->rect.origin.y + found->rect.size.height / 2.0}};
  queue_.push(event);
}

ui::GuiFrame Desk::frame() {
  ui::Model model = session_.model();
  model.frame_seconds = 0.1;
  if (adjust_) {
    adjust_(model);
  }
  ui::GuiFrame frame = gui_.frame(model, queue_.next_frame(), size_);
  for (const ui::Action& action : frame.actions) {
    session_.perform(action);
  }
  return frame;
}

void Desk::draw_frame(render::FramebufferSize size) {
  static_cast<void>(frame());
  EXPECT_TRUE(scene_->sync(session_));
  ViewportLook look;
  look.edge = session_.hover_edge();
  scene_->draw(session_, size, look);
  static_cast<void>(
      scene_->pick(session_, size, {size.width / 2.0, static_cast<double>(size.height) / 2.0}));
}

render::Image Desk::picture() {
  session_.finish_refinement();
  // Long enough for tooltips and toasts.
  session_.update(1000.0);
  ui::GuiFrame shown;
  for (int i = 0; i < 10; ++i) {
    shown = frame();
  }
  viewport_ = shown.viewport;
  const ui::ViewportHalves halves = ui::viewport_halves(shown.viewport, session_.is_split());
  const render::FramebufferSize half{pixel(halves.first.size.width),
                                     pixel(halves.first.size.height)};
  session_.set_aspect(half.aspect());
  EXPECT_TRUE(scene_->sync(session_));
  ViewportLook look;
  look.edge = session_.hover_edge();
  scene_->draw(session_, half, look);

  const glm::ivec2 size(pixel(size_.width), pixel(size_.height));
  const render::gl::Texture colour = render::gl::Texture::create_2d(size, GL_RGBA8, "desk");
  render::gl::Framebuffer whole = render::gl::Framebuffer::create("desk");
  whole.attach(GL_COLOR_ATTACHMENT0, colour);
  whole.bind();
  glViewport(0, 0, size.x, size.y);
  glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
  const auto lower_left = [&](const ui::WindowPoint& upper_left) {
    return glm::ivec2(pixel(upper_left.x), size.y - pixel(upper_left.y) - half.height);
  };
  scene_->present(lower_left(halves.first.origin), whole.id());
  if (halves.second) {
    scene_->present_second(lower_left(halves.second->origin), whole.id());
  }
  whole.bind();
  imgui_renderer_->set_atlas(gui_.atlas(), gui_.atlas_revision());
  imgui_renderer_->draw(gui_.draw_data());
  render::Image image(size);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  for (int y = 0; y < size.y; ++y) {
    glReadPixels(0, size.y - 1 - y, size.x, 1, GL_RGBA, GL_UNSIGNED_BYTE, image.pixel(0, y));
  }
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
    image.rgba[i] = 255;
  }
  return image;
}

render::Image Desk::viewport_of(const render::Image& picture) const {
  return cut(picture, viewport_);
}

render::Image Desk::panel_of(const render::Image& picture) const {
  const double left = viewport_.origin.x + viewport_.size.width;
  return cut(picture, {{left, viewport_.origin.y}, {size_.width - left, viewport_.size.height}});
}

}  // namespace limn::app
