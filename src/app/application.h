#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/imgui_renderer.h"
#include "app/preferences.h"
#include "app/session.h"
#include "app/viewport_controller.h"
#include "app/viewport_scene.h"
#include "app/window.h"
#include "limn/document/project_file.h"
#include "ui/gui.h"

namespace limn::app {

/// The program with its window: gathers input, lets the interface and the viewport turn it into
/// actions, and draws when there is something new to see.
class Application {
 public:
  /// Opens the window. Throws render::EnvironmentError.
  Application(const Preferences& preferences, Project project);

  /// Writes the state as JSON here whenever it comes to rest (status_file.h).
  void set_status_file(std::filesystem::path path) { status_file_ = std::move(path); }
  void offer(std::vector<LostWork> lost) { session_.offer(std::move(lost)); }
  void toast(ui::Toast::Kind kind, std::string text) { session_.toast(kind, std::move(text)); }

  /// Runs until the person quits. Throws render::EnvironmentError.
  void run();

  /// As they are now, to be kept for the next run.
  [[nodiscard]] Preferences preferences() const;

 private:
  /// Waits for input, time or news from other threads, as long as there is nothing to draw.
  void wait();
  /// Takes in what has happened; true where a frame must be drawn.
  [[nodiscard]] bool take_news();
  void frame();
  /// Where the mended element shows that the person was led to, by the last frame's place.
  [[nodiscard]] std::optional<ui::WindowPoint> mend_marker(const ui::Model& model) const;
  void draw(const ViewportPlace& place);
  void take_screenshot(const std::filesystem::path& path);
  void write_status() const;
  void sync_scene();
  /// Opens the window again, with everything that is drawn from what the session has, and says why.
  /// Throws render::EnvironmentError where that happens again and again.
  void rebuild_graphics(std::string reason);
  [[nodiscard]] ui::Scale scale() const;
  [[nodiscard]] ViewportPlace place_of(const ui::WindowRect& viewport) const;

  // In this order: the session's thread wakes the window, and everything drawn needs its context.
  std::unique_ptr<Window> window_;
  ui::Gui gui_;
  std::unique_ptr<ImguiRenderer> imgui_renderer_;
  std::unique_ptr<ViewportScene> scene_;
  ViewportController controller_;
  Session session_;

  ViewportPlace place_;      ///< Of the last frame.
  double last_frame_ = 0.0;  ///< When it was, in seconds.
  bool needs_another_frame_ = true;
  bool wants_text_ = false;
  double rebuilt_at_ = 0.0;   ///< When the graphics were built anew, in seconds,
  int rebuilds_ = 0;          ///< and how often within a short time.
  std::string sync_problem_;  ///< Said once.
  std::filesystem::path status_file_;
};

}  // namespace limn::app
