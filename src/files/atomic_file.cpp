// A temporary beside the target, written, flushed to disk, put in its place; then the folder is
// flushed too, so that the new name itself survives a power cut. The old file is let go of only
// after that.
#include "limn/files/atomic_file.h"

#include <cerrno>
#include <cstring>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "files/descriptor.h"
#include "files/temporary_file.h"

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

constexpr std::string_view kIsAsBefore = "The file on disk is as it was.";

tl::unexpected<Error> system_failure(const std::filesystem::path& path, std::string_view what,
                                     int error, std::string_view state = kIsAsBefore) {
  return fail(ErrorKind::kFailed,
              fmt::format("{}: {}. {}", what, std::generic_category().message(error), state),
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

/// Gives a new file the old one's rights, and its owner and group where this process may. First
/// those, because changing them takes rights away.
bool keep_rights(int descriptor, const struct stat& before) {
  struct stat now {};
  if (::fstat(descriptor, &now) != 0) {
    return false;
  }
  if ((now.st_uid != before.st_uid || now.st_gid != before.st_gid) &&
      ::fchown(descriptor, before.st_uid, before.st_gid) != 0 && errno != EPERM) {
    return false;
  }
  return ::fchmod(descriptor, before.st_mode & 07777U) == 0;
}

/// Flushes the names in a folder to disk; false with errno set. A folder that may not be read, or
/// on a file system that cannot flush folders, has nothing to say about it.
bool flush_folder(const std::filesystem::path& folder) {
  const Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!descriptor.is_open()) {
    return errno == EACCES;
  }
  return ::fsync(descriptor.get()) == 0 || errno == EINVAL || errno == EOPNOTSUPP;
}

}  // namespace

Result<void> write_file_atomically(const std::filesystem::path& path,
                                   const std::function<void(std::ostream&)>& write) {
  const std::filesystem::path target = follow_links(path);
  const std::filesystem::path folder =
      target.has_parent_path() ? target.parent_path() : std::filesystem::path(".");

  struct stat before {};
  const bool is_there = ::stat(target.c_str(), &before) == 0;
  if (!is_there && errno != ENOENT) {
    return system_failure(path, "cannot write in this folder", errno);
  }
  if (is_there && !S_ISREG(before.st_mode)) {
    return fail(ErrorKind::kFailed, "is not a regular file; choose another name", path.string());
  }
  sweep_temporaries(folder);
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
  if (is_there && !keep_rights(temporary.descriptor(), before)) {
    return system_failure(path, "cannot keep the file's rights", errno);
  }
  if (::fsync(temporary.descriptor()) != 0) {
    return system_failure(path, "cannot flush to disk", errno);
  }
  if (!temporary.close()) {
    return system_failure(path, "cannot finish writing", errno);
  }
  if (!temporary.replace(target)) {
    return system_failure(path, "cannot replace the file", errno);
  }
  if (!flush_folder(folder)) {
    const int error = errno;
    return system_failure(path, "cannot flush the folder to disk", error,
                          temporary.take_back(target)
                              ? kIsAsBefore
                              : "The new file is in its place, but might not outlast a power cut.");
  }
  return {};
}

}  // namespace limn
