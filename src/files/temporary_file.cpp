// Names are ".limn-PROCESS-COUNT.tmp", so that whose a file is can be told from its name alone. A
// number of a process may be taken again, or belong to another machine that shares the folder: the
// lock tells in these cases.
#include "files/temporary_file.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <optional>
#include <string_view>

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

namespace limn {
namespace {

constexpr std::string_view kBegin = ".limn-";
constexpr std::string_view kEnd = ".tmp";

std::string name_of_temporary(unsigned count) {
  return fmt::format("{}{}-{}{}", kBegin, ::getpid(), count, kEnd);
}

std::optional<unsigned> take_number(std::string_view& text) {
  unsigned number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{}) {
    return std::nullopt;
  }
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

/// The process that a temporary's name tells of; nothing for all other names.
std::optional<pid_t> process_of(std::string_view name) {
  if (!name.starts_with(kBegin)) {
    return std::nullopt;
  }
  name.remove_prefix(kBegin.size());
  const auto process = take_number(name);
  if (!process || *process == 0 || !name.starts_with('-')) {
    return std::nullopt;
  }
  name.remove_prefix(1);
  const bool is_ours = take_number(name) && name == kEnd;
  const auto id = static_cast<pid_t>(*process);
  return is_ours && id > 0 ? std::optional(id) : std::nullopt;
}

bool is_gone(pid_t process) noexcept {
  return ::kill(process, 0) != 0 && errno == ESRCH;
}

void sweep_one(int folder, const char* name) noexcept {
  const Descriptor file(::openat(folder, name, O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC));
  struct stat status {};
  if (file.is_open() && ::fstat(file.get(), &status) == 0 && S_ISREG(status.st_mode) &&
      status.st_uid == ::geteuid() && ::flock(file.get(), LOCK_EX | LOCK_NB) == 0) {
    ::unlinkat(folder, name, 0);
  }
}

}  // namespace

TemporaryFile::TemporaryFile(const std::filesystem::path& folder) {
  static std::atomic<unsigned> count{0};
  constexpr int most_tries = 100;  // Names left over from a process that had our number.
  for (int i = 0; i < most_tries && !is_made_; ++i) {
    path_ = folder / name_of_temporary(count++);
    descriptor_ = Descriptor(::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    error_ = errno;
    is_made_ = descriptor_.is_open();
    if (!is_made_ && error_ != EEXIST) {
      break;
    }
  }
  if (is_made_) {
    ::flock(descriptor_.get(), LOCK_EX | LOCK_NB);  // Some file systems have no locks.
  }
}

TemporaryFile::~TemporaryFile() {
  if (is_made_ && state_ != State::kNewInPlace) {
    ::unlink(path_.c_str());
  }
}

bool TemporaryFile::replace(const std::filesystem::path& target) noexcept {
  if (::renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, target.c_str(), RENAME_EXCHANGE) == 0) {
    state_ = State::kExchanged;
    return true;
  }
  const bool is_new = errno == ENOENT;
  if (!is_new && errno != EINVAL && errno != ENOSYS && errno != EOPNOTSUPP) {
    return false;
  }
  if (::rename(path_.c_str(), target.c_str()) != 0) {
    return false;
  }
  state_ = State::kNewInPlace;
  has_replaced_ = !is_new;
  return true;
}

bool TemporaryFile::take_back(const std::filesystem::path& target) noexcept {
  if (state_ == State::kNewInPlace) {
    return !has_replaced_ && ::unlink(target.c_str()) == 0;
  }
  if (::renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, target.c_str(), RENAME_EXCHANGE) != 0) {
    return false;
  }
  state_ = State::kApart;
  return true;
}

void sweep_temporaries(const std::filesystem::path& folder) noexcept {
  DIR* const entries = ::opendir(folder.c_str());
  if (entries == nullptr) {
    return;
  }
  while (const dirent* const entry = ::readdir(entries)) {
    const char* const name = static_cast<const char*>(entry->d_name);
    if (const auto process = process_of(name); process && is_gone(*process)) {
      sweep_one(::dirfd(entries), name);
    }
  }
  ::closedir(entries);
}

}  // namespace limn
