#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/desktop_dialog.h"
#include "app/imgui_renderer.h"
#include "app/preferences.h"
#include "app/session.h"
#include "app/viewport_controller.h"
#include "app/viewport_scene.h"
#include "limn/document/project_file.h"
#include "render/coordinates.h"
#include "render/image.h"
#include "ui/gui.h"
#include "ui/input.h"

namespace limn::app {

/// What the program is shown on.
struct Screen {
  ui::WindowSize window;  ///< In the units of cursor positions.
  render::FramebufferSize framebuffer;
  ui::Scale scale;

  [[nodiscard]] bool operator==(const Screen&) const = default;
};

/// What a workbench cannot do by itself.
struct WorkbenchHost {
  /// Ends the wait for input; called from any thread. Must be set.
  std::function<void()> wake;
  ui::FontFiles fonts{};
  std::function<std::string()> read_clipboard{};
  std::function<void(std::string)> write_clipboard{};
  /// As of SessionHost.
  std::filesystem::path recovery_folder{};
  std::function<bool(const DialogRequest&)> ask_desktop{};
  std::function<void()> close_desktop_dialog{};
  std::function<std::string()> wall_clock{};
  FileAccess* files = nullptr;
  Arrivals* arrivals = nullptr;
};

/// The whole program between what a person does and what is to be seen: panels, viewport, session.
/// It has no window and no clock: whoever owns one (application.h), or plays back what was done in
/// one, hands it input, time and a framebuffer.
class Workbench {
 public:
  /// No OpenGL yet: `build_graphics` comes before the first frame.
  Workbench(WorkbenchHost host, const Preferences& preferences, Project project,
            const Screen& screen);
  ~Workbench();
  Workbench(const Workbench&) = delete;
  Workbench& operator=(const Workbench&) = delete;

  /// Everything that is drawn with, made in the current context. Throws render::EnvironmentError.
  void build_graphics();
  /// What belongs to a context goes before it does.
  void drop_graphics() noexcept;
  /// Does without the refined meshes there are now: the graphics card does not hold them.
  void leave_out_refined() { scene_->leave_out_refined(session_); }

  /// What came from outside since the last call.
  struct News {
    std::vector<std::filesystem::path> dropped_files;
    bool close_requested = false;
    bool moved_under_alt = false;  ///< The window system keeps Alt and drag for itself.
    std::optional<DesktopDialog::Answer> chosen{};  ///< In the dialog of the desktop.
  };
  /// Lets time pass and takes in news, of other threads too; `now` in seconds, never falling. True
  /// where there is something new to show.
  bool take_news(const News& news, double now);

  struct Frame {
    ui::CursorShape cursor = ui::CursorShape::kArrow;
    bool wants_text = false;           ///< A text field has the keyboard.
    bool needs_another_frame = false;  ///< Not settled: another one at once.
    std::vector<ui::Action> actions;   ///< Asked for by keys and controls.
    bool took_picture = false;         ///< A screenshot was written.
  };
  /// Turns one frame's input into actions and strokes and draws what came of it into a framebuffer
  /// (0: the window's) of the screen's size. Throws render::EnvironmentError.
  Frame frame(const ui::InputFrame& input, const Screen& screen, double now,
              GLuint framebuffer = 0);

  /// The last frame is on the screen, at this time.
  void note_shown(double now);
  /// From the last move of the brush to the picture of the refined mesh that followed, in seconds;
  /// nothing before the first.
  [[nodiscard]] std::optional<double> stroke_seconds() const noexcept { return stroke_seconds_; }

  /// Changes what the panels are told, so that nothing in a picture depends on the machine.
  void adjust_model(std::function<void(ui::Model&)> adjust) { adjust_ = std::move(adjust); }

  [[nodiscard]] Session& session() noexcept { return session_; }
  [[nodiscard]] const Session& session() const noexcept { return session_; }
  [[nodiscard]] ui::Gui& gui() noexcept { return gui_; }
  [[nodiscard]] const ui::Gui& gui() const noexcept { return gui_; }
  [[nodiscard]] ViewportScene& scene() noexcept { return *scene_; }
  /// The pixels of the viewport's first half as they were drawn last, without what lies over them.
  [[nodiscard]] render::Image viewport_picture() const { return scene_->picture(); }
  /// Of the last frame.
  [[nodiscard]] const ViewportPlace& place() const noexcept { return place_; }
  /// What is to be kept for the next run; size and state of the window are the owner's to add.
  [[nodiscard]] Preferences preferences() const;

 private:
  void sync_scene();
  void draw(const Screen& screen, GLuint framebuffer);
  [[nodiscard]] ViewportPlace place_of(const ui::WindowRect& viewport, double density) const;
  /// Where the mended element or flaw shows that the person was led to, by the last frame's place.
  [[nodiscard]] std::optional<ui::WindowPoint> mend_marker(const ui::Model& model) const;

  // In this order: everything drawn goes before the session whose meshes it draws.
  ui::Gui gui_;
  Session session_;
  ViewportController controller_;
  std::unique_ptr<ImguiRenderer> imgui_renderer_;
  std::unique_ptr<ViewportScene> scene_;

  std::function<void(ui::Model&)> adjust_;
  ViewportPlace place_;      ///< Of the last frame.
  double last_frame_ = 0.0;  ///< When it was, in seconds.
  /// A painting that is not shown refined yet, and when it was painted.
  struct Painted {
    std::uint64_t depths = 0;
    double time = 0.0;
  };
  std::optional<Painted> awaited_;  ///< The first of those.
  Painted newest_;
  std::optional<double> stroke_seconds_;
  std::string sync_problem_;  ///< Said once.
};

/// The pixels of a framebuffer (0: the window's, before it is shown), opaque.
[[nodiscard]] render::Image read_framebuffer(render::FramebufferSize size, GLuint framebuffer = 0);

}  // namespace limn::app
