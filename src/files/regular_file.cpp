// Opened without blocking, so that a pipe nobody writes to cannot hold us up, and then asked what
// it is: the answer is about what was opened, whatever happens to the name meanwhile.
#include "files/regular_file.h"

#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "files/descriptor.h"

namespace limn {
namespace {

tl::unexpected<Error> refused(const std::filesystem::path& path, std::string message) {
  return fail(ErrorKind::kBadInput, std::move(message), path.string());
}

tl::unexpected<Error> cannot_read(const std::filesystem::path& path, int error) {
  return refused(path, error == ENOENT ? "There is no such file."
                                       : fmt::format("Cannot read the file: {}.",
                                                     std::generic_category().message(error)));
}

}  // namespace

std::string too_large(std::size_t bytes, std::size_t most_bytes) {
  const bool is_in_gib = most_bytes >= std::size_t{1} << 30U;
  return fmt::format("The file has {} bytes; files of up to {} {} are read.", bytes,
                     most_bytes >> (is_in_gib ? 30U : 20U), is_in_gib ? "GiB" : "MiB");
}

Result<std::string> read_regular_file(const std::filesystem::path& path, std::size_t most_bytes) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  struct stat status {};
  if (!file.is_open() || ::fstat(file.get(), &status) != 0) {
    return cannot_read(path, errno);
  }
  if (S_ISDIR(status.st_mode)) {
    return refused(path, "This is a folder, not a file.");
  }
  if (!S_ISREG(status.st_mode)) {
    return refused(path, "This is not a regular file but a device, pipe or socket.");
  }
  const auto announced = static_cast<std::size_t>(status.st_size);
  if (announced > most_bytes) {
    return refused(path, too_large(announced, most_bytes));
  }
  // One byte more than announced tells the end of a file that did not grow from one that did.
  std::string bytes(announced + 1, '\0');
  std::size_t length = 0;
  while (true) {
    const ssize_t count = ::read(file.get(), bytes.data() + length, bytes.size() - length);
    if (count < 0 && errno == EINTR) {
      continue;
    }
    if (count < 0) {
      return cannot_read(path, errno);
    }
    if (count == 0) {
      break;
    }
    length += static_cast<std::size_t>(count);
    if (length > most_bytes) {
      return refused(path, too_large(length, most_bytes));
    }
    if (length == bytes.size()) {
      bytes.resize(bytes.size() + bytes.size() / 2 + 1);
    }
  }
  bytes.resize(length);
  return bytes;
}

}  // namespace limn
