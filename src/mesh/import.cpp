// Opens without blocking and looks at what was opened before reading, so that a pipe or a device
// is refused instead of waited for.
#include "limn/mesh/import.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <new>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "mesh/import_limits.h"
#include "mesh/printable.h"

namespace limn {
namespace {

/// Owns a file descriptor.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) {
      ::close(number_);
    }
  }
  [[nodiscard]] int number() const noexcept { return number_; }

 private:
  int number_;
};

tl::unexpected<Error> cannot_read(const std::filesystem::path& path, int error) {
  return fail(ErrorKind::kBadInput,
              error == ENOENT ? "There is no such file."
                              : fmt::format("Cannot read the file: {}.",
                                            std::generic_category().message(error)),
              path.string());
}

Result<std::string> read_file(const std::filesystem::path& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  struct stat about {};
  if (file.number() < 0 || ::fstat(file.number(), &about) != 0) {
    return cannot_read(path, errno);
  }
  if (S_ISDIR(about.st_mode)) {
    return fail(ErrorKind::kBadInput, "This is a folder; choose a mesh file in it.", path.string());
  }
  if (!S_ISREG(about.st_mode)) {
    return fail(ErrorKind::kBadInput, "This is not a regular file but a device, pipe or socket.",
                path.string());
  }
  const auto expected = static_cast<std::size_t>(about.st_size);
  if (expected > detail::most_import_bytes) {
    return fail(ErrorKind::kBadInput, detail::too_large(expected), path.string());
  }

  // The file may grow or shrink meanwhile, and some tell no size: read until the end.
  std::string text;
  std::size_t filled = 0;
  text.resize(expected + 1);
  while (true) {
    const ssize_t got = ::read(file.number(), text.data() + filled, text.size() - filled);
    if (got < 0 && errno == EINTR) {
      continue;
    }
    if (got < 0) {
      return cannot_read(path, errno);
    }
    if (got == 0) {
      break;
    }
    filled += static_cast<std::size_t>(got);
    if (filled > detail::most_import_bytes) {
      return fail(ErrorKind::kBadInput, detail::too_large(filled), path.string());
    }
    if (filled == text.size()) {
      text.resize(2 * text.size());
    }
  }
  text.resize(filled);
  return text;
}

std::string lower_case_ending(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

}  // namespace

std::string detail::too_large(std::size_t bytes) {
  return fmt::format("The file has {} bytes; files of up to {} GiB are read.", bytes,
                     most_import_bytes >> 30U);
}

Result<ImportedMesh> import_mesh(const std::filesystem::path& path) {
  try {
    std::error_code ignored;
    const bool is_file = std::filesystem::is_regular_file(path, ignored);
    if (const std::string ending = lower_case_ending(path); is_file && ending != ".obj") {
      return fail(ErrorKind::kBadInput,
                  ending.empty()
                      ? std::string("The name has no ending to tell the format by; meshes are read "
                                    "from .obj files.")
                      : fmt::format("Files with the ending {} are not read; meshes are read from "
                                    ".obj files.",
                                    detail::printable(ending)),
                  path.string());
    }
    auto text = read_file(path);
    if (!text) {
      return tl::unexpected<Error>(std::move(text.error()));
    }
    if (text->empty()) {
      return fail(ErrorKind::kBadInput, "The file is empty.", path.string());
    }
    return import_obj(*text, path.string());
  } catch (const std::bad_alloc&) {
    return fail(ErrorKind::kFailed, "There is not enough memory to read this file.", path.string());
  }
}

}  // namespace limn
