// One frame: input of one button change at most, panels, actions, viewport, uploads, drawing. In
// between the program sleeps.
#include "app/application.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include <glad/gl.h>
#include <imgui.h>

#include "app/fonts.h"
#include "app/status_file.h"
#include "app/user_folders.h"
#include "render/environment_error.h"
#include "render/png.h"

namespace limn::app {
namespace {

constexpr double kCaretBlinkSeconds = 0.4;

/// Answers the controller from the scene, for the session's view and a viewport of this size.
class ScenePicker final : public ViewportPicker {
 public:
  ScenePicker(ViewportScene& scene, const Session& session, render::FramebufferSize size)
      : scene_(scene), session_(session), size_(size) {}

  [[nodiscard]] std::optional<render::PickedFace> pick(render::FramebufferPoint point) override {
    return scene_.pick(session_, size_, point);
  }
  [[nodiscard]] std::vector<std::uint32_t> brush(const render::BrushCapsule& capsule) override {
    return scene_.brush(session_, size_, capsule);
  }

 private:
  ViewportScene& scene_;
  const Session& session_;
  render::FramebufferSize size_;
};

}  // namespace

Application::Application(const Preferences& preferences, Project project)
    : window_(std::make_unique<Window>(WindowSettings{
          .title = "Limn", .size = preferences.window, .is_maximised = preferences.is_maximised})),
      gui_(load_fonts(), scale()),
      imgui_renderer_(std::make_unique<ImguiRenderer>()),
      scene_(std::make_unique<ViewportScene>()),
      session_({[] { Window::post_wake(); },
                [this]() -> Result<std::vector<std::uint32_t>> {
                  sync_scene();
                  return scene_->visible_faces(session_, place_.size);
                },
                recovery_folder()}) {
  gui_.set_layout(preferences.layout);
  gui_.set_clipboard([this] { return window_->clipboard(); },
                     [this](const std::string& text) { window_->set_clipboard(text); });
  session_.restore(preferences.display, preferences.keymap, preferences.brush_radius,
                   preferences.dihedral_threshold);
  session_.set_navigation(preferences.navigation);
  session_.set_crease_sharpness(preferences.crease_sharpness);
  session_.set_recent_files(preferences.recent_files);
  session_.set_face_budget(preferences.face_budget);
  session_.show(std::move(project));
}

ui::Scale Application::scale() const {
  const double density = window_->density();
  return {window_->content_scale() / density, density};
}

void Application::run() {
  while (!session_.wants_to_quit()) {
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
      scene_->leave_out_refined(session_);
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
  scene_.reset();
  imgui_renderer_.reset();
  window_.reset();
  window_ = std::make_unique<Window>(
      WindowSettings{.title = "Limn", .size = seen.window, .is_maximised = seen.is_maximised});
  imgui_renderer_ = std::make_unique<ImguiRenderer>();
  scene_ = std::make_unique<ViewportScene>();
  rebuilt_at_ = Window::now();
  needs_another_frame_ = true;
  toast(ui::Toast::Kind::kProblem, std::move(reason));
}

void Application::wait() {
  if (needs_another_frame_ || window_->input().has_pending()) {
    window_->poll_events();
    return;
  }
  double seconds = session_.next_update() - Window::now();
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
  for (const std::filesystem::path& file : window_->take_dropped_files()) {
    session_.perform({ui::ActionId::kOpen, file.string()});
  }
  if (window_->take_close_request()) {
    session_.perform(ui::ActionId::kQuit);
  }
  if (window_->take_moved_under_alt()) {
    toast(ui::Toast::Kind::kNote,
          "The window system keeps Alt and drag for itself. Orbit with the middle button, or with "
          "the orbit tool (V).");
  }
  bool is_news = session_.update(Window::now());
  is_news |= window_->take_damage();
  is_news |= std::exchange(needs_another_frame_, false);
  is_news |= window_->input().has_pending();
  is_news |= wants_text_ && Window::now() - last_frame_ >= kCaretBlinkSeconds;
  return is_news;
}

ViewportPlace Application::place_of(const ui::WindowRect& viewport) const {
  const double density = window_->density();
  const ui::ViewportHalves halves = ui::viewport_halves(viewport, session_.is_split());
  const ui::WindowRect& first = halves.first;
  ViewportPlace place{first,
                      {std::max(static_cast<int>(std::lround(first.size.width * density)), 1),
                       std::max(static_cast<int>(std::lround(first.size.height * density)), 1)}};
  if (halves.second) {
    place.second = halves.second->origin;
  }
  return place;
}

std::optional<ui::WindowPoint> Application::mend_marker(const ui::Model& model) const {
  if (!model.mend_focus) {
    return std::nullopt;
  }
  // The near plane does not count: what was dropped may lie outside of the mesh.
  const render::Camera camera = ViewportScene::camera(session_, place_.size);
  const glm::dvec4 clip = camera.view_projection * glm::dvec4(model.mend_focus->position, 1.0);
  if (clip.w <= 0.0) {
    return std::nullopt;
  }
  const ui::WindowRect& place = place_.rect;
  return ui::WindowPoint{place.origin.x + (0.5 + 0.5 * clip.x / clip.w) * place.size.width,
                         place.origin.y + (0.5 - 0.5 * clip.y / clip.w) * place.size.height};
}

void Application::frame() {
  gui_.set_scale(scale());
  imgui_renderer_->set_atlas(gui_.atlas(), gui_.atlas_revision());

  const ui::InputFrame input = window_->input().next_frame();
  ui::Model model = session_.model();
  const double now = Window::now();
  model.frame_seconds = now - last_frame_;
  last_frame_ = now;
  model.mend_marker = mend_marker(model);
  const ui::GuiFrame gui = gui_.frame(model, input, window_->size());

  place_ = place_of(gui.viewport);
  const auto before = session_.document().revisions;
  for (const ui::Action& action : gui.actions) {
    session_.perform(action);
  }
  place_ = place_of(gui.viewport);  // It may have been split.
  session_.set_aspect(place_.size.aspect());
  sync_scene();
  ScenePicker picker(*scene_, session_, place_.size);
  controller_.update(gui.viewport_input, place_, session_, picker);
  sync_scene();

  draw(place_);
  window_->set_title(session_.title());
  window_->set_cursor(gui.cursor);
  if (const auto path = session_.take_screenshot_request()) {
    take_screenshot(*path);
    needs_another_frame_ = true;
  }
  window_->swap_buffers();

  // The panels have shown the state before these actions.
  const auto& after = session_.document().revisions;
  const bool is_changed = before.control != after.control || before.depths != after.depths ||
                          before.stage != after.stage || !gui.actions.empty();
  needs_another_frame_ |= gui.needs_another_frame || is_changed;
  wants_text_ = gui.wants_text;
}

void Application::sync_scene() {
  if (const auto synced = scene_->sync(session_); !synced) {
    if (sync_problem_ != synced.error().message) {
      sync_problem_ = synced.error().message;
      toast(ui::Toast::Kind::kProblem, sync_problem_);
    }
  }
}

void Application::draw(const ViewportPlace& place) {
  const render::FramebufferSize framebuffer = window_->framebuffer_size();
  const ui::Scale scale = this->scale();
  scene_->draw(session_, place.size,
               {controller_.ring(), controller_.highlighted(), session_.hover_edge(),
                scale.interface * scale.density});
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, framebuffer.width, framebuffer.height);
  glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
  const auto lower_left = [&](const ui::WindowPoint& upper_left) {
    const auto left = static_cast<int>(std::lround(upper_left.x * scale.density));
    const auto top = static_cast<int>(std::lround(upper_left.y * scale.density));
    return glm::ivec2(left, framebuffer.height - top - place.size.height);
  };
  scene_->present(lower_left(place.rect.origin));
  if (place.second) {
    scene_->present_second(lower_left(*place.second));
  }
  imgui_renderer_->draw(gui_.draw_data());
}

void Application::take_screenshot(const std::filesystem::path& path) {
  const render::FramebufferSize size = window_->framebuffer_size();
  render::Image image({size.width, size.height});
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glReadBuffer(GL_BACK);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  for (int y = 0; y < size.height; ++y) {
    glReadPixels(0, size.height - 1 - y, size.width, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                 image.pixel(0, y));
  }
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
    image.rgba[i] = 255;
  }
  session_.report_screenshot(path, render::write_png(path, image));
}

void Application::write_status() const {
  const Result<void> written = write_status_file(
      status_file_, {session_, gui_.items(), place_, window_->size(), window_->framebuffer_size(),
                     ViewportScene::camera(session_, place_.size)});
  static_cast<void>(written);
}

Preferences Application::preferences() const {
  Preferences all;
  all.display = session_.display();
  all.keymap = session_.keymap();
  all.navigation = session_.navigation();
  all.brush_radius = session_.brush().radius;
  all.dihedral_threshold = session_.dihedral_threshold();
  all.crease_sharpness = session_.crease_sharpness();
  all.face_budget = session_.refinement().face_budget();
  all.layout = gui_.layout();
  const double interface = scale().interface;
  const ui::WindowSize size = window_->size();
  all.window = {std::round(size.width / interface), std::round(size.height / interface)};
  all.is_maximised = window_->is_maximised();
  all.recent_files = session_.recent_files();
  return all;
}

}  // namespace limn::app
