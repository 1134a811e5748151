// Dispatch, time and the model. The actions themselves are in session_files.cpp,
// session_painting.cpp, session_tools.cpp, session_schemes.cpp and session_view.cpp.
#include "app/session.h"

#include <algorithm>
#include <new>
#include <utility>

#include <fmt/format.h>

#include "limn/contract.h"
#include "limn/document/commands.h"
#include "limn/mesh/bundled.h"
#include "render/named_views.h"

namespace limn::app {

using enum ui::ActionId;
using Kind = ui::Toast::Kind;

Session::Session(SessionHost host)
    : host_(std::move(host)),
      files_(host_.files != nullptr ? *host_.files : disk()),
      refinement_(host_.wake, "refinement", host_.arrivals),
      second_(host_.wake, "second", host_.arrivals),
      sphere_(host_.wake, host_.arrivals),
      distance_(host_.wake, host_.arrivals),
      auto_depth_(host_.wake, host_.arrivals),
      exports_(host_.wake, files_, host_.arrivals),
      forecast_(host_.wake, host_.arrivals),
      autosave_(host_.recovery_folder, host_.wake) {
  LIMN_EXPECTS(host_.wake);
  for (const BundledMesh& mesh : bundled_meshes()) {
    bundled_.emplace_back(mesh.name);
  }
  open(std::string(kDefaultMesh));
  LIMN_EXPECTS(document_.control);
}

Session::~Session() = default;

void Session::perform(const ui::Action& action) {
  try {
    carry_out(action);
  } catch (const std::bad_alloc&) {
    show_error(
        "Not enough memory",
        {ErrorKind::kFailed, "This needs more memory than there is. Nothing was changed.", {}});
  }
}

void Session::carry_out(const ui::Action& action) {
  const bool is_known =
      perform_answer(action) || perform_recovery(action) || perform_program(action) ||
      perform_file(action) || perform_edit(action) || perform_rule(action) ||
      perform_auto_depth(action) || perform_depth_choice(action) || perform_preset(action) ||
      perform_creases(action) || perform_brush(action) || perform_fine(action) ||
      perform_subdivision(action) || perform_steps(action) || perform_scheme(action) ||
      perform_scheme_choice(action) || perform_edge(action) || perform_display(action) ||
      perform_camera(action) || perform_navigation(action) || perform_report(action) ||
      perform_flaw(action) || perform_measurement(action);
  LIMN_EXPECTS(is_known);
  update_facts();
}

bool Session::update(double now) {
  now_ = std::max(now_, now);
  refinement_.follow(document_, wish());
  follow_second();
  // A fine stroke goes by the refined mesh that it began on.
  bool has_news = !fine_stroke_ && refinement_.update();
  has_news |= second_.update();
  has_news |= sphere_.update();
  has_news |= distance_.update();
  has_news |= forecast_.update();
  has_news |= auto_depth_.update();
  if (follow_auto_depth()) {
    refinement_.follow(document_, wish());
    has_news = true;
  }
  if (has_news) {
    update_facts();
  }
  const bool is_busy = this->is_busy();
  has_news |= is_busy || was_busy_;  // The progress bar moves, or goes.
  was_busy_ = is_busy;
  if (auto error = refinement_.take_error()) {
    export_path_.reset();
    show_error("The refinement failed", std::move(*error));
    has_news = true;
  }
  if (auto error = second_.take_error()) {
    toast(Kind::kProblem, std::move(error->message));
    has_news = true;
  }
  if (const auto question = refinement_.question();
      question && std::holds_alternative<std::monostate>(modal_)) {
    modal_ = *question;
    has_news = true;
  }
  if (export_path_ && refinement_.is_up_to_date() && refinement_.refined() != nullptr) {
    write_export();
    has_news = true;
  }
  has_news |= report_export();
  has_news |= follow_autosave();
  has_news |= toasts_.expire(now_);
  has_news |= camera_.update(now_);
  return has_news;
}

double Session::next_update() const noexcept {
  return camera_.is_gliding() ? now_ : std::min(toasts_.next_end(), autosave_.next());
}

int Session::shown_levels() const noexcept {
  const bool follows_painting = display_.live && !document_.scheme && document_.stage.levels == 0;
  return follows_painting && deepest_painting(document_) > 0 ? kAllLevels : document_.stage.levels;
}

LiveRefinement::Wish Session::wish() const noexcept {
  return {is_stroking(), export_path_.has_value() || shown_levels() > 0};
}

void Session::finish_refinement() {
  do {
    LiveRefinement::Wish wanted = wish();
    wanted.is_stroking = false;
    refinement_.follow(document_, wanted);
    refinement_.wait_until_idle();
    follow_second();
    second_.wait_until_idle();
    distance_.wait();
    auto_depth_.wait();
  } while (update(now_) && ((refinement_.is_busy() && !fine_stroke_) || second_.is_busy() ||
                            distance_.is_busy() || auto_depth_.is_busy()));
  exports_.wait_until_idle();
  report_export();
  finish_forecast();
}

void Session::show(Project project) {
  stroke_.reset();
  fine_stroke_.reset();
  auto_depth_.stop_choosing();
  wants_depths_ = false;
  mend_focus_.reset();
  autosave_.clear();
  document_ = std::move(project.document);
  history_.clear();
  history_.mark_saved();
  export_path_.reset();
  update_facts();
  is_framed_ = project.view.has_value();
  camera_.set(project.view ? *project.view
                           : render::default_view(document_.control->positions(), aspect_));
  remember_file(document_.project_path.empty() ? document_.mesh_path : document_.project_path);
  if (const std::size_t kinds = document_.import_report.mends.size(); kinds > 0) {
    const Mend& first = document_.import_report.mends.front();
    toast(Kind::kNote, fmt::format("{}: {}{}", document_.name, sentence_of(first.kind, first.count),
                                   kinds > 1 ? " More in the panel." : ""));
  }
}

void Session::toast(Kind kind, std::string text) {
  toasts_.add(kind, std::move(text), now_);
}

void Session::show_error(std::string title, Error error) {
  modal_ = ui::ErrorDialog{std::move(title), std::move(error)};
}

void Session::restore(const ui::DisplaySettings& display, ui::KeymapId keymap,
                      const ui::BrushSettings& brush, double dihedral_threshold) {
  display_ = display;
  keymap_ = keymap;
  brush_ = brush;
  brush_.tool = keymap == ui::KeymapId::kClassroom ? ui::Tool::kOrbit : ui::Tool::kPaint;
  dihedral_threshold_ = dihedral_threshold;
  update_facts();
}

void Session::execute(std::unique_ptr<Command> command) {
  end_stroke();
  history_.execute(document_, std::move(command));
}

bool Session::perform_edit(const ui::Action& action) {
  switch (action.id) {
    case kUndo:
      end_stroke();
      if (history_.can_undo()) {
        history_.undo(document_);
      } else {
        toast(Kind::kNote, "There is nothing to undo.");
      }
      return true;
    case kRedo:
      end_stroke();
      if (history_.can_redo()) {
        history_.redo(document_);
      } else {
        toast(Kind::kNote, "There is nothing to redo.");
      }
      return true;
    case kGoToStep:
      end_stroke();
      history_.go_to(document_, static_cast<std::size_t>(std::max(std::get<int>(action.value), 0)));
      return true;
    case kRevert:
      end_stroke();
      if (document_.control == document_.opened && document_.depths.deepest() == 0 &&
          document_.demands.empty() && document_.stage == Stage{}) {
        toast(Kind::kNote, "This is the mesh as it was opened.");
      } else {
        execute(revert_command());
        toast(Kind::kDone, fmt::format("Revert: {} is as it was opened.", document_.name));
      }
      return true;
    default:
      return false;
  }
}

bool Session::perform_program(const ui::Action& action) {
  switch (action.id) {
    case kHelp:
      modal_ = ui::HelpSheet{};
      return true;
    case kKeymapOriginal:
      keymap_ = ui::KeymapId::kOriginal;
      navigation_.preset = ui::NavigationPreset::kOriginal;
      brush_.tool = ui::Tool::kPaint;
      return true;
    case kKeymapClassroom:
      keymap_ = ui::KeymapId::kClassroom;
      navigation_.preset = ui::NavigationPreset::kClassroom;
      brush_.tool = ui::Tool::kOrbit;
      return true;
    case kToggleDesktopDialogs: {
      const auto* wanted = std::get_if<bool>(&action.value);
      uses_desktop_dialogs_ = wanted != nullptr ? *wanted : !uses_desktop_dialogs_;
      return true;
    }
    case kToggleHints: {
      const auto* wanted = std::get_if<bool>(&action.value);
      show_hints(wanted != nullptr ? *wanted : !hints_);
      return true;
    }
    case kCancel:
      cancel();
      return true;
    default:
      return false;
  }
}

void Session::learn(bool ui::HintCard::*what) {
  if (hints_) {
    (*hints_).*what = true;
    if (hints_->has_painted && hints_->has_orbited) {
      hints_.reset();
    }
  }
}

void Session::cancel() {
  if (!std::holds_alternative<std::monostate>(modal_)) {
    if (std::holds_alternative<ui::OverBudgetQuestion>(modal_)) {
      refinement_.decline();
      step_back_to_shown();
      export_path_.reset();
    }
    held_back_.reset();
    if (std::holds_alternative<ui::DesktopDialogNote>(modal_)) {
      host_.close_desktop_dialog();
    }
    if (std::holds_alternative<ui::RecoveryQuestion>(modal_)) {
      lost_.clear();  // They stay where they are, for the next run to ask about.
    }
    goes_on_after_save_ = false;
    modal_ = std::monostate{};
  } else if (is_stroking()) {
    give_up_stroke();
  } else if (auto_depth_.is_choosing()) {
    auto_depth_.stop_choosing();
    toast(Kind::kNote, "Choosing depths was stopped. The painting is as it was.");
  } else if (auto_depth_.is_comparing()) {
    auto_depth_.stop_comparing();
    toast(Kind::kNote, "The comparison was stopped.");
  } else if (sphere_.is_busy()) {
    sphere_.cancel();
    toast(Kind::kNote, "The comparison was stopped.");
  } else if (distance_.is_busy()) {
    distance_.give_up();
    toast(Kind::kNote, "The measurement was stopped.");
  } else if (refinement_.is_busy()) {
    refinement_.cancel();
    export_path_.reset();
    toast(Kind::kNote, "Refinement stopped. The last finished one stays in view.");
  } else if (steps_.is_shown()) {
    steps_.show(false);
  } else {
    mend_focus_.reset();
    flaw_focus_.reset();
  }
}

bool Session::perform_answer(const ui::Action& action) {
  switch (action.id) {
    case kBrowse:
      if (const auto* prompt = std::get_if<ui::PathPrompt>(&modal_)) {
        last_folder_ = std::get<std::string>(action.value);
        prompt_for_path(prompt->purpose);
      } else if (const auto* note = std::get_if<ui::DesktopDialogNote>(&modal_)) {
        host_.close_desktop_dialog();
        prompt_for_path(note->purpose);
      }
      return true;
    case kRefineAnyway:
      if (std::holds_alternative<ui::OverBudgetQuestion>(modal_)) {
        modal_ = std::monostate{};
        refinement_.accept();
      }
      return true;
    case kSaveFirst:
      if (std::holds_alternative<ui::UnsavedQuestion>(modal_)) {
        modal_ = std::monostate{};
        goes_on_after_save_ = true;
        perform(kSaveProject);
      }
      return true;
    case kDiscardChanges:
      if (std::holds_alternative<ui::UnsavedQuestion>(modal_)) {
        modal_ = std::monostate{};
        go_on();
      }
      return true;
    default:
      return false;
  }
}

std::string Session::title() const {
  const std::string& name =
      document_.project_path.empty() ? document_.name : document_.project_path.filename().string();
  return fmt::format("{}{} - Limn", name, history_.is_modified() ? " *" : "");
}

ui::Model Session::model() const {
  std::optional<ui::HoverInfo> hover;
  if (hover_) {
    hover = ui::HoverInfo{*hover_, document_.depths[*hover_],
                          document_.control->face(*hover_).size(), fine_hover()};
  }
  std::optional<ui::EdgeHover> hover_edge;
  if (hover_edge_) {
    hover_edge =
        ui::EdgeHover{*hover_edge_, document_.control->topology().edge_vertices[*hover_edge_]};
  }
  return {
      .document = document_,
      .statistics = facts_.statistics(),
      .is_modified = history_.is_modified(),
      .display = display_,
      .brush = brush_,
      .keymap = keymap_,
      .view = camera_.view(),
      .navigation = navigation_,
      .depth_counts = document_.depths.histogram(),
      .level_counts = levels_.counts(),
      .crease_counts = facts_.creases(),
      .valence_counts = valences_.counts(),
      .dihedral_threshold = dihedral_threshold_,
      .dihedral_faces = facts_.dihedral_faces(),
      .dihedral_edges = facts_.dihedral_edges(),
      .crease_sharpness = crease_sharpness_,
      .refinement = refinement_.status(),
      .steps = steps_.status(),
      .scheme = scheme_status(),
      .second = second_status(),
      .sphere = sphere_.status(sphere_question()),
      .distance = distance_status(),
      .auto_depth = auto_depth_status(),
      .history = {history_.undo_name(), history_.redo_name(), history_.bytes(), &history_},
      .hover = hover,
      .hover_edge = hover_edge,
      .mend_focus = mend_focus_,
      .t_junctions = facts_.t_junctions(),
      .flaw_focus = flaw_focus_,
      .is_stroking = is_stroking(),
      .forecast = forecast(),
      .lone_faces = lone_faces_,
      .frame_seconds = 0.0,
      .bundled_meshes = bundled_,
      .recent_files = recent_,
      .toasts = toasts_.shown(),
      .hints = hints_,
      .copies = copies_,
      .modal = modal_,
      .has_desktop_dialogs = static_cast<bool>(host_.ask_desktop),
      .uses_desktop_dialogs = uses_desktop_dialogs_,
  };
}

}  // namespace limn::app
