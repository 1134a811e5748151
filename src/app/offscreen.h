#pragma once

#include <memory>

#include "app/workbench.h"
#include "render/context/gl_context.h"
#include "render/gl/framebuffer.h"
#include "render/gl/texture.h"
#include "render/image.h"
#include "ui/input.h"

namespace limn::app {

/// A workbench whose window is a picture in memory: for playing back what was recorded, for
/// pictures of the program, and for tests. Time is what it is told.
class Offscreen {
 public:
  /// Makes a context of its own. Throws render::EnvironmentError.
  Offscreen(WorkbenchHost host, const Preferences& preferences, Project project,
            const Screen& screen, render::HeadlessKind kind = render::HeadlessKind::kAny);
  ~Offscreen();
  Offscreen(const Offscreen&) = delete;
  Offscreen& operator=(const Offscreen&) = delete;

  [[nodiscard]] Workbench& workbench() noexcept { return workbench_; }
  [[nodiscard]] const Workbench& workbench() const noexcept { return workbench_; }
  [[nodiscard]] const Screen& screen() const noexcept { return screen_; }
  /// As when the window is resized, or moved to another monitor.
  void set_screen(const Screen& screen);
  /// As when the graphics driver was reset: another context, and everything in it anew.
  void lose_graphics();

  /// One frame of the workbench. Throws render::EnvironmentError.
  Workbench::Frame frame(const ui::InputFrame& input, double now);
  /// What the last frame shows.
  [[nodiscard]] render::Image picture() const;

 private:
  void make_framebuffer();

  render::HeadlessKind kind_;
  std::unique_ptr<render::GlContext> context_;  // First: it goes after everything made in it.
  Screen screen_;
  render::gl::Texture colour_;
  render::gl::Framebuffer framebuffer_;
  Workbench workbench_;
};

}  // namespace limn::app
