#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <CLI/Validators.hpp>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/input.h"
#include "cli/level_text.h"
#include "cli/mesh_output.h"
#include "cli/scheme_options.h"
#include "limn/subdivision/schemes/uniform.h"

namespace limn::cli {
namespace {

using Json = nlohmann::ordered_json;

struct SubdivideOptions {
  std::string input;
  MeshOutput output;
  SchemeOptions scheme;
  int levels = 1;
  std::uint64_t face_budget = 50'000'000;
  int threads = 0;
  bool json = false;
};

Json level_json(const SchemeLevel& level) {
  return {{"level", level.level},
          {"vertices", level.counts.vertices},
          {"edges", level.counts.edges},
          {"faces", level.counts.faces},
          {"seconds", level.seconds}};
}

/// Tells of each level on standard error, and to `on_level`.
template <class OnLevel>
Result<RefinedMesh> subdivide_by_levels(const ControlMesh& mesh, const SchemeSettings& settings,
                                        const SubdivideOptions& options, const OnLevel& on_level) {
  TerminalProgress progress;
  SchemeLevels scheme(mesh, settings);
  RefinedMesh refined = scheme.mesh();
  while (scheme.level() < options.levels) {
    const Stopwatch watch;
    if (auto made = scheme.advance(options.face_budget, progress); !made) {
      return tl::unexpected(std::move(made.error()));
    }
    refined = scheme.mesh();
    const SchemeLevel level{scheme.level(), scheme.counts(), watch.seconds()};
    progress.note(level_text(level));
    on_level(level);
  }
  return refined;
}

Result<void> subdivide_and_write(const SubdivideOptions& options) {
  const Result<Project> project = open_input(options.input);
  if (!project) {
    return tl::unexpected(project.error());
  }
  const Document& document = project->document;
  const SchemeSettings settings = scheme_settings(options.scheme, document);
  const auto mesh =
      fit_mesh(document.control, settings.scheme, options.scheme.is_fitted, document.name);
  if (!mesh) {
    return tl::unexpected(mesh.error());
  }
  if (auto affordable = check_budget(**mesh, settings, options.levels, options.face_budget);
      !affordable) {
    return affordable;
  }
  Json levels = Json::array();
  const std::shared_ptr<void> limit = limit_threads(options.threads);
  const Result<RefinedMesh> refined =
      subdivide_by_levels(**mesh, settings, options,
                          [&](const SchemeLevel& level) { levels.push_back(level_json(level)); });
  if (!refined) {
    return tl::unexpected(refined.error());
  }
  if (!options.output.path.empty()) {
    if (auto written = write_mesh(options.output, *refined, {.control = mesh->get()}); !written) {
      return written;
    }
  }
  if (options.json) {
    const SchemeInfo& info = scheme_info(settings.scheme);
    Json report = {{"mesh", document.name}, {"scheme", info.name}};
    if (settings.scheme == Scheme::kLoop) {
      report["weights"] = settings.weights == LoopWeights::kWarren ? "warren" : "original";
    }
    report["fitted"] = *mesh != document.control;
    report["levels"] = levels;
    fmt::print("{}\n", report.dump(2));
  }
  return {};
}

}  // namespace

void add_subdivide_command(CLI::App& program, Work& work) {
  CLI::App* command = program.add_subcommand(
      "subdivide",
      "Subdivide all of a mesh by a uniform scheme, with the time and size of each step");
  const auto options = std::make_shared<SubdivideOptions>();
  add_input_option(*command, options->input);
  add_output_option(*command, options->output, false);
  add_scheme_options(*command, options->scheme);
  command->get_option("--scheme")->required();
  add_corners_option(*command, options->scheme.corners);
  add_level_options(*command, options->levels, options->face_budget);
  command
      ->add_option("--threads", options->threads, "Use at most N threads; the result is the same")
      ->type_name("N")
      ->check(CLI::Range(1, 1024))
      ->default_str("all");
  command->add_flag("--json", options->json, "The numbers as JSON on standard output");
  command->callback([options, &work] {
    check_scheme_options(options->scheme);
    check_output(options->output, options->json);
    work = [options] { return subdivide_and_write(*options); };
  });
}

}  // namespace limn::cli
