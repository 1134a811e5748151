// GLFW's callbacks do nothing but push plain events with the position and time they were reported
// with; the cursor is never asked for. GLFW itself is started and stopped with the one window.
#include "app/window.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glad/gl.h>

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include "app/glfw_keys.h"
#include "render/context/load_gl.h"
#include "render/environment_error.h"

namespace limn::app {
namespace {

constexpr int kSmallestWidth = 640;
constexpr int kSmallestHeight = 400;

constexpr const char* kHeadlessAdvice =
    "Without a display, `limn refine` and `limn render` do the work from the command line.";

/// What GLFW last complained about: its own calls only say that they failed.
std::string& last_glfw_error() {
  static std::string text = "no reason given";
  return text;
}

void remember_error(int, const char* description) {
  last_glfw_error() = description;
}

void set_context_hints() {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_API);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  // A reset of the driver then loses the context instead of the program, where that is offered.
  glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET);
#ifndef NDEBUG
  glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, GLFW_TRUE);
#endif
  // The scene is drawn into a framebuffer of its own; the window's needs colour alone.
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  glfwWindowHint(GLFW_ALPHA_BITS, 0);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "Limn");
  glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "limn");
}

}  // namespace

/// Created as they are first asked for.
struct Window::Cursors {
  std::array<GLFWcursor*, 3> shapes{};

  ~Cursors() {
    for (GLFWcursor* cursor : shapes) {
      if (cursor != nullptr) {
        glfwDestroyCursor(cursor);
      }
    }
  }

  GLFWcursor* get(ui::CursorShape shape) {
    constexpr std::array kStandard = {GLFW_ARROW_CURSOR, GLFW_IBEAM_CURSOR, GLFW_HRESIZE_CURSOR};
    const auto index = static_cast<std::size_t>(shape);
    if (shapes[index] == nullptr) {
      shapes[index] = glfwCreateStandardCursor(kStandard[index]);
    }
    return shapes[index];
  }
};

struct Window::Callbacks {
  static Window& of(GLFWwindow* window) {
    return *static_cast<Window*>(glfwGetWindowUserPointer(window));
  }

  static void cursor_moved(GLFWwindow* window, double x, double y) {
    of(window).push(ui::MouseMoved{{x, y}});
  }

  static void cursor_entered(GLFWwindow* window, int entered) {
    if (entered == GLFW_FALSE) {
      of(window).push(ui::MouseLeft{});
    }
  }

  static void button_changed(GLFWwindow* window, int button, int action, int modifiers) {
    if (const auto which = button_from_glfw(button)) {
      of(window).push(ui::ButtonChanged{*which, action == GLFW_PRESS}, modifiers);
    }
  }

  static void wheel_turned(GLFWwindow* window, double x, double y) {
    of(window).push(ui::WheelTurned{x, y});
  }

  static void key_changed(GLFWwindow* window, int key, int, int action, int modifiers) {
    Window& self = of(window);
    self.modifiers_ = with_key(modifiers_from_glfw(modifiers), key, action != GLFW_RELEASE);
    self.is_damaged_ = true;
    if (const auto which = key_from_glfw(key)) {
      self.push(ui::KeyChanged{*which, action != GLFW_RELEASE, action == GLFW_REPEAT});
    }
  }

  static void text_typed(GLFWwindow* window, unsigned character) {
    of(window).push(ui::TextTyped{static_cast<char32_t>(character)});
  }

  static void focus_changed(GLFWwindow* window, int focused) {
    if (focused == GLFW_FALSE) {
      of(window).modifiers_ = {};
      of(window).push(ui::FocusLost{});
    }
  }

  static void files_dropped(GLFWwindow* window, int count, const char** paths) {
    Window& self = of(window);
    self.dropped_.insert(self.dropped_.end(), paths, paths + count);
    self.is_damaged_ = true;
  }

  static void close_requested(GLFWwindow* window) {
    glfwSetWindowShouldClose(window, GLFW_FALSE);
    of(window).close_requested_ = true;
    of(window).is_damaged_ = true;
  }

  static void moved(GLFWwindow* window, int, int) {
    Window& self = of(window);
    self.moved_under_alt_ |= self.modifiers_.alt;
    self.is_damaged_ |= self.modifiers_.alt;
  }

  static void damaged(GLFWwindow* window) { of(window).is_damaged_ = true; }
  static void resized(GLFWwindow* window, int, int) { of(window).is_damaged_ = true; }
  static void rescaled(GLFWwindow* window, float, float) { of(window).is_damaged_ = true; }

  static void install(GLFWwindow* window) {
    glfwSetCursorPosCallback(window, cursor_moved);
    glfwSetCursorEnterCallback(window, cursor_entered);
    glfwSetMouseButtonCallback(window, button_changed);
    glfwSetScrollCallback(window, wheel_turned);
    glfwSetKeyCallback(window, key_changed);
    glfwSetCharCallback(window, text_typed);
    glfwSetWindowFocusCallback(window, focus_changed);
    glfwSetDropCallback(window, files_dropped);
    glfwSetWindowCloseCallback(window, close_requested);
    glfwSetWindowPosCallback(window, moved);
    glfwSetWindowRefreshCallback(window, damaged);
    glfwSetFramebufferSizeCallback(window, resized);
    glfwSetWindowSizeCallback(window, resized);
    glfwSetWindowContentScaleCallback(window, rescaled);
  }
};

namespace {

/// The size asked for, as far as the monitor has room for it and the interface can do with it. All
/// before the monitor's scale, by which GLFW multiplies it.
std::pair<int, int> initial_size(const ui::WindowSize& asked) {
  int width = static_cast<int>(std::lround(asked.width));
  int height = static_cast<int>(std::lround(asked.height));
  if (GLFWmonitor* monitor = glfwGetPrimaryMonitor(); monitor != nullptr) {
    int room_width = 0;
    int room_height = 0;
    glfwGetMonitorWorkarea(monitor, nullptr, nullptr, &room_width, &room_height);
    float scale_x = 1.0F;
    float scale_y = 1.0F;
    glfwGetMonitorContentScale(monitor, &scale_x, &scale_y);
    const auto fit = [](int wanted, int room, float scale) {
      const int most = static_cast<int>(std::floor(static_cast<float>(room) / scale));
      return room > 0 && scale > 0.0F ? std::min(wanted, most) : wanted;
    };
    width = fit(width, room_width, scale_x);
    height = fit(height, room_height, scale_y);
  }
  return {std::max(width, kSmallestWidth), std::max(height, kSmallestHeight)};
}

}  // namespace

Window::Window(const WindowSettings& settings) : title_(settings.title) {
  glfwSetErrorCallback(remember_error);
  if (glfwInit() == GLFW_FALSE) {
    throw render::EnvironmentError(
        fmt::format("No window can be opened: there is no display to open it on ({}). {}",
                    last_glfw_error(), kHeadlessAdvice));
  }
  set_context_hints();
  glfwWindowHint(GLFW_MAXIMIZED, settings.is_maximised ? GLFW_TRUE : GLFW_FALSE);
  const auto [width, height] = initial_size(settings.size);
  window_ = glfwCreateWindow(width, height, title_.c_str(), nullptr, nullptr);
  if (window_ == nullptr) {
    const std::string reason = last_glfw_error();
    glfwTerminate();
    throw render::EnvironmentError(fmt::format(
        "No window with OpenGL 4.5 can be opened ({}). Update the graphics driver, or use Mesa's "
        "software renderer by setting LIBGL_ALWAYS_SOFTWARE=1. {}",
        reason, kHeadlessAdvice));
  }
  glfwSetWindowSizeLimits(window_, kSmallestWidth, kSmallestHeight, GLFW_DONT_CARE, GLFW_DONT_CARE);
  glfwMakeContextCurrent(window_);
  try {
    render::load_gl(glfwGetProcAddress);
  } catch (...) {
    glfwDestroyWindow(window_);
    glfwTerminate();
    throw;
  }
  glfwSwapInterval(1);
  glfwSetWindowUserPointer(window_, this);
  Callbacks::install(window_);
  cursors_ = std::make_unique<Cursors>();
}

Window::~Window() {
  cursors_.reset();
  glfwDestroyWindow(window_);
  glfwTerminate();
}

ui::WindowSize Window::size() const {
  int width = 0;
  int height = 0;
  glfwGetWindowSize(window_, &width, &height);
  return {static_cast<double>(width), static_cast<double>(height)};
}

render::FramebufferSize Window::framebuffer_size() const {
  if (glfwGetWindowAttrib(window_, GLFW_ICONIFIED) != GLFW_FALSE) {
    return {};
  }
  render::FramebufferSize size;
  glfwGetFramebufferSize(window_, &size.width, &size.height);
  return size;
}

double Window::density() const {
  const double units = size().height;
  const int pixels = framebuffer_size().height;
  return units > 0.0 && pixels > 0 ? pixels / units : 1.0;
}

double Window::content_scale() const {
  float x = 1.0F;
  float y = 1.0F;
  glfwGetWindowContentScale(window_, &x, &y);
  return std::clamp(static_cast<double>(y), 0.5, 8.0);
}

bool Window::is_maximised() const {
  return glfwGetWindowAttrib(window_, GLFW_MAXIMIZED) != GLFW_FALSE;
}

void Window::poll_events() {
  glfwPollEvents();
}

void Window::wait_events(double seconds) {
  if (seconds < 0.0) {
    glfwWaitEvents();
  } else {
    glfwWaitEventsTimeout(seconds);
  }
}

void Window::post_wake() {
  glfwPostEmptyEvent();
}

std::vector<std::filesystem::path> Window::take_dropped_files() {
  return std::exchange(dropped_, {});
}

bool Window::take_close_request() noexcept {
  return std::exchange(close_requested_, false);
}

bool Window::take_moved_under_alt() noexcept {
  return std::exchange(moved_under_alt_, false);
}

bool Window::take_damage() noexcept {
  return std::exchange(is_damaged_, false);
}

double Window::now() {
  return glfwGetTime();
}

void Window::set_title(const std::string& title) {
  if (title != title_) {
    title_ = title;
    glfwSetWindowTitle(window_, title_.c_str());
  }
}

void Window::set_cursor(ui::CursorShape shape) {
  if (shape != cursor_shape_) {
    cursor_shape_ = shape;
    glfwSetCursor(window_, cursors_->get(shape));
  }
}

std::string Window::clipboard() const {
  const char* text = glfwGetClipboardString(window_);
  return text == nullptr ? std::string() : text;
}

void Window::set_clipboard(const std::string& text) {
  glfwSetClipboardString(window_, text.c_str());
}

bool Window::is_context_lost() const {
  return glGetGraphicsResetStatus() != GL_NO_ERROR;
}

void Window::swap_buffers() {
  glfwSwapBuffers(window_);
}

void Window::push(decltype(ui::InputEvent::what) what, int glfw_modifiers) {
  modifiers_ = modifiers_from_glfw(glfw_modifiers);
  push(what);
}

void Window::push(decltype(ui::InputEvent::what) what) {
  input_.push({glfwGetTime(), modifiers_, what});
  is_damaged_ = true;
}

}  // namespace limn::app
