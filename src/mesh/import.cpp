// Chooses the reader by the ending of the name.
#include "limn/mesh/import.h"

#include <algorithm>
#include <cctype>
#include <new>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "mesh/import_limits.h"
#include "mesh/printable.h"
#include "files/regular_file.h"

namespace limn {
namespace {

std::string lower_case_ending(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

}  // namespace

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
    auto text = read_regular_file(path, detail::most_import_bytes);
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
