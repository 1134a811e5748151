#include <cstdio>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <CLI/Validators.hpp>

#include "app/run_window.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/input.h"
#include "cli/level_text.h"
#include "cli/scheme_options.h"
#include "limn/document/commands.h"
#include "limn/document/scheme_refinement.h"

namespace limn::cli {
namespace {

struct ClassroomOptions {
  std::string input = "sphere";
  int levels = 1;
  SchemeOptions scheme;
  std::uint64_t face_budget = 5'000'000;
  std::string status_file;
};

/// Loop where the mesh is one for it, otherwise what takes any.
Scheme default_scheme(const ControlMesh& mesh) {
  return check_fits(mesh, Scheme::kLoop) ? Scheme::kLoop : Scheme::kCatmullClark;
}

/// Tells of each level as it would be told of in class, on standard output.
Result<void> print_levels(const Document& document, int levels, std::uint64_t face_budget) {
  TerminalProgress progress;
  return derive_scheme(*document.control, *shown_scheme(document), {levels, face_budget}, progress)
      .map([](const SchemeRefinement& made) {
        for (const SchemeStep& step : made.steps) {
          if (step.level > 0) {
            fmt::print("{}\n", level_text({step.level, step.counts, step.seconds}));
          }
        }
        std::fflush(stdout);
      });
}

Result<void> open_classroom(ClassroomOptions options) {
  Result<Project> project = open_input(options.input);
  if (!project) {
    return tl::unexpected(std::move(project.error()));
  }
  Document& document = project->document;
  const bool is_saved = document.scheme && !options.scheme.scheme;
  options.scheme.scheme = options.scheme.scheme.value_or(default_scheme(*document.control));
  const SchemeSettings settings =
      is_saved ? *shown_scheme(document) : scheme_settings(options.scheme, document);
  const auto mesh =
      fit_mesh(document.control, settings.scheme, options.scheme.is_fitted, document.name);
  if (!mesh) {
    return tl::unexpected(mesh.error());
  }
  if (*mesh != document.control) {
    fit_command(document, fitting_for(scheme_info(settings.scheme).takes))->apply(document);
  }
  document.scheme = settings;
  document.stage.levels = options.levels;
  return print_levels(document, options.levels, options.face_budget).and_then([&] {
    app::WindowOptions window;
    window.status_file = options.status_file;
    window.is_classroom = true;
    return app::run_window(*std::move(project), window);
  });
}

}  // namespace

void add_classroom_command(CLI::App& program, Work& work) {
  CLI::App* command = program.add_subcommand(
      "classroom",
      "Open the window on a mesh that a uniform scheme has subdivided, with the keys of a course");
  const auto options = std::make_shared<ClassroomOptions>();
  command
      ->add_option("MESH", options->input,
                   "Mesh (.obj, .ply, .off or .stl), project (.limn) or bundled mesh to subdivide")
      ->capture_default_str();
  command->add_option("LEVELS", options->levels, "How many steps to begin with")
      ->check(CLI::Range(0, kMostSchemeLevels))
      ->capture_default_str();
  add_scheme_options(*command, options->scheme);
  command->get_option("--scheme")
      ->description(
          "How to subdivide: " + scheme_words() +
          ". Left out: that of a project, else loop for triangles and catmull-clark for all else");
  command
      ->add_option("--budget", options->face_budget,
                   "Refuse, before any work, a level with more faces")
      ->type_name("FACES")
      ->capture_default_str();
  command->add_option("--status-file", options->status_file)->group("");
  command->callback([options, &work] {
    if (options->scheme.weights && !options->scheme.scheme) {
      options->scheme.scheme = Scheme::kLoop;  // Nothing else has weights.
    } else if (options->scheme.averages && !options->scheme.scheme) {
      options->scheme.scheme = Scheme::kLinear;
    }
    check_scheme_options(options->scheme);
    work = [options] { return open_classroom(*options); };
  });
}

}  // namespace limn::cli
