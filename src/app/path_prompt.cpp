#include "app/path_prompt.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <system_error>
#include <tuple>

#include <fmt/format.h>

#include "limn/mesh/mesh_format.h"

namespace limn::app {
namespace {

namespace fs = std::filesystem;
using Purpose = ui::PathPrompt::Purpose;

std::string lower_ending(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

bool fits(Purpose purpose, const fs::path& file) {
  const std::string ending = lower_ending(file);
  switch (purpose) {
    case Purpose::kOpen:
      return ending == ".limn" || format_by_ending(file).has_value();
    case Purpose::kReplaceMesh:
      return ending != ".limn" && fits(Purpose::kOpen, file);
    case Purpose::kSaveProject:
      return ending == ".limn";
    case Purpose::kExportRefined:
      return format_by_ending(file).has_value();
  }
  return false;
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// The folder itself, or the nearest one above it that exists.
fs::path existing_folder(const fs::path& wanted) {
  std::error_code error;
  fs::path folder = fs::absolute(wanted, error).lexically_normal();
  while (!fs::is_directory(folder, error) && folder.has_relative_path()) {
    folder = folder.parent_path();
  }
  return folder;
}

}  // namespace

ui::PathPrompt list_folder(Purpose purpose, const fs::path& folder) {
  ui::PathPrompt prompt;
  prompt.purpose = purpose;
  fs::path shown = existing_folder(folder);
  if (!shown.has_filename() && shown.has_relative_path()) {
    shown = shown.parent_path();
  }
  prompt.folder = shown.string();
  prompt.parent = shown.has_relative_path() ? shown.parent_path().string() : std::string();

  std::error_code error;
  fs::directory_iterator entry(shown, fs::directory_options::skip_permission_denied, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    ui::FolderEntry row;
    row.name = entry->path().filename().string();
    std::error_code ignored;
    row.is_folder = entry->is_directory(ignored);
    if (row.name.starts_with('.') || (!row.is_folder && !fits(purpose, entry->path()))) {
      continue;
    }
    if (!row.is_folder) {
      const auto size = entry->file_size(ignored);
      row.bytes = ignored ? 0 : size;
    }
    prompt.entries.push_back(std::move(row));
  }
  if (error) {
    prompt.problem = fmt::format("{} cannot be read: {}.", prompt.folder, error.message());
  }
  const auto key = [](const ui::FolderEntry& row) {
    return std::tuple(!row.is_folder, lower(row.name), row.name);
  };
  std::sort(prompt.entries.begin(), prompt.entries.end(),
            [&](const auto& a, const auto& b) { return key(a) < key(b); });
  return prompt;
}

fs::path with_ending(Purpose purpose, fs::path path) {
  if (purpose == Purpose::kOpen || purpose == Purpose::kReplaceMesh) {
    return path;
  }
  if (path.extension().empty()) {
    path += purpose == Purpose::kExportRefined ? ".obj" : ".limn";
  } else if (purpose == Purpose::kSaveProject && lower_ending(path) != ".limn") {
    path += ".limn";
  } else if (purpose == Purpose::kExportRefined && !format_by_ending(path)) {
    path += ".obj";
  }
  return path;
}

}  // namespace limn::app
