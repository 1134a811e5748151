#pragma once

#include <filesystem>
#include <string>

namespace limn::app {

/// Where Limn keeps its preferences: `$XDG_CONFIG_HOME/limn`, or `~/.config/limn`. Empty where
/// neither is set; the folder need not exist.
[[nodiscard]] std::filesystem::path config_folder();

/// Where Limn keeps copies of unsaved work: `$XDG_STATE_HOME/limn/recovery`, or that in
/// `~/.local/state`. Empty where neither is set; the folder need not exist.
[[nodiscard]] std::filesystem::path recovery_folder();

/// Where screenshots go: the user's pictures folder (`$XDG_PICTURES_DIR`, `user-dirs.dirs`,
/// `~/Pictures`) where there is one, else the current folder.
[[nodiscard]] std::filesystem::path pictures_folder();

/// `folder/stem-001.ending`, with the first number that is not taken yet.
[[nodiscard]] std::filesystem::path numbered_file(const std::filesystem::path& folder,
                                                  const std::string& stem,
                                                  const std::string& ending);

}  // namespace limn::app
