#include "cli/command_line.h"

#include <exception>
#include <string>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "app/run_window.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "render/environment_error.h"

namespace limn::cli {
namespace {

/// Command-line mistakes all give 2, whatever number the parser has for them; --help gives 0.
int parse_failure(const CLI::App& program, const CLI::ParseError& error) {
  return program.exit(error) == 0 ? 0 : exit_code(ErrorKind::kUsage);
}

int carry_out(const Work& work) {
  Error error;
  try {
    const Result<void> done = work();
    if (done) {
      return 0;
    }
    error = done.error();
  } catch (const render::EnvironmentError& missing) {
    error = {ErrorKind::kEnvironment, missing.what(), {}, 0};
  } catch (const std::bad_alloc&) {
    error = {ErrorKind::kFailed, "not enough memory; lower --levels or --budget", {}, 0};
  }
  print_error(error);
  return exit_code(error.kind);
}

}  // namespace

int run(int argc, char** argv) {
  CLI::App program(
      "Limn: paint on a mesh how smooth each region shall become.\n"
      "Opens a window on MESH, or does one of the subcommands without one.",
      "limn");
  program.set_version_flag("--version", "limn " LIMN_VERSION);
  program.require_subcommand(0, 1);
  program.get_formatter()->column_width(34);

  Work work;
  app::WindowOptions window;
  app::add_window_options(program, window);
  add_refine_command(program, work);
  add_render_command(program, work);
  add_info_command(program, work);
  add_validate_command(program, work);
  add_convert_command(program, work);
  add_subdivide_command(program, work);
  add_schemes_command(program, work);
  add_presets_command(program, work);
  add_compare_command(program, work);
  add_symmetrise_command(program, work);
  add_split_and_flip_command(program, work);
  add_reattach_command(program, work);
  add_recover_command(program, work);
  add_replay_command(program, work);
  add_classroom_command(program, work);

  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return parse_failure(program, error);
  }
  if (!work) {
    work = [&window] { return app::run_window(window); };
  }
  return carry_out(work);
}

}  // namespace limn::cli
