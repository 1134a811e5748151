// A temporary beside the target, written, flushed to disk, renamed over it; then the folder is
// flushed too, so that the rename itself survives a power cut.
#include "limn/atomic_file.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

namespace limn {
namespace {

/// Writes to a descriptor and remembers the first error number, which iostreams would hide.
class DescriptorBuffer final : public std::streambuf {
 public:
  explicit DescriptorBuffer(int descriptor) : descriptor_(descriptor), buffer_(1U << 16U) {
    setp(buffer_.data(), buffer_.data() + buffer_.size());
  }
  [[nodiscard]] int error() const noexcept { return error_; }

 protected:
  int sync() override {
    const char* from = pbase();
    while (from < pptr() && error_ == 0) {
      const ssize_t written = ::write(descriptor_, from, static_cast<std::size_t>(pptr() - from));
      if (written >= 0) {
        from += written;
      } else if (errno != EINTR) {
        error_ = errno;
      }
    }
    setp(buffer_.data(), buffer_.data() + buffer_.size());
    return error_ == 0 ? 0 : -1;
  }
  int_type overflow(int_type c) override {
    if (sync() != 0) {
      return traits_type::eof();
    }
    if (!traits_type::eq_int_type(c, traits_type::eof())) {
      sputc(traits_type::to_char_type(c));
    }
    return traits_type::not_eof(c);
  }

 private:
  int descriptor_;
  int error_ = 0;
  std::vector<char> buffer_;
};

tl::unexpected<Error> system_failure(const std::filesystem::path& path, std::string_view what,
                                     int error) {
  return fail(ErrorKind::kFailed,
              fmt::format("{}: {}. The file on disk is as it was.", what,
                          std::generic_category().message(error)),
              path.string());
}

/// The file that `path` means: links are followed, also one to a file that is not there yet, so
/// that what it points to is replaced and not the link.
std::filesystem::path follow_links(std::filesystem::path path) {
  constexpr int most_links = 40;  // As in the kernel; beyond it opening fails with ELOOP.
  std::error_code error;
  for (int i = 0; i < most_links && std::filesystem::is_symlink(path, error); ++i) {
    const std::filesystem::path target = std::filesystem::read_symlink(path, error);
    if (error) {
      break;
    }
    path = path.parent_path() / target;
  }
  return path;
}

/// A new file with a name of its own, removed again unless it was moved to its final name.
class TemporaryFile {
 public:
  /// Made with the rights that the umask allows.
  explicit TemporaryFile(const std::filesystem::path& folder) {
    static std::atomic<unsigned> count{0};
    constexpr int most_tries = 100;  // Names left over from a process that crashed.
    for (int i = 0; i < most_tries && descriptor_ < 0; ++i) {
      path_ = folder / fmt::format(".limn-{}-{}.tmp", ::getpid(), count++);
      descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      error_ = errno;
      if (descriptor_ < 0 && error_ != EEXIST) {
        break;
      }
    }
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (descriptor_ >= 0) {
      ::close(descriptor_);
    }
    if (is_made() && !is_moved_) {
      ::unlink(path_.c_str());
    }
  }

  [[nodiscard]] bool is_made() const noexcept { return descriptor_ >= 0 || is_closed_; }
  [[nodiscard]] int descriptor() const noexcept { return descriptor_; }
  /// The number of the error that kept it from being made.
  [[nodiscard]] int error() const noexcept { return error_; }

  [[nodiscard]] bool close() {
    is_closed_ = true;
    return ::close(std::exchange(descriptor_, -1)) == 0;
  }
  [[nodiscard]] bool move_to(const std::filesystem::path& target) {
    is_moved_ = ::rename(path_.c_str(), target.c_str()) == 0;
    return is_moved_;
  }

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
  int error_ = 0;
  bool is_closed_ = false;
  bool is_moved_ = false;
};

void flush_folder(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor >= 0) {
    ::fsync(descriptor);  // Best effort: some file systems refuse to sync a folder.
    ::close(descriptor);
  }
}

}  // namespace

Result<void> write_file_atomically(const std::filesystem::path& path,
                                   const std::function<void(std::ostream&)>& write) {
  const std::filesystem::path target = follow_links(path);
  const std::filesystem::path folder =
      target.has_parent_path() ? target.parent_path() : std::filesystem::path(".");

  struct stat before {};
  const bool is_there = ::stat(target.c_str(), &before) == 0;
  if (is_there && !S_ISREG(before.st_mode)) {
    return fail(ErrorKind::kFailed, "is not a regular file; choose another name", path.string());
  }
  TemporaryFile temporary(folder);
  if (!temporary.is_made()) {
    return system_failure(path, "cannot write in this folder", temporary.error());
  }

  DescriptorBuffer buffer(temporary.descriptor());
  std::ostream out(&buffer);
  write(out);
  out.flush();
  if (buffer.error() != 0 || !out) {
    return system_failure(path, "cannot write", buffer.error() != 0 ? buffer.error() : EIO);
  }
  if (is_there) {
    ::fchmod(temporary.descriptor(), before.st_mode & 07777U);
  }
  if (::fsync(temporary.descriptor()) != 0) {
    return system_failure(path, "cannot flush to disk", errno);
  }
  if (!temporary.close()) {
    return system_failure(path, "cannot finish writing", errno);
  }
  if (!temporary.move_to(target)) {
    return system_failure(path, "cannot replace the file", errno);
  }
  flush_folder(folder);
  return {};
}

}  // namespace limn
