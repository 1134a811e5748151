#include "app/offscreen.h"

#include <utility>

namespace limn::app {

Offscreen::Offscreen(WorkbenchHost host, const Preferences& preferences, Project project,
                     const Screen& screen, render::HeadlessKind kind)
    : kind_(kind),
      context_(render::create_headless_context(kind)),
      screen_(screen),
      workbench_(std::move(host), preferences, std::move(project), screen) {
  make_framebuffer();
  workbench_.build_graphics();
}

Offscreen::~Offscreen() = default;

void Offscreen::make_framebuffer() {
  const glm::ivec2 size(screen_.framebuffer.width, screen_.framebuffer.height);
  framebuffer_ = render::gl::Framebuffer::create("window");
  colour_ = render::gl::Texture::create_2d(size, GL_RGBA8, "window");
  framebuffer_.attach(GL_COLOR_ATTACHMENT0, colour_);
}

void Offscreen::set_screen(const Screen& screen) {
  if (screen == screen_) {
    return;
  }
  screen_ = screen;
  make_framebuffer();
}

void Offscreen::lose_graphics() {
  workbench_.drop_graphics();
  framebuffer_ = {};
  colour_ = {};
  context_.reset();
  context_ = render::create_headless_context(kind_);
  make_framebuffer();
  workbench_.build_graphics();
}

Workbench::Frame Offscreen::frame(const ui::InputFrame& input, double now) {
  return workbench_.frame(input, screen_, now, framebuffer_.id());
}

render::Image Offscreen::picture() const {
  return read_framebuffer(screen_.framebuffer, framebuffer_.id());
}

}  // namespace limn::app
