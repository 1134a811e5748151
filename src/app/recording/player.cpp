// A turn: what came from outside, then what arrived from workers, then one frame; and a comparison
// of what came of it.
#include "app/recording/player.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "limn/document/open.h"
#include "limn/mesh/import.h"
#include "render/png.h"

namespace limn::app {
namespace {

namespace fs = std::filesystem;

Result<void> written(const std::optional<WrittenFile>& answer) {
  if (answer && answer->problem) {
    return fail(ErrorKind::kFailed, *answer->problem, answer->path);
  }
  return {};
}

}  // namespace

Player::Player(Recording recording) : recording_(std::move(recording)) {
  screen_ = recording_.head.screen;
  answers_.assign(recording_.head.files.begin(), recording_.head.files.end());
  for (const RecordedTurn& turn : recording_.turns) {
    exports_.insert(exports_.end(), turn.exports.begin(), turn.exports.end());
  }
}

Player::~Player() {
  std::error_code ignored;
  if (!scratch_.empty()) {
    fs::remove_all(scratch_, ignored);
  }
}

void Player::differ(std::string what) {
  if (report_.differences.size() < PlayReport::kMostDifferences) {
    report_.differences.push_back(fmt::format("at {:.3f} s: {}", time_, what));
  }
}

template <class T>
std::optional<T> Player::answer(const char* question) {
  if (answers_.empty() || !std::holds_alternative<T>(answers_.front())) {
    differ(fmt::format("{} was asked for, which was not so in the recorded run", question));
    return std::nullopt;
  }
  T found = std::get<T>(std::move(answers_.front()));
  answers_.pop_front();
  return found;
}

WorkbenchHost Player::host() {
  std::function<bool(const DialogRequest&)> ask_desktop;
  if (recording_.head.has_desktop_dialogs) {
    ask_desktop = [](const DialogRequest&) { return true; };
  }
  return {.wake = [] {},
          .read_clipboard =
              [this] {
                const auto read = answer<ReadClipboard>("the clipboard");
                return read ? read->text : std::string();
              },
          .write_clipboard = [](const std::string&) {},
          .ask_desktop = std::move(ask_desktop),
          .close_desktop_dialog = [] {},
          .files = this,
          .arrivals = this};
}

Result<Project> Player::open_first() {
  return recording_.head.project.empty() ? open(recording_.head.input)
                                         : parse_project(recording_.head.project, "the recording");
}

void Player::play_turn(Workbench& workbench, const Draw& draw) {
  const RecordedTurn& turn = recording_.turns[next_++];
  turn_ = &turn;
  time_ = turn.time;
  if (turn.screen) {
    screen_ = *turn.screen;
  }
  answers_.insert(answers_.end(), turn.files.begin(), turn.files.end());
  for (const ui::InputEvent& event : turn.events) {
    queue_.push(event);
  }
  static_cast<void>(workbench.take_news(turn.news, turn.time));
  if (turn.has_frame) {
    const Workbench::Frame frame = draw(queue_.next_frame(), screen_, turn.time);
    std::vector<std::string> actions;
    for (const ui::Action& action : frame.actions) {
      actions.push_back(text_of(action));
    }
    if (actions != turn.actions) {
      differ(fmt::format("\"{}\" instead of \"{}\"", fmt::join(actions, ", "),
                         fmt::join(turn.actions, ", ")));
    }
    report_.actions += actions.size();
  }
  if (!answers_.empty()) {
    differ("less was asked of the file system than in the recorded run");
    answers_.clear();
  }
  compare(workbench, turn);
  ++report_.turns;
  turn_ = nullptr;
}

void Player::compare(const Workbench& workbench, const RecordedTurn& turn) {
  if (turn.document) {
    ++report_.documents;
    if (checksum_of(workbench.session().document()) != *turn.document) {
      differ("the document is another one");
    }
  }
  if (turn.picture && compares_pictures_) {
    ++report_.pictures;
    if (checksum_of(workbench.viewport_picture()) != *turn.picture) {
      differ("the picture is another one");
    }
  }
}

std::size_t Player::admit(const Box& box) {
  if (turn_ == nullptr) {
    return 0;
  }
  std::size_t count = 0;
  for (const auto& [name, recorded] : turn_->arrivals) {
    count += name == box.name() ? recorded : 0;
  }
  if (count > 0 && !box.wait_for(count, patience_)) {
    differ(fmt::format("no news came from \"{}\"", box.name()));
  }
  return std::min(count, box.ready());
}

fs::path Player::materialise(const std::string& path, const std::string& bytes) {
  if (scratch_.empty()) {
    std::string name = (fs::temp_directory_path() / "limn-replay-XXXXXX").string();
    if (mkdtemp(name.data()) != nullptr) {
      scratch_ = name;
    }
  }
  const fs::path folder = scratch_ / std::to_string(scratch_files_++);
  std::error_code ignored;
  fs::create_directories(folder, ignored);
  fs::path file = folder / fs::path(path).filename();
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}

Result<Project> Player::open(const std::string& name) {
  const auto recorded = answer<OpenedFile>("a file");
  if (!recorded || !recorded->bytes) {
    return open_document(name);
  }
  const fs::path file = materialise(recorded->name, *recorded->bytes);
  auto project = open_document(file.string());
  if (!project) {
    project.error().path = recorded->name;
    return project;
  }
  Document& document = project->document;
  if (document.mesh_path == file) {
    document.mesh_path = recorded->name;
  }
  if (document.project_path == file) {
    document.project_path = recorded->name;
  }
  return project;
}

Result<ImportedMesh> Player::import(const fs::path& path) {
  const auto recorded = answer<ImportedFile>("a mesh");
  if (!recorded || !recorded->bytes) {
    return import_mesh(path);
  }
  auto mesh = import_mesh(materialise(recorded->path, *recorded->bytes));
  if (!mesh) {
    mesh.error().path = recorded->path;
  }
  return mesh;
}

Result<void> Player::save(const fs::path&, const Document&, const ViewState&) {
  return written(answer<WrittenFile>("a place to save to"));
}

Result<void> Player::write_mesh(const fs::path& path, const RefinedMesh&, const ExportSettings&) {
  const std::lock_guard lock(mutex_);
  if (exports_.empty() || exports_.front().path != path.string()) {
    return fail(ErrorKind::kFailed, "The recorded run did not write this file.", path.string());
  }
  const WrittenFile file = std::move(exports_.front());
  exports_.pop_front();
  return written(file);
}

ui::PathPrompt Player::list(ui::PathPrompt::Purpose purpose, const fs::path& folder) {
  ui::PathPrompt prompt;
  prompt.purpose = purpose;
  prompt.folder = folder.string();
  if (auto recorded = answer<ListedFolder>("a folder")) {
    prompt.folder = std::move(recorded->folder);
    prompt.parent = std::move(recorded->parent);
    prompt.entries = std::move(recorded->entries);
    prompt.problem = std::move(recorded->problem);
  }
  return prompt;
}

fs::path Player::working_folder() {
  const auto found = answer<FoundPath>("the working folder");
  return found ? fs::path(found->path) : fs::path();
}

fs::path Player::new_picture(const std::string& stem) {
  const auto found = answer<FoundPath>("a name for a picture");
  return found ? fs::path(found->path) : fs::path(stem + ".png");
}

Result<void> Player::write_picture(const fs::path& path, const render::Image& image) {
  if (!pictures_.empty()) {
    if (auto done = render::write_png(pictures_ / path.filename(), image); !done) {
      return done;
    }
  }
  return written(answer<WrittenFile>("a place for a picture"));
}

}  // namespace limn::app
