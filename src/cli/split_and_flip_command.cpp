#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <CLI/Validators.hpp>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/input.h"
#include "cli/level_text.h"
#include "cli/mesh_output.h"
#include "cli/scheme_options.h"
#include "limn/editing/edge_edits.h"
#include "limn/subdivision/schemes/uniform.h"

namespace limn::cli {
namespace {

struct SplitAndFlipOptions {
  std::string input;
  MeshOutput output;
  std::optional<CornerRule> corners;
  int levels = 1;
  std::uint64_t face_budget = 50'000'000;
  bool is_fitted = false;
};

/// Whole steps of Loop's scheme by edits of single edges.
Result<void> upsample_and_write(const SplitAndFlipOptions& options) {
  const Result<Project> project = open_input(options.input);
  if (!project) {
    return tl::unexpected(project.error());
  }
  const Document& document = project->document;
  Result<std::shared_ptr<const ControlMesh>> mesh =
      fit_mesh(document.control, Scheme::kLoop, options.is_fitted, document.name);
  if (!mesh) {
    return tl::unexpected(mesh.error());
  }
  const SchemeSettings loop{.scheme = Scheme::kLoop};
  if (auto affordable = check_budget(**mesh, loop, options.levels, options.face_budget);
      !affordable) {
    return affordable;
  }
  TerminalProgress progress;
  for (int level = 1; level <= options.levels; ++level) {
    if (!progress.report(double(level - 1) / options.levels, fmt::format("Level {}", level))) {
      return fail(ErrorKind::kCancelled, "The subdivision was cancelled.");
    }
    const Stopwatch watch;
    mesh = upsample_by_split_and_flip(**mesh, options.corners.value_or(document.settings.corners));
    if (!mesh) {
      return tl::unexpected(mesh.error());
    }
    const ControlMesh& made = **mesh;
    progress.note(level_text(
        {level, {made.vertex_count(), made.edge_count(), made.face_count()}, watch.seconds()}));
  }
  return write_mesh(options.output, **mesh);
}

}  // namespace

void add_split_and_flip_command(CLI::App& program, Work& work) {
  CLI::App* command = program.add_subcommand(
      "split-and-flip",
      "Loop's scheme by hand: split every edge, flip every new edge that joins an old and a new "
      "vertex");
  const auto options = std::make_shared<SplitAndFlipOptions>();
  add_input_option(*command, options->input);
  add_output_option(*command, options->output, true);
  add_corners_option(*command, options->corners);
  add_level_options(*command, options->levels, options->face_budget);
  command->add_flag("--fit", options->is_fitted, "Cut what is no triangle into triangles first");
  command->callback([options, &work] {
    check_output(options->output, false);
    work = [options] { return upsample_and_write(*options); };
  });
}

}  // namespace limn::cli
