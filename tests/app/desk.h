#pragma once

#include <functional>
#include <memory>
#include <string_view>
#include <utility>

#include "app/imgui_renderer.h"
#include "app/session.h"
#include "app/viewport_scene.h"
#include "render/context/gl_context.h"
#include "render/image.h"
#include "ui/gui.h"

namespace limn::app {

/// The program without a window: panels and viewport are drawn into a picture.
class Desk {
 public:
  explicit Desk(ui::WindowSize size, ui::FontFiles fonts = {});
  ~Desk();

  /// As when the graphics driver was reset: another context, and everything in it anew.
  void lose_graphics();
  [[nodiscard]] ViewportScene& scene() noexcept { return *scene_; }
  [[nodiscard]] Session& session() noexcept { return session_; }
  [[nodiscard]] ui::Gui& gui() noexcept { return gui_; }
  /// Where the cursor rests while the picture is drawn.
  void point_at(std::string_view item);

  /// Changes what the panels are told, so that nothing in a picture depends on the machine.
  void adjust_model(std::function<void(ui::Model&)> adjust) { adjust_ = std::move(adjust); }

  /// Lets everything finish, then draws it all.
  [[nodiscard]] render::Image picture();
  /// One frame of a window of this size: panels and viewport as they are, whatever still runs.
  void draw_frame(render::FramebufferSize size);
  /// The parts of the last picture: viewport, and side panel.
  [[nodiscard]] render::Image viewport_of(const render::Image& picture) const;
  [[nodiscard]] render::Image panel_of(const render::Image& picture) const;

 private:
  [[nodiscard]] ui::GuiFrame frame();

  std::unique_ptr<render::GlContext> context_;
  ui::WindowSize size_;
  ui::Gui gui_;
  ui::InputQueue queue_;
  double time_ = 0.0;
  std::function<void(ui::Model&)> adjust_;
  ui::WindowRect viewport_;  ///< Of the last picture.
  std::unique_ptr<ImguiRenderer> imgui_renderer_;
  std::unique_ptr<ViewportScene> scene_;
  Session session_;
};

}  // namespace limn::app
