#include <memory>
#include <string>

#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Error.hpp>
#include <CLI/Formatter.hpp>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/fine_option.h"
#include "limn/document/commands.h"
#include "limn/document/project_file.h"
#include "limn/mesh/import.h"

namespace limn::cli {
namespace {

struct ReattachOptions {
  std::string project;
  std::string mesh;
  std::string output;
  bool has_json = false;
};

std::string count_of(std::size_t count, const char* noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

void report(const PaintingTransfer& transfer, const ReattachOptions& options) {
  const std::size_t faces = transfer.depths.size();
  if (options.has_json) {
    const nlohmann::ordered_json json = {
        {"faces", faces},
        {"matched_by", transfer.matching == FaceMatching::kVertices ? "vertices" : "order"},
        {"new_faces", transfer.new_faces},
        {"lost_faces", transfer.lost_faces},
        {"kept_creases", transfer.kept_creases},
        {"lost_creases", transfer.lost_creases}};
    fmt::print("{}\n", json.dump(2));
    return;
  }
  fmt::print("{} of {} found again{}\n", count_of(faces - transfer.new_faces.size(), "face"), faces,
             transfer.matching == FaceMatching::kOrder
                 ? ", by their numbers: the vertices have moved"
                 : "");
  if (!transfer.new_faces.empty()) {
    fmt::print("{} new and unpainted\n", count_of(transfer.new_faces.size(), "face"));
  }
  if (!transfer.lost_faces.empty()) {
    print_note(fmt::format("{} of {} gone: what was painted there is lost",
                           count_of(transfer.lost_faces.size(), "painted face"), options.project));
  }
  if (transfer.lost_creases > 0) {
    print_note(fmt::format("{} gone", count_of(transfer.lost_creases, "sharp edge or vertex")));
  }
}

Result<void> reattach(const ReattachOptions& options) {
  Result<Project> project = load_project(options.project);
  if (!project) {
    return tl::unexpected(std::move(project.error()));
  }
  Result<ImportedMesh> mesh = import_mesh(options.mesh);
  if (!mesh) {
    return tl::unexpected(std::move(mesh.error()));
  }
  print_import_report(mesh->report, options.mesh);
  Document& document = project->document;
  PaintingTransfer transfer =
      transfer_painting(*document.control, document.depths.values(), mesh->mesh);
  report(transfer, options);
  if (const auto demands = demands_text(document)) {
    print_note(fmt::format("{}: {} on faces finer than control faces stay behind", options.project,
                           *demands));
  }
  reattach_command(std::move(transfer))->apply(document);
  document.mesh_path = options.mesh;
  document.opened = document.control;
  if (options.output.empty()) {
    return {};
  }
  return save_project(options.output, document, project->view);
}

}  // namespace

void add_reattach_command(CLI::App& program, Work& work) {
  CLI::App* command = program.add_subcommand(
      "reattach",
      "Carry the painting and creases of a project over to a mesh file that another program has "
      "written: its faces may be reordered, its vertices renumbered and rounded");
  const auto options = std::make_shared<ReattachOptions>();
  command->add_option("PROJECT", options->project, "A project (.limn)")->required();
  command->add_option("MESH", options->mesh, "The mesh to take up its painting")->required();
  command->add_option("-o,--output", options->output,
                      "The project to write (.limn); left out, only what would be matched is told");
  command->add_flag("--json", options->has_json, "What was matched as JSON on standard output");
  command->callback([options, &work] {
    if (!options->output.empty() && !options->output.ends_with(".limn")) {
      throw CLI::ValidationError("-o", "is a project and ends in .limn");
    }
    work = [options] { return reattach(*options); };
  });
}

}  // namespace limn::cli
