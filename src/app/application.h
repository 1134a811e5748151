#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/preferences.h"
#include "app/recording/recorder.h"
#include "app/window.h"
#include "app/workbench.h"
#include "limn/document/project_file.h"

namespace limn::app {

/// The program with its window: gathers input and news, and lets the workbench draw when there is
/// something new to see.
class Application {
 public:
  /// Opens the window. `recorder` may be null; it must outlive this. Throws
  /// render::EnvironmentError.
  Application(const Preferences& preferences, Project project, Recorder* recorder = nullptr);

  /// Writes the state as JSON here whenever it comes to rest (status_file.h).
  void set_status_file(std::filesystem::path path) { status_file_ = std::move(path); }
  void offer(std::vector<LostWork> lost) { workbench_.session().offer(std::move(lost)); }
  void toast(ui::Toast::Kind kind, std::string text) {
    workbench_.session().toast(kind, std::move(text));
  }

  /// Begins the recording: the head says how the project was come by. Before `run`.
  void begin_recording(std::string input, std::string project);

  /// As if this file were dropped on the window.
  void drop(std::filesystem::path file) { dropped_.push_back(std::move(file)); }

  /// Runs until the person quits. Throws render::EnvironmentError.
  void run();

  /// As they are now, to be kept for the next run.
  [[nodiscard]] Preferences preferences() const;

 private:
  /// Waits for input, time or news from other threads, as long as there is nothing to draw.
  void wait();
  /// What opens the desktop's dialogs; empty where there are none.
  [[nodiscard]] std::function<bool(const DialogRequest&)> ask_desktop();
  /// Has the recorder hear of every event.
  void listen();
  /// Takes in what has happened; true where a frame must be drawn.
  [[nodiscard]] bool take_news(double now);
  void frame(double now);
  void write_status() const;
  /// Opens the window again, with everything that is drawn from what the session has, and says why.
  /// Throws render::EnvironmentError where that happens again and again.
  void rebuild_graphics(std::string reason);
  [[nodiscard]] Screen screen() const;

  std::unique_ptr<Window> window_;  // First: its context goes after everything drawn with it.
  DesktopDialog dialog_{[] { Window::post_wake(); }};
  Recorder* recorder_;
  Workbench workbench_;

  std::vector<std::filesystem::path> dropped_;  ///< Beside those that the window knows of.
  double last_frame_ = 0.0;                     ///< When it was, in seconds.
  bool needs_another_frame_ = true;
  bool wants_text_ = false;
  double rebuilt_at_ = 0.0;  ///< When the graphics were built anew, in seconds,
  int rebuilds_ = 0;         ///< and how often within a short time.
  std::filesystem::path status_file_;
};

}  // namespace limn::app
