// The main loop: wait, take in what happened, draw a frame where there is something new. In between
// the program sleeps.
#include "app/application.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <iterator>
#include <memory>
#include <string>
#include <utility>

#include "app/fonts.h"
#include "app/status_file.h"
#include "app/user_folders.h"
#include "limn/contract.h"
#include "limn/document/memory_budget.h"
#include "render/context/load_gl.h"
#include "render/environment_error.h"

namespace limn::app {
namespace {

constexpr double kCaretBlinkSeconds = 0.4;

Screen screen_of(const Window& window) {
  const double density = window.density();
  return {window.size(), window.framebuffer_size(), {window.content_scale() / density, density}};
}

/// "14:05"
std::string time_of_day() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  ::localtime_r(&now, &local);
  std::array<char, 8> text{};
  const std::size_t length = std::strftime(text.data(), text.size(), "%H:%M", &local);
  return {text.data(), length};
}

}  // namespace

Application::Application(const Preferences& preferences, Project project, Recorder* recorder)
    : window_(std::make_unique<Window>(WindowSettings{
          .title = "Limn", .size = preferences.window, .is_maximised = preferences.is_maximised})),
      recorder_(recorder),
      workbench_(
          {.wake = [] { Window::post_wake(); },
           .fonts = load_fonts(),
           .read_clipboard =
               [this] {
                 const std::string text = window_->clipboard();
                 return recorder_ != nullptr ? recorder_->read_clipboard(text) : text;
               },
           .write_clipboard = [this](const std::string& text) { window_->set_clipboard(text); },
           .recovery_folder = recovery_folder(),
           .ask_desktop = ask_desktop(),
           .close_desktop_dialog = [this] { dialog_.close(); },
           // A picture of what is recorded is to be the same when it is played back.
           .wall_clock = recorder == nullptr ? std::function<std::string()>(time_of_day) : nullptr,
           .files = recorder,
           .arrivals = recorder},
          preferences, std::move(project), screen_of(*window_)) {
  workbench_.build_graphics();
  listen();
}

std::function<bool(const DialogRequest&)> Application::ask_desktop() {
  const std::optional<DialogProgram> program = find_dialog_program();
  if (!program) {
    return {};
  }
  return [this, program](const DialogRequest& request) { return dialog_.open(*program, request); };
}

void Application::listen() {
  if (recorder_ != nullptr) {
    window_->input().set_listener([this](const ui::InputEvent& event) { recorder_->add(event); });
  }
}

void Application::begin_recording(std::string input, std::string project) {
  LIMN_EXPECTS(recorder_ != nullptr);
  // What the machine can spare changes all the time; in a recording it is what it was.
  const std::uint64_t memory = memory_budget();
  workbench_.session().set_memory_budget(memory);
  recorder_->begin({.program = "limn " LIMN_VERSION,
                    .renderer = render::renderer_text(),
                    .fonts = checksum_of(load_fonts()),
                    .input = std::move(input),
                    .project = std::move(project),
                    .screen = screen(),
                    .preferences = workbench_.preferences(),
                    .memory_budget = memory,
                    .has_desktop_dialogs = find_dialog_program().has_value()});
}

Screen Application::screen() const {
  return screen_of(*window_);
}

void Application::run() {
  while (!workbench_.session().wants_to_quit()) {
    wait();
    try {
      const double now = Window::now();
      if (take_news(now) && !window_->framebuffer_size().is_empty()) {
        frame(now);
      }
      if (recorder_ != nullptr) {
        recorder_->end_turn(workbench_);
        if (const auto error = recorder_->take_error()) {
          toast(ui::Toast::Kind::kProblem, to_string(*error));
        }
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
  if (recorder_ != nullptr) {
    recorder_->end(workbench_);
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
  listen();
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

bool Application::take_news(double now) {
  Workbench::News news{std::exchange(dropped_, {}), window_->take_close_request(),
                       window_->take_moved_under_alt(), dialog_.take_answer()};
  std::ranges::move(window_->take_dropped_files(), std::back_inserter(news.dropped_files));
  if (recorder_ != nullptr) {
    recorder_->begin_turn(news, now);
  }
  bool is_news = workbench_.take_news(news, now);
  is_news |= window_->take_damage();
  is_news |= std::exchange(needs_another_frame_, false);
  is_news |= window_->input().has_pending();
  is_news |= wants_text_ && now - last_frame_ >= kCaretBlinkSeconds;
  return is_news;
}

void Application::frame(double now) {
  last_frame_ = now;
  const Screen shown_on = screen();
  const Workbench::Frame shown = workbench_.frame(window_->input().next_frame(), shown_on, now);
  if (recorder_ != nullptr) {
    recorder_->add_frame(shown_on, shown);
  }
  window_->set_title(workbench_.session().title());
  window_->set_cursor(shown.cursor);
  window_->swap_buffers();
  workbench_.note_shown(Window::now());
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
