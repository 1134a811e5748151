#pragma once

#include <string>

#include "cli/input.h"
#include "limn/document/view_state.h"
#include "render/coordinates.h"

namespace limn::cli {

/// Where a subcommand looks from.
struct ViewOptions {
  std::string view_name;    ///< A named view; empty: the project's own view, else three-quarter.
  std::string camera_file;  ///< A camera file; wins over a name.
  render::FramebufferSize size{1280, 960};
};

/// Adds --view, --camera and --size.
void add_view_options(CLI::App& command, ViewOptions& options);

/// The view in force for an opened project.
[[nodiscard]] Result<ViewState> resolve_view(const ViewOptions& options, const Project& project);

/// Answers `visible:...` rules with the faces of the control mesh that show from there. Draws
/// without a window; throws EnvironmentError where that cannot be done.
[[nodiscard]] MakeVisibleFaces visible_faces_from(const ViewOptions& options);

}  // namespace limn::cli
