#pragma once

#include <filesystem>
#include <string>

#include "ui/model.h"

namespace limn::app {

/// What a prompt for a path shows of a folder: folders first, then the files that fit the purpose
/// (meshes and projects to open, projects to save, meshes to export), each in alphabetical
/// order, hidden ones left out. A folder that cannot be read gives `problem`.
/// `serial` is left at 0.
[[nodiscard]] ui::PathPrompt list_folder(ui::PathPrompt::Purpose purpose,
                                         const std::filesystem::path& folder);

/// `path` with the ending that files of this purpose have, where it has none of its own.
[[nodiscard]] std::filesystem::path with_ending(ui::PathPrompt::Purpose purpose,
                                                std::filesystem::path path);

}  // namespace limn::app
