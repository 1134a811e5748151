#include <CLI/CLI.hpp>

#include "app/run_window.h"

namespace limn::app {

void add_window_options(CLI::App& program, WindowOptions& options) {
  program.add_option("MESH", options.input,
                     "Mesh (.obj, .ply, .off or .stl), project (.limn) or bundled mesh to open; "
                     "without, the creature");
  program.add_option("--record", options.record,
                     "Write everything that is done in the window to this file, for a bug report "
                     "or a demonstration; limn replay does it again");
  program
      .add_option("--status-file", options.status_file,
                  "Write the state of the window to this file whenever it comes to rest")
      ->group("");
}

}  // namespace limn::app
