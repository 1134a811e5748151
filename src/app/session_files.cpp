// Files: what is opened replaces the document only once it has been read without error, and what
// would lose changes waits for an answer.
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "app/path_prompt.h"
#include "app/preferences.h"
#include "app/session.h"
#include "limn/document/commands.h"
#include "limn/document/export_settings.h"
#include "limn/mesh/export.h"
#include "ui/format.h"

namespace limn::app {

namespace fs = std::filesystem;
using enum ui::ActionId;
using Kind = ui::Toast::Kind;
using Purpose = ui::PathPrompt::Purpose;

namespace {

/// The path an action carries; null where it asks for one.
const std::string* path_of(const ui::Action& action) {
  return std::get_if<std::string>(&action.value);
}

std::string stem_of(const Document& document) {
  const fs::path name =
      document.project_path.empty() ? fs::path(document.name) : document.project_path.filename();
  const std::string stem = name.stem().string();
  return stem.empty() ? "mesh" : stem;
}

std::string file_name(const std::string& path) {
  return fs::path(path).filename().string();
}

}  // namespace

bool Session::perform_file(const ui::Action& action) {
  const std::string* path = path_of(action);
  switch (action.id) {
    case kOpen:
      if (path == nullptr) {
        ask_for_path(Purpose::kOpen);
      } else if (may_lose_changes(action, "open " + file_name(*path))) {
        open(*path);
      }
      return true;
    case kOpenBundled:
      if (may_lose_changes(action, "open " + std::get<std::string>(action.value))) {
        open(std::get<std::string>(action.value));
      }
      return true;
    case kSaveProject:
      if (document_.project_path.empty()) {
        ask_for_path(Purpose::kSaveProject);
      } else {
        save(document_.project_path);
      }
      return true;
    case kSaveProjectAs:
      if (path == nullptr) {
        ask_for_path(Purpose::kSaveProject);
      } else {
        save(with_ending(Purpose::kSaveProject, *path));
      }
      return true;
    case kExportRefined:
      if (path == nullptr) {
        ask_for_path(Purpose::kExportRefined);
      } else {
        start_export(with_ending(Purpose::kExportRefined, *path));
      }
      return true;
    case kReplaceMesh:
      if (path == nullptr) {
        ask_for_path(Purpose::kReplaceMesh);
      } else {
        replace_mesh(*path);
      }
      return true;
    case kScreenshot:
      screenshot_path_ = files_.new_picture(fmt::format("limn-{}", stem_of(document_)));
      return true;
    case kQuit:
      if (may_lose_changes(action, "quit")) {
        wants_to_quit_ = true;
        autosave_.clear();
      }
      return true;
    default:
      return false;
  }
}

bool Session::may_lose_changes(const ui::Action& action, std::string next) {
  end_stroke();
  if (!history_.is_modified() || may_lose_all_) {
    return true;
  }
  held_back_ = action;
  modal_ = ui::UnsavedQuestion{document_.name, std::move(next)};
  return false;
}

void Session::go_on() {
  goes_on_after_save_ = false;
  if (auto action = std::exchange(held_back_, std::nullopt)) {
    // Either it was saved, or the person said to lose it. If the action then fails, the document is
    // there still, and as unsaved as before.
    may_lose_all_ = true;
    perform(*action);
    may_lose_all_ = false;
  }
}

void Session::open(const std::string& name) {
  modal_ = std::monostate{};
  auto project = files_.open(name);
  if (!project) {
    show_error("Cannot open " + file_name(name), std::move(project.error()));
    return;
  }
  show(std::move(*project));
}

void Session::replace_mesh(const fs::path& path) {
  modal_ = std::monostate{};
  end_stroke();
  auto mesh = files_.import(path);
  if (!mesh) {
    show_error("Cannot take up " + path.filename().string(), std::move(mesh.error()));
    return;
  }
  PaintingTransfer transfer =
      transfer_painting(*document_.control, document_.depths.values(), mesh->mesh);
  const std::size_t faces = transfer.depths.size();
  std::string text =
      fmt::format("Replace: {} of {} faces found again", faces - transfer.new_faces.size(), faces);
  text += transfer.matching == FaceMatching::kOrder ? " by their numbers." : ".";
  if (const std::size_t lost = transfer.lost_faces.size(); lost > 0) {
    text += fmt::format(" {} painted face{} gone.", lost, lost == 1 ? " is" : "s are");
  }
  const std::size_t finer = document_.demands.size();
  if (finer > 0) {
    text += fmt::format(" {} on finer faces gone.", ui::counted(finer, "demand"));
  }
  const bool is_whole = transfer.new_faces.empty() && transfer.lost_faces.empty() && finer == 0;
  execute(reattach_command(std::move(transfer)));
  document_.mesh_path = path;
  toast(is_whole ? Kind::kDone : Kind::kNote, std::move(text));
}

void Session::remember_file(const fs::path& path) {
  if (!path.empty()) {
    const fs::path whole = (files_.working_folder() / path).lexically_normal();
    remember_recent(recent_, whole.string());
    last_folder_ = whole.parent_path();
  }
}

void Session::save(const fs::path& path) {
  modal_ = std::monostate{};
  end_stroke();
  if (auto saved = files_.save(path, document_, camera_.goal()); !saved) {
    held_back_.reset();
    goes_on_after_save_ = false;
    show_error("Cannot save " + path.filename().string(), std::move(saved.error()));
    return;
  }
  document_.project_path = path;
  history_.mark_saved();
  remember_file(path);
  toast(Kind::kDone, "Saved " + path.filename().string());
  if (goes_on_after_save_) {
    go_on();
  }
}

void Session::start_export(const fs::path& path) {
  modal_ = std::monostate{};
  end_stroke();
  if (document_.scheme && document_.stage.levels == 0) {
    toast(Kind::kNote, "Level 0 is the control mesh itself. Go forward by a level first.");
    return;
  }
  last_folder_ = (files_.working_folder() / path).parent_path();
  export_path_ = path;
  refinement_.follow(document_, wish());
  if (!refinement_.is_up_to_date()) {
    toast(Kind::kNote,
          fmt::format("{} will be written as soon as it is refined.", path.filename().string()));
  }
}

void Session::write_export() {
  exports_.start(*std::exchange(export_path_, std::nullopt), refinement_.refined()->mesh,
                 document_.control, export_settings(document_));
}

/// True where a file was done.
bool Session::report_export() {
  auto outcome = exports_.take_outcome();
  if (!outcome) {
    return false;
  }
  if (outcome->written) {
    toast(Kind::kDone, fmt::format("Wrote {}: {} faces.", outcome->path.string(), outcome->faces));
  } else {
    show_error("Cannot write " + outcome->path.filename().string(),
               std::move(outcome->written.error()));
  }
  return true;
}

std::string Session::suggested_name(Purpose purpose) const {
  switch (purpose) {
    case Purpose::kSaveProject:
      return stem_of(document_) + ".limn";
    case Purpose::kExportRefined:
      return stem_of(document_) + "-refined.obj";
    case Purpose::kOpen:
    case Purpose::kReplaceMesh:
      break;
  }
  return {};
}

void Session::ask_for_path(Purpose purpose) {
  if (last_folder_.empty()) {
    last_folder_ = files_.working_folder();
  }
  if (uses_desktop_dialogs_ && host_.ask_desktop &&
      host_.ask_desktop({purpose, last_folder_, suggested_name(purpose)})) {
    modal_ = ui::DesktopDialogNote{purpose, last_folder_.string()};
  } else {
    prompt_for_path(purpose);
  }
}

void Session::prompt_for_path(Purpose purpose, const std::string& name) {
  ui::PathPrompt prompt = files_.list(purpose, last_folder_);
  if (const auto* before = std::get_if<ui::PathPrompt>(&modal_);
      before != nullptr && before->purpose == purpose) {
    prompt.serial = before->serial;
  } else {
    prompt.serial = ++prompt_serial_;
  }
  prompt.suggested_name = name.empty() ? suggested_name(purpose) : name;
  if (purpose == Purpose::kExportRefined) {
    prompt.losses = export_losses();
  }
  modal_ = std::move(prompt);
}

void Session::answer_dialog(Purpose purpose, const fs::path& path) {
  if (!std::holds_alternative<ui::DesktopDialogNote>(modal_)) {
    return;  // It was closed meanwhile.
  }
  if (path.empty()) {
    perform(kCancel);
    return;
  }
  modal_ = std::monostate{};
  const fs::path whole = with_ending(purpose, path);
  if (whole != path) {
    // The dialog has not asked about the file of this name, if there is one: ours does.
    last_folder_ = whole.parent_path();
    prompt_for_path(purpose, whole.filename().string());
    return;
  }
  switch (purpose) {
    case Purpose::kOpen:
      return perform({kOpen, path.string()});
    case Purpose::kReplaceMesh:
      return perform({kReplaceMesh, path.string()});
    case Purpose::kSaveProject:
      return perform({kSaveProjectAs, path.string()});
    case Purpose::kExportRefined:
      return perform({kExportRefined, path.string()});
  }
}

/// Of the refined mesh, or of the control mesh where that is not to be had at once or so large that
/// one would wait for the answer.
std::array<std::string, MeshFormats.size()> Session::export_losses() const {
  constexpr std::size_t most_vertices = 200'000;
  const ExportSettings settings = export_settings(document_);
  const auto* refined = refinement_.is_up_to_date() ? refinement_.refined() : nullptr;
  const bool is_refined = refined != nullptr && refined->mesh->vertex_count() <= most_vertices;
  std::array<std::string, MeshFormats.size()> losses;
  for (const MeshFormat format : MeshFormats) {
    losses[static_cast<std::size_t>(format)] =
        loss_sentence(format, is_refined ? lost_in(format, *refined->mesh, settings)
                                         : lost_in(format, *document_.control, settings));
  }
  return losses;
}

std::optional<fs::path> Session::take_screenshot_request() {
  return std::exchange(screenshot_path_, std::nullopt);
}

void Session::write_screenshot(const fs::path& path, const render::Image& image) {
  const Result<void> written = files_.write_picture(path, image);
  if (written) {
    toast(Kind::kDone, "Screenshot: " + path.string());
  } else {
    toast(Kind::kProblem, to_string(written.error()));
  }
}

}  // namespace limn::app
