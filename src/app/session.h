#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/auto_depth/auto_depth.h"
#include "app/autosave.h"
#include "app/camera_motion.h"
#include "app/desktop_dialog.h"
#include "app/distance_job.h"
#include "app/export_job.h"
#include "app/file_access.h"
#include "app/legalisation_stepper.h"
#include "app/live_refinement.h"
#include "app/mesh_facts.h"
#include "app/paint_tools/fine_stroke.h"
#include "app/paint_tools/forecast_job.h"
#include "app/paint_tools/mesh_aids.h"
#include "app/scheme_facts.h"
#include "app/sphere_job.h"
#include "app/toasts.h"
#include "limn/document/document.h"
#include "limn/document/history.h"
#include "limn/document/project_file.h"
#include "limn/painting/crease_rule.h"
#include "limn/painting/paint_rule.h"
#include "limn/painting/stroke.h"
#include "ui/action.h"
#include "ui/model.h"

namespace limn {
struct Painting;
}

namespace limn::app {

/// What a session cannot do by itself.
struct SessionHost {
  /// Ends the main loop's wait; called from any thread. Must be set.
  std::function<void()> wake;
  /// Answers "visible" for the camera in force. Empty without a screen: those actions then fail
  /// with a toast.
  VisibleFaces visible_faces;
  /// What a camera of the document sees, as large as the viewport is. Empty without a screen.
  std::function<ScreenView(const ViewState&)> screen_view{};
  /// Where copies of unsaved work are kept (recovery_store.h). Empty: nowhere.
  std::filesystem::path recovery_folder{};
  /// What is read and written; must outlive the session. Null: the disk.
  FileAccess* files = nullptr;
  /// Opens a dialog of the desktop; false where there is none. Its answer comes by
  /// `answer_dialog`. Empty: there is none.
  std::function<bool(const DialogRequest&)> ask_desktop{};
  std::function<void()> close_desktop_dialog{};
  /// What the clock on the wall says, "14:05": for telling when a copy was kept. Empty: nothing is
  /// told of copies, as in what is recorded to be played back at another time.
  std::function<std::string()> wall_clock{};
  /// When news of other threads are taken in; must outlive the session. Null: as they come.
  Arrivals* arrivals = nullptr;
};

/// One run of the program at work on one document at a time: everything but the window.
///
/// `perform` is the one place where an action becomes a command; menus, buttons, keys, tests and
/// played-back input all come through it. Nothing here waits, draws or reads the mouse.
class Session {
 public:
  explicit Session(SessionHost host);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Carries out an action. What comes of it, a dialog or toast included, shows in the model.
  void perform(const ui::Action& action);
  /// Lets time pass and takes in what other threads have done. `now` in seconds, never falling.
  /// Returns true where there is something new to show.
  bool update(double now);
  /// Has workers begin with what has changed since `update`, while the frame is drawn.
  void begin_refining() { refinement_.follow(document_, wish()); }
  /// When `update` next has something to do of its own accord; infinity where it waits for others.
  [[nodiscard]] double next_update() const noexcept;

  /// The person has chosen a file in the dialog of the desktop; an empty path: none.
  void answer_dialog(ui::PathPrompt::Purpose purpose, const std::filesystem::path& path);

  /// Shows a document that was read before the session began. Asks nothing.
  void show(Project project);
  void toast(ui::Toast::Kind kind, std::string text);
  /// Asks about work that killed runs have left, one after the other.
  void offer(std::vector<LostWork> lost);
  /// Blocks until copies of unsaved work are on disk. For tests.
  void finish_autosave() { autosave_.wait_until_idle(); }

  /// The state of everything for one frame of the panels; spans and pointers live until the next
  /// call of a non-const member.
  [[nodiscard]] ui::Model model() const;
  /// "creature.limn *": for the window's title.
  [[nodiscard]] std::string title() const;

  [[nodiscard]] const Document& document() const noexcept { return document_; }
  [[nodiscard]] const History& history() const noexcept { return history_; }
  [[nodiscard]] const LiveRefinement& refinement() const noexcept { return refinement_; }
  /// The scheme in the second half of the viewport; its `refined` is null where that half shows the
  /// control mesh.
  [[nodiscard]] const LiveRefinement& second() const noexcept { return second_; }
  /// Irregular vertices of what either half shows; empty unless they are to be seen.
  [[nodiscard]] const ShownValences& valences() const noexcept { return valences_; }
  [[nodiscard]] const ShownValences& second_valences() const noexcept { return second_valences_; }
  /// How far the faces of the refined mesh shown are from its limit surface; its `distance` is null
  /// where that is not known.
  [[nodiscard]] const DistanceJob& distance() const noexcept { return distance_; }
  /// What depths are chosen by.
  [[nodiscard]] const AutoDepth& auto_depth() const noexcept { return auto_depth_; }
  [[nodiscard]] const LegalisationStepper& steps() const noexcept { return steps_; }
  [[nodiscard]] const ui::DisplaySettings& display() const noexcept { return display_; }
  [[nodiscard]] const ui::BrushSettings& brush() const noexcept { return brush_; }
  [[nodiscard]] const ui::Modal& modal() const noexcept { return modal_; }
  [[nodiscard]] std::span<const ui::Toast> toasts() const noexcept { return toasts_.shown(); }
  [[nodiscard]] ui::KeymapId keymap() const noexcept { return keymap_; }
  [[nodiscard]] const ui::NavigationSettings& navigation() const noexcept { return navigation_; }
  [[nodiscard]] double dihedral_threshold() const noexcept { return dihedral_threshold_; }
  [[nodiscard]] double crease_sharpness() const noexcept { return crease_sharpness_; }
  [[nodiscard]] const std::vector<std::string>& recent_files() const noexcept { return recent_; }
  /// Whether the viewport shows the refined mesh: it is asked for and there is one.
  [[nodiscard]] bool shows_refined() const noexcept;
  /// Whether the viewport has two halves, and whether the second shows a refined mesh.
  [[nodiscard]] bool is_split() const noexcept { return display_.second.has_value(); }
  [[nodiscard]] bool shows_second_refined() const noexcept;
  /// Whether anything is being worked out on another thread.
  [[nodiscard]] bool is_busy() const {
    return refinement_.is_busy() || second_.is_busy() || sphere_.is_busy() || distance_.is_busy() ||
           exports_.is_busy() || auto_depth_.is_busy();
  }
  /// Blocks until the refined mesh is up to date, and the file that is exported written. For tests
  /// and for work without a window.
  void finish_refinement();

  /// Chosen in an earlier run.
  void restore(const ui::DisplaySettings& display, ui::KeymapId keymap,
               const ui::BrushSettings& brush, double dihedral_threshold);
  void set_navigation(const ui::NavigationSettings& navigation) { navigation_ = navigation; }
  void set_crease_sharpness(double sharpness) noexcept { crease_sharpness_ = sharpness; }
  void set_uses_desktop_dialogs(bool uses) noexcept { uses_desktop_dialogs_ = uses; }
  void restore(ui::AutoDepthSettings settings, std::vector<RulePreset> presets);
  [[nodiscard]] bool uses_desktop_dialogs() const noexcept { return uses_desktop_dialogs_; }
  void show_hints(bool shows) { hints_ = shows ? std::optional(ui::HintCard{}) : std::nullopt; }
  [[nodiscard]] bool shows_hints() const noexcept { return hints_.has_value(); }
  [[nodiscard]] const ui::CopyStatus& copies() const noexcept { return copies_; }
  void set_recent_files(std::vector<std::string> files) { recent_ = std::move(files); }
  /// For tests: instead of what the machine can spare.
  void set_memory_budget(std::uint64_t bytes) noexcept { refinement_.set_memory_budget(bytes); }
  void set_face_budget(std::uint64_t faces) noexcept { refinement_.set_face_budget(faces); }

  [[nodiscard]] const ViewState& view() const noexcept { return camera_.view(); }
  /// Moves the camera at once: the mouse does.
  void set_view(const ViewState& view);
  /// Width over height of the viewport.
  void set_aspect(double aspect);
  /// The control face under the cursor.
  void set_hover(std::optional<std::uint32_t> face) noexcept { hover_ = face; }
  [[nodiscard]] std::optional<std::uint32_t> hover() const noexcept { return hover_; }

  /// The control edge under the cursor, one of the hovered face's.
  void set_hover_edge(std::optional<std::uint32_t> edge) noexcept { hover_edge_ = edge; }
  [[nodiscard]] std::optional<std::uint32_t> hover_edge() const noexcept { return hover_edge_; }

  /// A stroke: painted live, one command when it ends, "paint 12 faces".
  void begin_stroke(DepthChange change, std::string name = "paint");
  /// Paints faces and, where the brush mirrors, their images. Returns true where a depth changed.
  bool touch(std::span<const std::uint32_t> faces);
  void end_stroke();
  void give_up_stroke();
  [[nodiscard]] bool is_stroking() const noexcept {
    return stroke_.has_value() || fine_stroke_.has_value();
  }

  /// Whether the tool in hand paints on faces of the refined mesh shown. session_fine.cpp, as what
  /// follows it.
  [[nodiscard]] bool paints_fine() const noexcept;
  /// A stroke over faces of the refined mesh, which changes the document when it ends, as one
  /// command, "paint 12 finer faces". Until then no other refined mesh is taken in.
  void begin_fine_stroke(DepthChange change, std::string name = "paint");
  /// Takes in faces that were touched. Returns true where any is new.
  bool touch(const ShownFaces& shown);
  /// What a fine stroke has touched so far; null where there is none.
  [[nodiscard]] const ShownFaces* touched() const noexcept {
    return fine_stroke_ ? &fine_stroke_->touched() : nullptr;
  }
  /// The faces and, where the brush mirrors, their images.
  [[nodiscard]] ShownFaces with_images(const ShownFaces& shown);
  /// As `propose` below.
  void propose(const ShownFaces& shown, DepthChange change);
  /// The face of the refined mesh under the cursor, by name.
  void set_hover_name(std::optional<FineFace> name) noexcept { hover_name_ = name; }

  /// What the fill in hand takes with this face. session_tools.cpp, as what follows it.
  [[nodiscard]] std::vector<std::uint32_t> fill_region(std::uint32_t seed);
  /// The faces and, where the brush mirrors, their images.
  [[nodiscard]] std::vector<std::uint32_t> with_images(std::span<const std::uint32_t> faces);
  /// What a click would do: the forecast in the model tells what it would cost, as soon as that is
  /// known.
  void propose(std::span<const std::uint32_t> faces, DepthChange change);
  void withdraw_proposal();
  [[nodiscard]] std::optional<ui::PaintForecast> forecast() const;
  /// Blocks until the forecast is known. For tests.
  void finish_forecast();

  /// Where the next frame shall be written as a picture, once.
  [[nodiscard]] std::optional<std::filesystem::path> take_screenshot_request();
  void write_screenshot(const std::filesystem::path& path, const render::Image& image);
  [[nodiscard]] bool wants_to_quit() const noexcept { return wants_to_quit_; }

 private:
  void carry_out(const ui::Action& action);
  // Each carries out the actions of its kind and returns false for all others.
  bool perform_edit(const ui::Action& action);
  bool perform_program(const ui::Action& action);
  bool perform_answer(const ui::Action& action);
  bool perform_recovery(const ui::Action& action);    // session_recovery.cpp, as what follows it
  bool perform_file(const ui::Action& action);        // session_files.cpp, as what follows it
  bool perform_rule(const ui::Action& action);        // session_painting.cpp
  bool perform_auto_depth(const ui::Action& action);  // session_auto_depth.cpp
  bool perform_depth_choice(const ui::Action& action);
  bool perform_preset(const ui::Action& action);
  bool perform_creases(const ui::Action& action);
  bool perform_subdivision(const ui::Action& action);
  bool perform_brush(const ui::Action& action);  // session_tools.cpp, as what follows it
  bool perform_tool(const ui::Action& action);
  bool perform_fine(const ui::Action& action);  // session_fine.cpp, as what follows it
  void clear_fine();
  [[nodiscard]] Painting painting() const;
  [[nodiscard]] std::vector<FineFace> fine_faces(const ShownFaces& shown);
  void end_fine_stroke();
  [[nodiscard]] std::optional<ui::FineHover> fine_hover() const;
  /// Its radius, or what stands for it with the tool in hand.
  void size_brush(int steps);
  bool perform_steps(const ui::Action& action);  // session_steps.cpp
  void seek_step(std::size_t position);
  void look_at_step();
  void follow_steps();
  bool perform_scheme(const ui::Action& action);  // session_schemes.cpp, as what follows it
  bool perform_scheme_choice(const ui::Action& action);
  bool perform_edge(const ui::Action& action);
  bool perform_display(const ui::Action& action);  // session_view.cpp
  bool perform_camera(const ui::Action& action);
  bool perform_navigation(const ui::Action& action);
  bool set_material(ui::Material material);
  bool perform_report(const ui::Action& action);  // session_report.cpp, as what follows it
  bool perform_flaw(const ui::Action& action);
  bool perform_measurement(const ui::Action& action);  // session_distance.cpp

  void recover();
  void ask_about_lost_work();
  /// Keeps copies of unsaved work; returns true where there is something new to show.
  bool follow_autosave();
  bool follow_copies();
  /// The person has done one of the things that the card of hints tells; it goes with the last.
  void learn(bool ui::HintCard::*what);

  void execute(std::unique_ptr<Command> command);
  void cancel();
  void show_error(std::string title, Error error);

  /// True where the action may go on; otherwise it is kept and the person is asked.
  [[nodiscard]] bool may_lose_changes(const ui::Action& action, std::string next);
  void open(const std::string& name);
  void save(const std::filesystem::path& path);
  void replace_mesh(const std::filesystem::path& path);
  /// Among the recent files, and its folder as the one to look in next.
  void remember_file(const std::filesystem::path& path);
  void go_on();
  void start_export(const std::filesystem::path& path);
  void write_export();
  bool report_export();
  [[nodiscard]] std::array<std::string, MeshFormats.size()> export_losses() const;
  void ask_for_path(ui::PathPrompt::Purpose purpose);
  /// The same in our own prompt, with a name of its own where that is not empty.
  void prompt_for_path(ui::PathPrompt::Purpose purpose, const std::string& name = {});
  [[nodiscard]] std::string suggested_name(ui::PathPrompt::Purpose purpose) const;

  void paint(const PaintRule& rule, const std::string& what);
  /// Begins to choose depths: one step, in place of the last where that was live and still is what
  /// is painted.
  void choose_depths();
  void paint_chosen(PlannedPaint plan);
  void set_depth_rule(ChooseDepths choose);
  void set_depth_within(const std::string& selection);
  /// The panel has been changed: the painting follows where it is live.
  void auto_depth_changed() { wants_depths_ = wants_depths_ || auto_depth_.settings().is_live; }
  bool follow_auto_depth();
  [[nodiscard]] bool replaces_chosen() const noexcept;
  [[nodiscard]] bool shows_chosen() const noexcept;
  [[nodiscard]] std::map<std::string, ScreenView> screen_views() const;
  [[nodiscard]] std::optional<AutoDepth::Measured> measured_faces() const;
  [[nodiscard]] ui::AutoDepthStatus auto_depth_status() const;
  void crease(const CreaseRule& rule, std::string_view nothing);
  void set_stage(Stage stage, std::string name);
  void change_settings(const SubdivisionSettings& settings);
  void apply_refined();

  void show_scheme(std::optional<SchemeSettings> scheme);
  void change_scheme(const SchemeSettings& scheme);
  void step_to(int level);
  /// To the level that is there, where the one asked for would be too large.
  void step_back_to_shown();
  void edit_edge(Result<std::unique_ptr<Command>> edit);
  [[nodiscard]] SphereJob::Question sphere_question() const;
  void compare_with_sphere();
  /// What of the refined mesh shown can be measured; nothing where there is no limit surface to
  /// hold it against.
  [[nodiscard]] std::optional<DistanceJob::Question> distance_question() const;
  [[nodiscard]] ui::DistanceStatus distance_status() const;
  void follow_distance();
  /// What follows from document and display: facts, the second half, valences.
  void update_facts();
  void show_second(std::optional<SchemeSettings> scheme, bool is_uniform);
  void follow_second();
  [[nodiscard]] ui::SchemeStatus scheme_status() const;
  [[nodiscard]] ui::SecondStatus second_status() const;
  [[nodiscard]] int second_levels() const noexcept;
  /// As a stage's: how far the refined mesh that is shown goes.
  [[nodiscard]] int shown_levels() const noexcept;
  [[nodiscard]] LiveRefinement::Wish wish() const noexcept;

  void frame_faces(std::span<const std::uint32_t> faces);
  void zoom(double factor);

  SessionHost host_;
  FileAccess& files_;
  double now_ = 0.0;
  Document document_;
  History history_;
  LiveRefinement refinement_;
  LiveRefinement second_;
  SphereJob sphere_;
  DistanceJob distance_;
  AutoDepth auto_depth_;
  ExportJob exports_;
  ForecastJob forecast_;
  bool was_busy_ = false;  ///< At the last update.
  MeshFacts facts_;
  SchemeFacts scheme_facts_;
  SchemeFacts second_facts_;
  ShownLevels levels_;
  LegalisationStepper steps_;
  ShownValences valences_;
  ShownValences second_valences_;

  ui::DisplaySettings display_;
  ui::BrushSettings brush_;
  ui::KeymapId keymap_ = ui::KeymapId::kOriginal;
  ui::NavigationSettings navigation_;
  double dihedral_threshold_ = 30.0;
  double crease_sharpness_ = 2.0;

  CameraMotion camera_;
  double aspect_ = 1.6;
  bool is_framed_ = true;  ///< False until a new document's default view has met the real aspect.
  std::optional<std::uint32_t> hover_;
  std::optional<std::uint32_t> hover_edge_;
  std::optional<FineFace> hover_name_;
  std::optional<ui::MendFocus> mend_focus_;
  std::optional<ui::FlawFocus> flaw_focus_;
  std::shared_ptr<const ControlMesh> known_control_;  ///< At the last `update_facts`.
  /// Depths that were chosen last.
  struct Chosen {
    Revisions revisions;          ///< Of the document they were painted on, afterwards.
    std::size_t position = 0;     ///< Of the history, afterwards.
    bool is_replaceable = false;  ///< A live choice that made a step of its own.
    FaceDepths before;
    ui::AutoDepthOutcome outcome;
  };
  std::optional<Chosen> chosen_;
  bool wants_depths_ = false;  ///< As soon as nothing stands in the way.
  std::optional<Stroke> stroke_;
  std::string stroke_name_;
  std::optional<FineStroke> fine_stroke_;  ///< At most one of the two.
  MeshAids aids_;
  std::size_t lone_faces_ = 0;                 ///< As in ui::Model.
  std::optional<ui::PaintForecast> proposal_;  ///< Without its cost.

  std::optional<ui::HintCard> hints_;
  ui::CopyStatus copies_;
  std::uint64_t known_copies_ = 0;  ///< Of the autosave's, at the last update.

  ui::Modal modal_;
  std::optional<ui::Action> held_back_;  ///< Waits for the answer about unsaved changes.
  bool may_lose_all_ = false;            ///< While `held_back_` is carried out.
  bool goes_on_after_save_ = false;      ///< `held_back_` follows once saving has worked.
  std::uint64_t prompt_serial_ = 0;
  bool uses_desktop_dialogs_ = true;
  std::filesystem::path last_folder_;
  std::optional<std::filesystem::path> export_path_;  ///< Waits for the refinement.
  std::optional<std::filesystem::path> screenshot_path_;
  bool wants_to_quit_ = false;
  Toasts toasts_;
  Autosave autosave_;
  std::vector<LostWork> lost_;  ///< The person is asked about the last of them.
  std::vector<std::string> recent_;
  std::vector<std::string> bundled_;
};

}  // namespace limn::app
