#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <nlohmann/json.hpp>

#include "cli/batch.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "cli/limit_report.h"
#include "cli/mesh_output.h"
#include "cli/report.h"
#include "cli/view_options.h"
#include "limn/document/export_settings.h"

namespace limn::cli {
namespace {

struct RefineOptions {
  std::vector<std::string> inputs;
  PaintingOptions painting;  ///< Its input is each of them in turn.
  ViewOptions view;
  MeshOutput output;
  std::string output_folder;
  bool json = false;
  bool steps = false;  ///< Of the legalisation, too.
};

namespace fs = std::filesystem;

Result<void> write_output(const RefineOptions& options, const Project& project,
                          const Derived& derived) {
  const Document& document = project.document;
  if (options.output.path.ends_with(kProjectEnding)) {
    return resolve_view(options.view, project).and_then([&](const ViewState& view) {
      return save_project(options.output.path, document, view);
    });
  }
  if (derived.refinement) {
    return write_mesh(options.output, *derived.refinement->mesh, export_settings(document));
  }
  // The boundary rule is the document's, whatever the mesh came with.
  MeshAttributes attributes = document.control->attributes();
  if (!document.control->is_closed()) {
    attributes.corners = document.settings.corners;
  }
  return write_mesh(options.output, document.control->with_attributes(std::move(attributes)),
                    export_settings(document));
}

/// Refines the one input of `options`. Its report is empty where nobody asked for it.
Result<nlohmann::ordered_json> refine_and_write(const RefineOptions& options) {
  const Result<Project> project = open_painted(options.painting, paint_context_from(options.view));
  if (!project) {
    return tl::unexpected(project.error());
  }
  const Document& document = project->document;
  const Result<Derived> derived = derive(*project, options.painting);
  if (!derived) {
    return tl::unexpected(derived.error());
  }
  if (!options.output.path.empty()) {
    if (Result<void> written = write_output(options, *project, *derived); !written) {
      return tl::unexpected(written.error());
    }
  }
  const auto reached = measure_reached(options.painting, document, *derived);
  if (!reached) {
    return tl::unexpected(reached.error());
  }
  nlohmann::ordered_json report;
  if (options.json) {
    report = refinement_report(document, *derived);
    if (*reached) {
      report["distance_to_limit"] = reached_report(**reached);
    }
    if (options.steps) {
      report["legalisation"] = legalisation_report(document, *derived);
    }
    if (!options.output_folder.empty()) {
      report["output"] = options.output.path;
    }
  } else {
    fmt::print(stderr, "{}{}{}", options.inputs.size() > 1 ? options.painting.input + "\n" : "",
               refinement_text(document, *derived), *reached ? reached_text(**reached) : "");
  }
  return report;
}

/// Where the result for an input goes in the output folder: `spot.ply` to `spot-refined.obj`.
std::string path_in_folder(const RefineOptions& options, const std::string& input) {
  const fs::path name(input == "-" ? "standard-input" : input);
  const MeshFormat format = options.output.format.value_or(MeshFormat::kObj);
  return (fs::path(options.output_folder) /
          fmt::format("{}-refined{}", name.stem().string(), ending_of(format)))
      .string();
}

/// Mistakes that are known before any work is done.
void check_batch(const RefineOptions& options) {
  if (options.output_folder.empty()) {
    if (options.inputs.size() > 1 && !options.output.path.empty()) {
      throw CLI::ValidationError("--output", "one file for several meshes; give --output-folder");
    }
    return;
  }
  if (!options.output.path.empty()) {
    throw CLI::ValidationError("--output-folder", "goes without --output");
  }
  std::set<std::string> paths;
  for (const std::string& input : options.inputs) {
    if (const std::string path = path_in_folder(options, input); !paths.insert(path).second) {
      throw CLI::ValidationError("--output-folder",
                                 fmt::format("two meshes would be written to {}", path));
    }
  }
}

Result<void> refine_all(const RefineOptions& options) {
  if (!options.output_folder.empty()) {
    std::error_code error;
    fs::create_directories(options.output_folder, error);
    if (error) {
      return fail(ErrorKind::kFailed, fmt::format("cannot make this folder: {}", error.message()),
                  options.output_folder);
    }
  }
  Batch batch(options.inputs);
  for (const std::string& input : options.inputs) {
    batch.run(input, [&] {
      RefineOptions one = options;
      one.painting.input = input;
      if (!options.output_folder.empty()) {
        one.output.path = path_in_folder(options, input);
      }
      return refine_and_write(one);
    });
  }
  Result<void> result = batch.result();
  if (options.json && (result || options.inputs.size() > 1)) {
    fmt::print("{}\n", batch.report().dump(2));
  }
  return result;
}

}  // namespace

void add_refine_command(CLI::App& program, Work& work) {
  CLI::App* command = program.add_subcommand(
      "refine", "Paint a mesh by rules and subdivide it adaptively, without a window");
  const auto options = std::make_shared<RefineOptions>();
  add_inputs_option(*command, options->inputs);
  add_painting_options(*command, options->painting);
  add_view_options(*command, options->view);
  command
      ->add_option("-o,--output", options->output.path,
                   "The refined mesh (.obj, .ply, .off or .stl, or - for standard output), or the "
                   "painted control mesh as "
                   "a project (.limn); left out, only the numbers are reported")
      ->type_name("OUT");
  command
      ->add_option("--output-folder", options->output_folder,
                   "For any number of meshes: a folder for the results, NAME-refined.obj or as "
                   "--format says. A bad file is told and the others are refined all the same; the "
                   "exit code is then that of the first failure")
      ->type_name("DIR");
  add_format_options(*command, options->output);
  CLI::Option* json =
      command->add_flag("--json", options->json, "The numbers as JSON on standard output");
  command
      ->add_flag("--steps", options->steps,
                 "With --json: every vertex that is raised to remove illegal faces, in order, and "
                 "what it was chosen by")
      ->needs(json);
  command->callback([options, &work] {
    if (!options->output.path.ends_with(kProjectEnding)) {
      check_output(options->output, options->json, " or .limn");
    }
    check_batch(*options);
    work = [options] { return refine_all(*options); };
  });
}

}  // namespace limn::cli
