#pragma once

#include <functional>
#include <string_view>
#include <utility>

#include "app/offscreen.h"
#include "app/session.h"
#include "app/viewport_scene.h"
#include "render/image.h"
#include "ui/gui.h"

namespace limn::app {

/// The program without a window: panels and viewport are drawn into a picture.
class Desk {
 public:
  /// `scale` is that of the monitor: at 2 the window has twice the units each way.
  explicit Desk(ui::WindowSize size, ui::FontFiles fonts = {}, double scale = 1.0);

  /// As when the graphics driver was reset: another context, and everything in it anew.
  void lose_graphics() { offscreen_.lose_graphics(); }
  [[nodiscard]] ViewportScene& scene() noexcept { return offscreen_.workbench().scene(); }
  [[nodiscard]] Session& session() noexcept { return offscreen_.workbench().session(); }
  [[nodiscard]] ui::Gui& gui() noexcept { return offscreen_.workbench().gui(); }
  [[nodiscard]] Offscreen& offscreen() noexcept { return offscreen_; }

  /// Where the cursor rests while the picture is drawn: in the middle of this control.
  void point_at(std::string_view item);
  void point_at(ui::WindowPoint point);
  /// One press and release of the left button where the cursor is.
  void click();
  /// The left button goes down there, and stays down.
  void press(ui::WindowPoint point);
  /// A drag of the left button along a straight line.
  void drag(ui::WindowPoint from, ui::WindowPoint to);

  /// Changes what the panels are told, so that nothing in a picture depends on the machine.
  void adjust_model(std::function<void(ui::Model&)> adjust) {
    offscreen_.workbench().adjust_model(std::move(adjust));
  }

  /// Lets everything finish, then draws it all.
  [[nodiscard]] render::Image picture();
  /// One frame as things are, whatever still runs.
  void draw_frame();
  /// The parts of the last picture: viewport, and side panel.
  [[nodiscard]] render::Image viewport_of(const render::Image& picture) const;
  [[nodiscard]] render::Image panel_of(const render::Image& picture) const;

 private:
  void push(decltype(ui::InputEvent::what) what);
  [[nodiscard]] ui::WindowRect viewport() const;

  ui::InputQueue queue_;
  double time_ = 0.0;
  Offscreen offscreen_;
};

}  // namespace limn::app
