#pragma once

#include <string>

#include "limn/document/project_file.h"
#include "limn/error.h"

namespace CLI {
class App;
}

namespace limn::app {

/// What the window is started with.
struct WindowOptions {
  std::string input;  ///< A mesh file, a project or a bundled mesh's name; empty: the creature.
  /// Where the state of the window is written as JSON whenever it comes to rest, for tests that
  /// drive it from outside; empty: nowhere.
  std::string status_file;
  /// Where everything that is done is written down, to be played back by `limn replay`; empty:
  /// nowhere.
  std::string record;
  /// For a course: its keys, and the panel of schemes unfolded. Neither is kept for the next run.
  bool is_classroom = false;
};

/// Adds the positional argument MESH and the window's flags.
void add_window_options(CLI::App& program, WindowOptions& options);

/// Opens the window and runs until it is closed.
/// An input that cannot be opened is told in the window, over the creature; where there is no
/// window either, that is the error, kBadInput. Throws render::EnvironmentError where there is no
/// display or no OpenGL 4.5.
[[nodiscard]] Result<void> run_window(const WindowOptions& options);
/// The same with what was opened before; `options.input` is not looked at.
[[nodiscard]] Result<void> run_window(Project project, const WindowOptions& options);

}  // namespace limn::app
