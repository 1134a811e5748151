#include <memory>
#include <string>

#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/input.h"
#include "cli/report.h"

namespace limn::cli {

void add_info_command(CLI::App& program, Work& work) {
  struct Options {
    std::string input;
    bool json = false;
  };
  CLI::App* command = program.add_subcommand(
      "info", "Counts of a mesh: faces by sides, boundary, components, what was mended");
  const auto options = std::make_shared<Options>();
  add_input_option(*command, options->input);
  command->add_flag("--json", options->json, "JSON on standard output");
  command->callback([options, &work] {
    work = [options]() -> Result<void> {
      return open_input(options->input).map([&](const Project& project) {
        if (options->json) {
          fmt::print("{}\n", control_report(project.document).dump(2));
        } else {
          fmt::print("{}", control_text(project.document));
        }
      });
    };
  });
}

}  // namespace limn::cli
