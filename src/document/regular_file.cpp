// Opened without blocking, so that a pipe nobody writes to cannot hold us up, and then asked what
// it is: the answer is about what was opened, whatever happens to the name meanwhile.
#include "regular_file.h"

#include <cerrno>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

namespace limn {
namespace {

class Descriptor {
 public:
  explicit Descriptor(int value) noexcept : value_(value) {}
  ~Descriptor() {
    if (value_ >= 0) {
      ::close(value_);
    }
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int get() const noexcept { return value_; }

 private:
  int value_;
};

tl::unexpected<Error> refused(const std::filesystem::path& path, std::string message) {
  return fail(ErrorKind::kBadInput, std::move(message), path.string());
}

tl::unexpected<Error> refused(const std::filesystem::path& path, std::string_view what, int error) {
  return refused(path, fmt::format("{}: {}.", what, std::generic_category().message(error)));
}

}  // namespace

Result<std::string> read_regular_file(const std::filesystem::path& path, std::size_t most_bytes) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  if (file.get() < 0) {
    return refused(path, "Cannot open the file", errno);
  }
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) {
    return refused(path, "Cannot read the file", errno);
  }
  if (S_ISDIR(status.st_mode)) {
    return refused(path, "This is a folder, not a file.");
  }
  if (!S_ISREG(status.st_mode)) {
    return refused(path, "This is not a regular file.");
  }
  const auto too_big = [&] {
    return refused(path, fmt::format("The file is larger than {} MiB, more than Limn reads.",
                                     most_bytes >> 20U));
  };
  if (static_cast<std::uintmax_t>(status.st_size) > most_bytes) {
    return too_big();
  }
  // One byte more than announced tells the end of a file that did not grow from one that did.
  std::string bytes(static_cast<std::size_t>(status.st_size) + 1, '\0');
  std::size_t length = 0;
  while (true) {
    const ssize_t count = ::read(file.get(), bytes.data() + length, bytes.size() - length);
    if (count < 0 && errno == EINTR) {
      continue;
    }
    if (count < 0) {
      return refused(path, "Cannot read the file", errno);
    }
    if (count == 0) {
      break;
    }
    length += static_cast<std::size_t>(count);
    if (length > most_bytes) {
      return too_big();
    }
    if (length == bytes.size()) {
      bytes.resize(bytes.size() + bytes.size() / 2 + 1);
    }
  }
  bytes.resize(length);
  return bytes;
}

}  // namespace limn
