// The main loop: wait, take in what happened, draw a frame where there is something new. In between
// the program sleeps.
#include "app/application.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "app/fonts.h"
#include "app/status_file.h"
#include "app/user_folders.h"
#include "render/environment_error.h"

namespace limn::app {
namespace {

constexpr double kCaretBlinkSeconds = 0.4;

Screen screen_of(const Window& window) {
  const double density = window.density();
  return {window.size(), window.framebuffer_size(), {window.content_scale() / density, density}};
}

}  // namespace

Application::Application(const Preferences& preferences, Project project)
    : window_(std::make_unique<Window>(WindowSettings{
          .title = "Limn", .size = preferences.window, .is_maximised = preferences.is_maximised})),
      workbench_(
          {.wake = [] { Window::post_wake(); },
           .fonts = load_fonts(),
           .read_clipboard = [this] { return window_->clipboard(); },
           .write_clipboard = [this](const std::string& text) { window_->set_clipboard(text); },
           .recovery_folder = recovery_folder()},
          preferences, std::move(project), screen_of(*window_)) {
  workbench_.build_graphics();
}

Screen Application::screen() const {
  return screen_of(*window_);
}

void Application::run() {
  while (!workbench_.session().wants_to_quit()) {
    wait();
    try {
      if (take_news() && !window_->framebuffer_size().is_empty()) {
        frame();
      }
      if (window_->is_context_lost()) {
        rebuild_graphics("The graphics driver was reset. Everything drawn was built anew.");
      }
    } catch (const render::OutOfVideoMemory& error) {
      rebuild_graphics(std::string(error.what()) +
                       " The control mesh is shown instead: lower some depths, or close other "
                       "windows.");
      workbench_.leave_out_refined();
    }
    if (!status_file_.empty() && !needs_another_frame_ && !window_->input().has_pending()) {
      write_status();
    }
  }
}

void Application::rebuild_graphics(std::string reason) {
  constexpr double soon = 5.0;
  constexpr int most = 3;
  const double now = Window::now();
  rebuilds_ = now - rebuilt_at_ < soon ? rebuilds_ + 1 : 1;
  if (rebuilds_ > most) {
    throw render::EnvironmentError(reason + " It happens again and again.");
  }
  const Preferences seen = preferences();
  // What belongs to a context goes before it does.
  workbench_.drop_graphics();
  window_.reset();
  window_ = std::make_unique<Window>(
      WindowSettings{.title = "Limn", .size = seen.window, .is_maximised = seen.is_maximised});
  workbench_.build_graphics();
  rebuilt_at_ = Window::now();
  needs_another_frame_ = true;
  toast(ui::Toast::Kind::kProblem, std::move(reason));
}

void Application::wait() {
  if (needs_another_frame_ || window_->input().has_pending()) {
    window_->poll_events();
    return;
  }
  double seconds = workbench_.session().next_update() - Window::now();
  if (wants_text_) {
    seconds = std::min(seconds, kCaretBlinkSeconds);
  }
  if (seconds <= 0.0) {
    window_->poll_events();
  } else {
    window_->wait_events(std::isfinite(seconds) ? seconds : -1.0);
  }
}

bool Application::take_news() {
  const double now = Window::now();
  bool is_news = workbench_.take_news({window_->take_dropped_files(), window_->take_close_request(),
                                       window_->take_moved_under_alt()},
                                      now);
  is_news |= window_->take_damage();
  is_news |= std::exchange(needs_another_frame_, false);
  is_news |= window_->input().has_pending();
  is_news |= wants_text_ && now - last_frame_ >= kCaretBlinkSeconds;
  return is_news;
}

void Application::frame() {
  const double now = last_frame_ = Window::now();
  const Workbench::Frame shown = workbench_.frame(window_->input().next_frame(), screen(), now);
  window_->set_title(workbench_.session().title());
  window_->set_cursor(shown.cursor);
  window_->swap_buffers();
  needs_another_frame_ |= shown.needs_another_frame;
  wants_text_ = shown.wants_text;
}

void Application::write_status() const {
  const Session& session = workbench_.session();
  const Screen shown = screen();
  const Result<void> written = write_status_file(
      status_file_, {session, workbench_.gui().items(), workbench_.place(), shown.window,
                     shown.framebuffer, ViewportScene::camera(session, workbench_.place().size)});
  static_cast<void>(written);
}

Preferences Application::preferences() const {
  Preferences all = workbench_.preferences();
  const Screen shown = screen();
  all.window = {std::round(shown.window.width / shown.scale.interface),
                std::round(shown.window.height / shown.scale.interface)};
  all.is_maximised = window_->is_maximised();
  return all;
}

}  // namespace limn::app
