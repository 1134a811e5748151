#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "render/coordinates.h"
#include "ui/gui.h"
#include "ui/input.h"
#include "ui/window_geometry.h"

struct GLFWwindow;

namespace limn::app {

struct WindowSettings {
  std::string title = "Limn";
  ui::WindowSize size{1280.0, 800.0};
  bool is_maximised = false;
};

/// The program's window: an OpenGL 4.5 core context, sizes in both kinds of coordinates, and every
/// event as plain data in the order it came.
///
/// One at a time, on the main thread. Only `post_wake` may be called from other threads.
class Window {
 public:
  /// Opens the window and makes its context current, with the OpenGL functions loaded.
  /// Throws render::EnvironmentError where there is no display or no OpenGL 4.5.
  explicit Window(const WindowSettings& settings);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Size in the units of cursor positions.
  [[nodiscard]] ui::WindowSize size() const;
  /// Size in pixels; empty while minimised.
  [[nodiscard]] render::FramebufferSize framebuffer_size() const;
  /// Pixels per window unit; 1 while minimised.
  [[nodiscard]] double density() const;
  /// How big the window system wants things, relative to a plain monitor: 2 at 200 %.
  [[nodiscard]] double content_scale() const;
  [[nodiscard]] bool is_maximised() const;

  /// Collects what has happened, without waiting.
  void poll_events();
  /// Waits until something happens, `post_wake` is called or the time is over. A negative time
  /// waits for ever.
  void wait_events(double seconds);
  /// Ends a wait from any thread.
  static void post_wake();

  /// Input not yet taken by frames.
  [[nodiscard]] ui::InputQueue& input() noexcept { return input_; }
  /// Files dropped on the window since the last call.
  [[nodiscard]] std::vector<std::filesystem::path> take_dropped_files();
  /// Whether the person asked to close the window since the last call. It stays open.
  [[nodiscard]] bool take_close_request() noexcept;
  /// Whether the window was moved while Alt was held, since the last call: then it is the window
  /// system that takes Alt and drag, and the program never sees it.
  [[nodiscard]] bool take_moved_under_alt() noexcept;
  /// Whether something happened since the last call after which the window must be drawn again.
  [[nodiscard]] bool take_damage() noexcept;
  /// Seconds on the clock that input events are stamped with.
  [[nodiscard]] static double now();

  void set_title(const std::string& title);
  void set_cursor(ui::CursorShape shape);
  [[nodiscard]] std::string clipboard() const;
  void set_clipboard(const std::string& text);

  /// Whether the driver was reset: everything that was drawn with is gone, and the window has to be
  /// opened again.
  [[nodiscard]] bool is_context_lost() const;

  /// Shows what was drawn.
  void swap_buffers();

 private:
  struct Callbacks;
  struct Cursors;

  void push(decltype(ui::InputEvent::what) what, int glfw_modifiers);
  void push(decltype(ui::InputEvent::what) what);

  GLFWwindow* window_ = nullptr;
  std::unique_ptr<Cursors> cursors_;
  ui::CursorShape cursor_shape_ = ui::CursorShape::kArrow;
  std::string title_;
  ui::InputQueue input_;
  ui::Modifiers modifiers_;  ///< As of the last event that told.
  std::vector<std::filesystem::path> dropped_;
  bool close_requested_ = false;
  bool moved_under_alt_ = false;
  bool is_damaged_ = true;
};

}  // namespace limn::app
