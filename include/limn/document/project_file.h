#pragma once

#include <filesystem>
#include <optional>

#include "limn/document/document.h"
#include "limn/document/view_state.h"
#include "limn/error.h"

namespace limn {

struct Project {
  Document document;
  std::optional<ViewState> view;
};

/// Writes a `.limn` project atomically: JSON with a format version, the control mesh, the depths,
/// the settings, the stage and the view. Self-contained: the mesh file is not needed to open it
/// again.
[[nodiscard]] Result<void> save_project(const std::filesystem::path& path, const Document& document,
                                        const std::optional<ViewState>& view);

/// Reads a project, validating everything in it as if it were a mesh file.
/// Errors: kBadInput naming the JSON path of the culprit, and a version newer than this program.
[[nodiscard]] Result<Project> load_project(const std::filesystem::path& path);

/// A camera file is the `view` object of a project alone.
[[nodiscard]] Result<ViewState> load_view(const std::filesystem::path& path);
[[nodiscard]] Result<void> save_view(const std::filesystem::path& path, const ViewState& view);

}  // namespace limn
