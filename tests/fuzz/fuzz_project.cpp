// A project that is read is written, and what is written is read again and written the same.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>

#include "limn/document/project_file.h"

namespace {

std::string written(const limn::Project& project) {
  std::ostringstream out;
  limn::write_project(out, project.document, project.view);
  return out.str();
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it so.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto project = limn::parse_project(text, "fuzz");
  if (!project) {
    return 0;
  }
  const std::string first = written(*project);
  const auto again = limn::parse_project(first, "written");
  if (!again || written(*again) != first) {
    std::fprintf(stderr, "%s\n%s\n", again ? "another project" : to_string(again.error()).c_str(),
                 first.c_str());
    std::abort();
  }
  return 0;
}
