#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

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
/// the settings, the stage, the view and a checksum. Self-contained: the mesh file is not needed to
/// open it again.
/// Errors: kFailed, also for a document or a view that could not be read again.
[[nodiscard]] Result<void> save_project(const std::filesystem::path& path, const Document& document,
                                        const std::optional<ViewState>& view);

/// Reads a project, validating everything in it as if it were a mesh file.
/// Errors: kBadInput naming the JSON path of the culprit, a version newer than this program, and
/// whatever does not fit the checksum. Projects without one, of older programs, are read.
[[nodiscard]] Result<Project> load_project(const std::filesystem::path& path);

/// The text of a project, as `save_project` writes and `load_project` reads it. `source` is for
/// messages; the document's project path stays empty.
void write_project(std::ostream& out, const Document& document,
                   const std::optional<ViewState>& view);
[[nodiscard]] Result<Project> parse_project(std::string_view text, const std::string& source);

/// Reads a camera file: the `view` object of a project alone.
/// Errors: kBadInput naming the JSON path of the culprit.
[[nodiscard]] Result<ViewState> load_view(const std::filesystem::path& path);
/// Writes a camera file atomically. Errors: kFailed, also for a view that could not be read again.
[[nodiscard]] Result<void> save_view(const std::filesystem::path& path, const ViewState& view);

}  // namespace limn
