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

/// Answers rules with the faces of the control mesh that show from there, and with cameras: this
/// one and those of camera files, with pictures of the options' size. What is visible is drawn
/// without a window, when it is asked; throws EnvironmentError where that cannot be done.
[[nodiscard]] MakePaintContext paint_context_from(const ViewOptions& options);

}  // namespace limn::cli
