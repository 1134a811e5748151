#pragma once

#include <filesystem>
#include <optional>

#include "limn/document/document.h"
#include "limn/document/view_state.h"
#include "limn/error.h"

namespace limn {

/// What a project holds: the document, and the camera where one was saved with it.
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

/// Reads a camera file: the `view` object of a project alone.
/// Errors: kBadInput naming the JSON path of the culprit.
[[nodiscard]] Result<ViewState> load_view(const std::filesystem::path& path);
/// Writes a camera file atomically. Errors: kFailed, also for a view that could not be read again.
[[nodiscard]] Result<void> save_view(const std::filesystem::path& path, const ViewState& view);

}  // namespace limn
