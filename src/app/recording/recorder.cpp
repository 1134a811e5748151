#include "app/recording/recorder.h"

#include <iterator>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace limn::app {
namespace {

namespace fs = std::filesystem;

/// Larger documents are compared at the end alone: taking the checksum of one takes as long as
/// saving it.
constexpr std::size_t kMostCheckedFaces = 20'000;

/// The contents of a file; nothing where there is none to be read.
std::optional<std::string> bytes_of_file(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) {
    return std::nullopt;
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    return std::nullopt;
  }
  return std::string(std::istreambuf_iterator<char>(file), {});
}

std::optional<std::string> problem_of(const Result<void>& written) {
  return written ? std::nullopt : std::optional(written.error().message);
}

bool is_same(const Revisions& a, const Revisions& b) {
  return a.control == b.control && a.depths == b.depths && a.stage == b.stage;
}

}  // namespace

Recorder::Recorder(const fs::path& path)
    : path_(path), out_(path, std::ios::binary | std::ios::trunc) {}

Result<std::unique_ptr<Recorder>> Recorder::create(const fs::path& path) {
  std::unique_ptr<Recorder> recorder(new Recorder(path));
  if (!recorder->out_) {
    return fail(ErrorKind::kFailed,
                "The recording cannot be written there. Name a file in a folder that is yours.",
                path.string());
  }
  return recorder;
}

void Recorder::write(const std::string& line) {
  if (has_failed_) {
    return;
  }
  out_ << line << std::flush;
  if (!out_) {
    has_failed_ = true;
    error_ = Error{ErrorKind::kFailed,
                   "The recording could not be written any further. What there is of it can be "
                   "played back.",
                   path_.string(), 0};
  }
}

std::optional<Error> Recorder::take_error() {
  return std::exchange(error_, std::nullopt);
}

void Recorder::begin(RecordingHead head) {
  head.files = std::exchange(turn_.files, {});
  screen_ = head.screen;
  write(head_line(head));
}

void Recorder::begin_turn(const Workbench::News& news, double time) {
  turn_.news = news;
  turn_.time = time_ = time;
}

void Recorder::add_frame(const Screen& screen, const Workbench::Frame& frame) {
  turn_.has_frame = true;
  if (screen_ != screen) {
    screen_ = turn_.screen = screen;
  }
  for (const ui::Action& action : frame.actions) {
    turn_.actions.push_back(text_of(action));
  }
  takes_picture_ = frame.took_picture;
}

void Recorder::check_document(const Workbench& workbench, bool is_end) {
  const Session& session = workbench.session();
  const Document& document = session.document();
  const bool is_due = !session.is_stroking() && !is_same(checked_, document.revisions) &&
                      document.control->face_count() <= kMostCheckedFaces;
  if (is_due || is_end) {
    checked_ = document.revisions;
    turn_.document = checksum_of(document);
  }
}

void Recorder::end_turn(const Workbench& workbench) {
  const std::lock_guard lock(mutex_);
  const bool has_news = !turn_.news.dropped_files.empty() || turn_.news.close_requested ||
                        turn_.news.moved_under_alt || turn_.news.chosen.has_value();
  if (!turn_.has_frame && turn_.events.empty() && !has_news && turn_.arrivals.empty() &&
      turn_.files.empty() && turn_.exports.empty()) {
    return;
  }
  check_document(workbench, false);
  if (std::exchange(takes_picture_, false)) {
    turn_.picture = checksum_of(workbench.viewport_picture());
  }
  write(turn_line(std::exchange(turn_, {})));
}

void Recorder::end(const Workbench& workbench) {
  const std::lock_guard lock(mutex_);
  turn_.time = time_;
  check_document(workbench, true);
  turn_.picture = checksum_of(workbench.viewport_picture());
  write(turn_line(std::exchange(turn_, {})));
  write(end_line());
}

std::string Recorder::read_clipboard(const std::string& text) {
  turn_.files.emplace_back(ReadClipboard{text});
  return text;
}

std::size_t Recorder::admit(const Box& box) {
  const std::size_t count = box.ready();
  if (count > 0) {
    turn_.arrivals.emplace_back(box.name(), count);
  }
  return count;
}

Result<Project> Recorder::open(const std::string& name) {
  turn_.files.emplace_back(OpenedFile{name, bytes_of_file(name)});
  return disk().open(name);
}

Result<ImportedMesh> Recorder::import(const fs::path& path) {
  turn_.files.emplace_back(ImportedFile{path.string(), bytes_of_file(path)});
  return disk().import(path);
}

Result<void> Recorder::save(const fs::path& path, const Document& document, const ViewState& view) {
  Result<void> saved = disk().save(path, document, view);
  turn_.files.emplace_back(WrittenFile{path.string(), problem_of(saved)});
  return saved;
}

Result<void> Recorder::write_mesh(const fs::path& path, const RefinedMesh& mesh,
                                  const ExportSettings& settings) {
  Result<void> written = disk().write_mesh(path, mesh, settings);
  const std::lock_guard lock(mutex_);
  turn_.exports.push_back({path.string(), problem_of(written)});
  return written;
}

ui::PathPrompt Recorder::list(ui::PathPrompt::Purpose purpose, const fs::path& folder) {
  ui::PathPrompt prompt = disk().list(purpose, folder);
  turn_.files.emplace_back(
      ListedFolder{prompt.folder, prompt.parent, prompt.entries, prompt.problem});
  return prompt;
}

fs::path Recorder::working_folder() {
  fs::path folder = disk().working_folder();
  turn_.files.emplace_back(FoundPath{folder.string()});
  return folder;
}

fs::path Recorder::new_picture(const std::string& stem) {
  fs::path path = disk().new_picture(stem);
  turn_.files.emplace_back(FoundPath{path.string()});
  return path;
}

Result<void> Recorder::write_picture(const fs::path& path, const render::Image& image) {
  Result<void> written = disk().write_picture(path, image);
  turn_.files.emplace_back(WrittenFile{path.string(), problem_of(written)});
  return written;
}

}  // namespace limn::app
