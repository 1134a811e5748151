// One frame: panels, actions, the mouse in the viewport, uploads, drawing.
#include "app/workbench.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glad/gl.h>
#include <imgui.h>

#include "render/environment_error.h"

namespace limn::app {
namespace {

/// Answers the controller from the scene, for the session's view and a viewport of this size.
class ScenePicker final : public ViewportPicker {
 public:
  ScenePicker(ViewportScene& scene, const Session& session, render::FramebufferSize size)
      : scene_(scene), session_(session), size_(size) {}

  [[nodiscard]] std::optional<render::PickedFace> pick(render::FramebufferPoint point) override {
    return scene_.pick(session_, size_, point);
  }
  [[nodiscard]] std::vector<std::uint32_t> faces_in(const render::ScreenRegion& region,
                                                    Reach reach) override {
    return scene_.faces_in(session_, size_, region, reach);
  }
  [[nodiscard]] ShownFaces shown_faces_in(const render::ScreenRegion& region,
                                          Reach reach) override {
    return scene_.shown_faces_in(session_, size_, region, reach);
  }

 private:
  ViewportScene& scene_;
  const Session& session_;
  render::FramebufferSize size_;
};

}  // namespace

Workbench::Workbench(WorkbenchHost host, const Preferences& preferences, Project project,
                     const Screen& screen)
    : gui_(std::move(host.fonts), screen.scale),
      session_({.wake = std::move(host.wake),
                .visible_faces = [this]() -> Result<std::vector<std::uint32_t>> {
                  sync_scene();
                  return scene_->visible_faces(session_, place_.size);
                },
                .screen_view =
                    [this](const ViewState& view) {
                      return render::screen_view(render::make_camera(
                          view, session_.document().control->bounds(), place_.size));
                    },
                .recovery_folder = std::move(host.recovery_folder),
                .files = host.files,
                .ask_desktop = std::move(host.ask_desktop),
                .close_desktop_dialog = std::move(host.close_desktop_dialog),
                .wall_clock = std::move(host.wall_clock),
                .arrivals = host.arrivals}) {
  gui_.set_layout(preferences.layout);
  gui_.set_clipboard(std::move(host.read_clipboard), std::move(host.write_clipboard));
  session_.restore(preferences.display, preferences.keymap, preferences.brush,
                   preferences.dihedral_threshold);
  session_.set_navigation(preferences.navigation);
  session_.set_crease_sharpness(preferences.crease_sharpness);
  session_.set_uses_desktop_dialogs(preferences.uses_desktop_dialogs);
  session_.show_hints(preferences.shows_hints);
  session_.set_recent_files(preferences.recent_files);
  session_.set_face_budget(preferences.face_budget);
  session_.restore(preferences.auto_depth, preferences.presets);
  session_.show(std::move(project));
}

Workbench::~Workbench() = default;

void Workbench::build_graphics() {
  imgui_renderer_ = std::make_unique<ImguiRenderer>();
  scene_ = std::make_unique<ViewportScene>();
}

void Workbench::drop_graphics() noexcept {
  scene_.reset();
  imgui_renderer_.reset();
}

bool Workbench::take_news(const News& news, double now) {
  for (const std::filesystem::path& file : news.dropped_files) {
    session_.perform({ui::ActionId::kOpen, file.string()});
  }
  if (news.chosen) {
    session_.answer_dialog(news.chosen->purpose, news.chosen->path);
  }
  if (news.close_requested) {
    session_.perform(ui::ActionId::kQuit);
  }
  if (news.moved_under_alt) {
    session_.toast(ui::Toast::Kind::kNote,
                   "The window system keeps Alt and drag for itself. Orbit with the middle button, "
                   "or with the orbit tool (V).");
  }
  return session_.update(now);
}

ViewportPlace Workbench::place_of(const ui::WindowRect& viewport, double density) const {
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

std::optional<ui::WindowPoint> Workbench::mend_marker(const ui::Model& model) const {
  if (!model.mend_focus && !model.flaw_focus) {
    return std::nullopt;
  }
  const glm::dvec3& spot =
      model.mend_focus ? model.mend_focus->position : model.flaw_focus->position;
  // The near plane does not count: what was dropped may lie outside of the mesh.
  const render::Camera camera = ViewportScene::camera(session_, place_.size);
  const glm::dvec4 clip = camera.view_projection * glm::dvec4(spot, 1.0);
  if (clip.w <= 0.0) {
    return std::nullopt;
  }
  const ui::WindowRect& place = place_.rect;
  return ui::WindowPoint{place.origin.x + (0.5 + 0.5 * clip.x / clip.w) * place.size.width,
                         place.origin.y + (0.5 - 0.5 * clip.y / clip.w) * place.size.height};
}

Workbench::Frame Workbench::frame(const ui::InputFrame& input, const Screen& screen, double now,
                                  GLuint framebuffer) {
  gui_.set_scale(screen.scale);
  imgui_renderer_->set_atlas(gui_.atlas(), gui_.atlas_revision());

  ui::Model model = session_.model();
  model.frame_seconds = now - last_frame_;
  model.stroke_seconds = stroke_seconds_;
  last_frame_ = now;
  model.mend_marker = mend_marker(model);
  if (adjust_) {
    adjust_(model);
  }
  ui::GuiFrame gui = gui_.frame(model, input, screen.window);

  place_ = place_of(gui.viewport, screen.scale.density);
  const auto before = session_.document().revisions;
  for (const ui::Action& action : gui.actions) {
    session_.perform(action);
  }
  place_ = place_of(gui.viewport, screen.scale.density);  // It may have been split.
  session_.set_aspect(place_.size.aspect());
  sync_scene();
  ScenePicker picker(*scene_, session_, place_.size);
  const bool was_stroking = session_.is_stroking();  // A fine stroke paints when it ends.
  controller_.update(gui.viewport_input, place_, session_, picker);
  session_.begin_refining();
  if ((was_stroking || session_.is_stroking()) &&
      session_.document().revisions.depths != newest_.depths) {
    newest_ = {session_.document().revisions.depths, std::min(input.time, now)};
    if (!awaited_) {
      awaited_ = newest_;
    }
  }
  sync_scene();
  draw(screen, framebuffer);

  const bool is_asked = !gui.actions.empty();
  Frame frame{gui.cursor, gui.wants_text, gui.needs_another_frame, std::move(gui.actions)};
  if (const auto path = session_.take_screenshot_request()) {
    session_.write_screenshot(*path, read_framebuffer(screen.framebuffer, framebuffer));
    frame.needs_another_frame = true;
    frame.took_picture = true;
  }
  // The panels have shown the state before these actions.
  const auto& after = session_.document().revisions;
  frame.needs_another_frame |= before.control != after.control || before.depths != after.depths ||
                               before.stage != after.stage || is_asked;
  return frame;
}

void Workbench::note_shown(double now) {
  const std::uint64_t shown = session_.shows_refined() ? session_.refinement().refined_depths() : 0;
  if (!awaited_ || shown < awaited_->depths) {
    return;
  }
  stroke_seconds_ = now - awaited_->time;
  awaited_ = shown < newest_.depths ? std::optional(newest_) : std::nullopt;
}

void Workbench::sync_scene() {
  if (const auto synced = scene_->sync(session_); !synced) {
    if (sync_problem_ != synced.error().message) {
      sync_problem_ = synced.error().message;
      session_.toast(ui::Toast::Kind::kProblem, sync_problem_);
    }
  }
}

void Workbench::draw(const Screen& screen, GLuint framebuffer) {
  const ui::Scale& scale = screen.scale;
  scene_->draw(session_, place_.size,
               {controller_.ring(), controller_.outline(), controller_.highlighted(),
                session_.hover_edge(), scale.interface * scale.density, controller_.lit()});
  const auto start = [&] {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, screen.framebuffer.width, screen.framebuffer.height);
  };
  start();
  glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
  const auto lower_left = [&](const ui::WindowPoint& upper_left) {
    const auto left = static_cast<int>(std::lround(upper_left.x * scale.density));
    const auto top = static_cast<int>(std::lround(upper_left.y * scale.density));
    return glm::ivec2(left, screen.framebuffer.height - top - place_.size.height);
  };
  scene_->present(lower_left(place_.rect.origin), framebuffer);
  if (place_.second) {
    scene_->present_second(lower_left(*place_.second), framebuffer);
  }
  start();
  imgui_renderer_->draw(gui_.draw_data());
}

Preferences Workbench::preferences() const {
  Preferences all;
  all.display = session_.display();
  all.keymap = session_.keymap();
  all.navigation = session_.navigation();
  all.brush = session_.brush();
  all.dihedral_threshold = session_.dihedral_threshold();
  all.crease_sharpness = session_.crease_sharpness();
  all.uses_desktop_dialogs = session_.uses_desktop_dialogs();
  all.shows_hints = session_.shows_hints();
  all.face_budget = session_.refinement().face_budget();
  all.auto_depth = session_.auto_depth().settings();
  all.auto_depth.is_live = false;
  all.presets = session_.auto_depth().presets();
  all.layout = gui_.layout();
  all.recent_files = session_.recent_files();
  return all;
}

render::Image read_framebuffer(render::FramebufferSize size, GLuint framebuffer) {
  render::Image image({size.width, size.height});
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glReadBuffer(framebuffer == 0 ? GL_BACK : GL_COLOR_ATTACHMENT0);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  for (int y = 0; y < size.height; ++y) {
    glReadPixels(0, size.height - 1 - y, size.width, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                 image.pixel(0, y));
  }
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
    image.rgba[i] = 255;
  }
  return image;
}

}  // namespace limn::app
