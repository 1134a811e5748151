#include "app/fonts.h"

#include <fstream>
#include <iterator>
#include <string>

namespace limn::app {
namespace {

std::vector<std::byte> read_file(std::string_view path) {
  std::ifstream file(std::string(path), std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(file), {});
  const auto* data = reinterpret_cast<const std::byte*>(bytes.data());
  return {data, data + bytes.size()};
}

}  // namespace

ui::FontFiles load_fonts() {
  for (const ui::FontPaths& paths : ui::font_candidates()) {
    ui::FontFiles files{read_file(paths.regular), read_file(paths.semi_bold)};
    if (!files.regular.empty() && !files.semi_bold.empty()) {
      return files;
    }
  }
  return {};
}

}  // namespace limn::app
