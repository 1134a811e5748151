// A folder PROCESS-COUNT holds copies 000001.limn and on, "lock" and "about": the document's name
// and, after a zero byte, the path it was saved at. It is made under another name and takes its own
// only when it is locked, so that nobody takes it for a dead run's before that.
#include "app/recovery_store.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <fmt/format.h>

#include "files/regular_file.h"
#include "limn/files/atomic_file.h"

namespace limn::app {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEnding = ".limn";
constexpr std::size_t kMostAboutBytes = std::size_t{1} << 20U;

/// Whether this process holds the lock from here on; `is_gone` answers where there are no locks.
bool take_lock(const Descriptor& lock, const fs::path& folder) {
  if (::flock(lock.get(), LOCK_EX | LOCK_NB) == 0) {
    return true;
  }
  if (errno == EWOULDBLOCK) {
    return false;
  }
  const int process = std::atoi(folder.filename().c_str());
  return process > 0 && ::kill(process, 0) != 0 && errno == ESRCH;
}

/// The number of a copy; 0 for other files.
unsigned number_of(const fs::path& file) {
  const std::string stem = file.stem().string();
  unsigned number = 0;
  const auto [end, error] = std::from_chars(stem.data(), stem.data() + stem.size(), number);
  return file.extension() == kEnding && error == std::errc{} && end == stem.data() + stem.size()
             ? number
             : 0;
}

/// The copies in a folder, newest first.
std::vector<fs::path> copies_in(const fs::path& folder) {
  std::vector<fs::path> copies;
  std::error_code error;
  for (auto at = fs::directory_iterator(folder, error); !error && at != fs::directory_iterator();
       at.increment(error)) {
    if (number_of(at->path()) > 0) {
      copies.push_back(at->path());
    }
  }
  std::ranges::sort(copies, std::greater<>{}, number_of);
  return copies;
}

/// Takes a folder that belongs to nobody any more; nothing where it is somebody's, or empty.
std::optional<LostWork> take(const fs::path& folder) {
  LostWork work;
  work.folder = folder;
  work.lock = Descriptor(::open((folder / "lock").c_str(), O_RDWR | O_CLOEXEC));
  if (!work.lock.is_open() || !take_lock(work.lock, folder)) {
    return std::nullopt;
  }
  std::error_code ignored;
  work.copies = copies_in(folder);
  if (work.copies.empty()) {
    fs::remove_all(folder, ignored);
    return std::nullopt;
  }
  work.written_at = fs::last_write_time(work.copies.front(), ignored);
  if (const auto about = read_regular_file(folder / "about", kMostAboutBytes)) {
    const std::size_t end = about->find('\0');
    work.name = about->substr(0, end);
    work.project_path = end == std::string::npos ? "" : about->substr(end + 1);
  }
  return work;
}

}  // namespace

std::vector<LostWork> find_lost_work(const fs::path& common) {
  std::vector<LostWork> found;
  std::error_code error;
  for (auto at = fs::directory_iterator(common, error); !error && at != fs::directory_iterator();
       at.increment(error)) {
    if (at->path().filename().string().starts_with('.')) {
      continue;
    }
    if (auto work = take(at->path())) {
      found.push_back(std::move(*work));
    }
  }
  std::ranges::sort(found, std::greater<>{}, &LostWork::written_at);
  return found;
}

Result<Project> load_lost_work(const LostWork& work) {
  std::optional<Error> first;
  for (const fs::path& copy : work.copies) {
    if (Result<Project> project = load_project(copy)) {
      project->document.project_path = work.project_path;
      return project;
    } else if (!first) {
      first = std::move(project.error());
    }
  }
  return tl::unexpected(first.value_or(
      Error{ErrorKind::kBadInput, "There is nothing to recover.", work.folder.string()}));
}

void discard_lost_work(LostWork work) {
  std::error_code ignored;
  fs::remove_all(work.folder, ignored);
}

Result<void> RecoveryStore::make_folder() {
  std::error_code error;
  fs::create_directories(common_, error);
  if (!error) {
    fs::permissions(common_, fs::perms::owner_all, error);  // Nobody else's business.
  }
  constexpr unsigned most_tries = 1000;  // Numbers of processes come round again.
  for (unsigned count = 0; !error && count < most_tries; ++count) {
    const fs::path folder = common_ / fmt::format("{}-{}", ::getpid(), count);
    const fs::path hidden = common_ / fmt::format(".{}-{}", ::getpid(), count);
    if (fs::exists(folder, error) || error) {
      continue;
    }
    fs::create_directory(hidden, error);
    lock_ = Descriptor(::open((hidden / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600));
    if (!lock_.is_open()) {
      error = std::error_code(errno, std::generic_category());
      break;
    }
    ::flock(lock_.get(), LOCK_EX | LOCK_NB);
    fs::rename(hidden, folder, error);
    if (!error) {
      folder_ = folder;
      described_.clear();
      return {};
    }
  }
  return fail(ErrorKind::kFailed,
              fmt::format("cannot make a folder for copies of unsaved work: {}.", error.message()),
              common_.string());
}

void RecoveryStore::describe(const Document& document) {
  std::string about = document.name + '\0' + document.project_path.string();
  if (about == described_) {
    return;
  }
  // Without it the copies can be recovered all the same.
  const Result<void> written =
      write_file_atomically(folder_ / "about", [&](std::ostream& out) { out << about; });
  if (written) {
    described_ = std::move(about);
  }
}

Result<void> RecoveryStore::keep(const Document& document, const std::optional<ViewState>& view) {
  std::error_code ignored;
  if (folder_.empty() || !fs::exists(folder_ / "lock", ignored)) {
    if (auto made = make_folder(); !made) {
      return made;
    }
  }
  describe(document);
  if (auto saved = save_project(folder_ / fmt::format("{:06}{}", next_, kEnding), document, view);
      !saved) {
    return saved;
  }
  ++next_;
  const std::vector<fs::path> copies = copies_in(folder_);
  for (std::size_t i = kKeptCopies; i < copies.size(); ++i) {
    fs::remove(copies[i], ignored);
  }
  return {};
}

void RecoveryStore::clear() {
  if (!folder_.empty()) {
    std::error_code ignored;
    fs::remove_all(std::exchange(folder_, {}), ignored);
    lock_ = Descriptor();
  }
}

void RecoveryStore::adopt(LostWork work) {
  clear();
  folder_ = std::move(work.folder);
  lock_ = std::move(work.lock);
  described_.clear();
  next_ = number_of(work.copies.front()) + 1;
}

}  // namespace limn::app
