// A temporary beside the target, written, flushed to disk, renamed over it; then the folder is
// flushed too, so that the rename itself survives a power cut.
#include "limn/atomic_file.h"

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
  // A link is written through, so that the file it points to is replaced and not the link.
  std::error_code ignored;
  const std::filesystem::path resolved = std::filesystem::weakly_canonical(path, ignored);
  const std::filesystem::path target = resolved.empty() ? path : resolved;
  const std::filesystem::path folder =
      target.has_parent_path() ? target.parent_path() : std::filesystem::path(".");

  struct stat before {};
  const bool is_there = ::stat(target.c_str(), &before) == 0;
  if (is_there && !S_ISREG(before.st_mode)) {
    return fail(ErrorKind::kFailed, "is not a regular file; choose another name", path.string());
  }

  std::string temporary = (folder / ("." + target.filename().string() + ".XXXXXX")).string();
  const int descriptor = ::mkostemp(temporary.data(), O_CLOEXEC);
  if (descriptor < 0) {
    return system_failure(path, "cannot write in this folder", errno);
  }
  const auto give_up = [&](std::string_view what, int error) {
    ::close(descriptor);
    ::unlink(temporary.c_str());
    return system_failure(path, what, error);
  };

  DescriptorBuffer buffer(descriptor);
  std::ostream out(&buffer);
  write(out);
  out.flush();
  if (buffer.error() != 0 || !out) {
    return give_up("cannot write", buffer.error() != 0 ? buffer.error() : EIO);
  }
  // mkostemp makes private files: keep the old file's rights, or give what the umask allows.
  const mode_t mask = ::umask(0);
  ::umask(mask);
  ::fchmod(descriptor, is_there ? before.st_mode & 07777U : 0666U & ~mask);
  if (::fsync(descriptor) != 0) {
    return give_up("cannot flush to disk", errno);
  }
  if (::close(descriptor) != 0) {
    const int error = errno;
    ::unlink(temporary.c_str());
    return system_failure(path, "cannot finish writing", error);
  }
  if (::rename(temporary.c_str(), target.c_str()) != 0) {
    const int error = errno;
    ::unlink(temporary.c_str());
    return system_failure(path, "cannot replace the file", error);
  }
  flush_folder(folder);
  return {};
}

}  // namespace limn
