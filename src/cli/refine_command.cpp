#include <memory>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/input.h"
#include "cli/mesh_output.h"
#include "cli/report.h"
#include "cli/view_options.h"
#include "limn/document/export_settings.h"

namespace limn::cli {
namespace {

struct RefineOptions {
  PaintingOptions painting;
  ViewOptions view;
  MeshOutput output;
  bool json = false;
};

constexpr std::string_view kProjectEnding = ".limn";

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

Result<void> refine_and_write(const RefineOptions& options) {
  const Result<Project> project = open_painted(options.painting, visible_faces_from(options.view));
  if (!project) {
    return tl::unexpected(project.error());
  }
  const Document& document = project->document;
  const Result<Derived> derived = derive(*project, options.painting);
  if (!derived) {
    return tl::unexpected(derived.error());
  }
  if (!options.output.path.empty()) {
    Result<void> written = write_output(options, *project, *derived);
    if (!written) {
      return written;
    }
  }
  if (options.json) {
    fmt::print("{}\n", refinement_report(document, *derived).dump(2));
  } else {
    fmt::print(stderr, "{}", refinement_text(document, *derived));
  }
  return {};
}

}  // namespace

void add_refine_command(CLI::App& program, Work& work) {
  CLI::App* command = program.add_subcommand(
      "refine", "Paint a mesh by rules and subdivide it adaptively, without a window");
  const auto options = std::make_shared<RefineOptions>();
  add_painting_options(*command, options->painting);
  add_view_options(*command, options->view);
  command
      ->add_option("-o,--output", options->output.path,
                   "The refined mesh (.obj, .ply, .off or .stl, or - for standard output), or the "
                   "painted control mesh as "
                   "a project (.limn); left out, only the numbers are reported")
      ->type_name("OUT");
  add_format_options(*command, options->output);
  command->add_flag("--json", options->json, "The numbers as JSON on standard output");
  command->callback([options, &work] {
    if (!options->output.path.ends_with(kProjectEnding)) {
      check_output(options->output, options->json, " or .limn");
    }
    work = [options] { return refine_and_write(*options); };
  });
}

}  // namespace limn::cli
