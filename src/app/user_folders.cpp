// The XDG base directory and user directory conventions, read from the environment and from
// `user-dirs.dirs`, whose lines look like XDG_PICTURES_DIR="$HOME/Pictures".
#include "app/user_folders.h"

#include <cstdlib>
#include <fstream>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace limn::app {
namespace {

namespace fs = std::filesystem;

/// An environment variable that holds an absolute path, as the XDG conventions require.
fs::path folder_from_environment(const char* name) {
  const char* value = std::getenv(name);
  const fs::path folder = value == nullptr ? "" : value;
  return folder.is_absolute() ? folder : fs::path();
}

fs::path base_config_folder() {
  if (fs::path folder = folder_from_environment("XDG_CONFIG_HOME"); !folder.empty()) {
    return folder;
  }
  const fs::path home = folder_from_environment("HOME");
  return home.empty() ? home : home / ".config";
}

fs::path pictures_in_user_dirs(const fs::path& home) {
  std::ifstream file(base_config_folder() / "user-dirs.dirs");
  constexpr std::string_view key = "XDG_PICTURES_DIR=\"";
  constexpr std::string_view home_variable = "$HOME/";
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with(key) || line.back() != '"') {
      continue;
    }
    const std::string value = line.substr(key.size(), line.size() - key.size() - 1);
    return value.starts_with(home_variable) ? home / value.substr(home_variable.size())
                                            : fs::path(value);
  }
  return {};
}

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return !path.empty() && fs::is_directory(path, ignored);
}

}  // namespace

fs::path config_folder() {
  const fs::path base = base_config_folder();
  return base.empty() ? base : base / "limn";
}

fs::path recovery_folder() {
  fs::path base = folder_from_environment("XDG_STATE_HOME");
  if (const fs::path home = folder_from_environment("HOME"); base.empty() && !home.empty()) {
    base = home / ".local/state";
  }
  return base.empty() ? base : base / "limn/recovery";
}

fs::path pictures_folder() {
  if (fs::path folder = folder_from_environment("XDG_PICTURES_DIR"); is_folder(folder)) {
    return folder;
  }
  if (const fs::path home = folder_from_environment("HOME"); !home.empty()) {
    for (const fs::path& folder : {pictures_in_user_dirs(home), home / "Pictures"}) {
      if (is_folder(folder)) {
        return folder;
      }
    }
  }
  std::error_code error;
  fs::path current = fs::current_path(error);
  return error ? fs::path(".") : current;
}

fs::path numbered_file(const fs::path& folder, const std::string& stem, const std::string& ending) {
  std::error_code ignored;
  for (int number = 1;; ++number) {
    fs::path path = folder / fmt::format("{}-{:03}{}", stem, number, ending);
    if (!fs::exists(path, ignored)) {
      return path;
    }
  }
}

}  // namespace limn::app
