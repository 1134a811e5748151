#include <memory>
#include <string>

#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/fine_option.h"
#include "cli/input.h"
#include "cli/mesh_output.h"
#include "limn/document/export_settings.h"

namespace limn::cli {
namespace {

struct ConvertOptions {
  std::string input;
  MeshOutput output;
  BuildSettings build;
};

Result<void> convert(const ConvertOptions& options) {
  return open_quietly(options.input, options.build).and_then([&](const Project& project) {
    const Document& document = project.document;
    print_import_report(document.import_report, options.input);
    if (options.output.path.ends_with(kProjectEnding)) {
      return save_project(options.output.path, document, project.view);
    }
    if (const auto demands = demands_text(document)) {
      print_note(
          fmt::format("{}: {} on faces finer than control faces stay behind; projects "
                      "(.limn) hold them",
                      options.input, *demands));
    }
    ExportSettings settings = export_settings(document);
    if (document.depths.deepest() == 0) {
      settings.depths = {};  // Nothing is painted, and the file is to say no more than it did.
    }
    return write_mesh(options.output, *document.control, settings);
  });
}

}  // namespace

void add_convert_command(CLI::App& program, Work& work) {
  CLI::App* command = program.add_subcommand(
      "convert", "Read a mesh and write it in another format, with all that format holds");
  const auto options = std::make_shared<ConvertOptions>();
  add_input_option(*command, options->input);
  command
      ->add_option("OUT", options->output.path,
                   "The mesh (.obj, .ply, .off or .stl, or - for standard output) or a project "
                   "(.limn)")
      ->required();
  add_format_options(*command, options->output);
  command->add_flag("--strict", options->build.is_strict,
                    "Refuse what would have to be mended (exit code 3)");
  command->callback([options, &work] {
    if (!options->output.path.ends_with(kProjectEnding)) {
      check_output(options->output, false, " or .limn");
    }
    work = [options] { return convert(*options); };
  });
}

}  // namespace limn::cli
