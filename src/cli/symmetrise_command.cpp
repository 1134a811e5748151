#include <map>
#include <memory>
#include <string>

#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <CLI/Validators.hpp>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/input.h"
#include "cli/mesh_output.h"
#include "limn/editing/symmetrise.h"

namespace limn::cli {
namespace {

struct SymmetriseOptions {
  std::string input;
  MeshOutput output;
  SymmetriseBy by = SymmetriseBy::kSplit;
  double degrees = 1.0;
};

Result<void> symmetrise_and_write(const SymmetriseOptions& options) {
  const Result<Project> project = open_input(options.input);
  if (!project) {
    return tl::unexpected(project.error());
  }
  const Result<Symmetrised> result =
      symmetrise(*project->document.control, options.by, options.degrees);
  if (!result) {
    return tl::unexpected(result.error());
  }
  print_note(fmt::format("{} flat pairs of triangles, {} {}", result->pairs, result->changed,
                         options.by == SymmetriseBy::kSplit ? "split" : "flipped"));
  return write_mesh(options.output, *result->mesh);
}

}  // namespace

void add_symmetrise_command(CLI::App& program, Work& work) {
  CLI::App* command = program.add_subcommand(
      "symmetrise",
      "Split or flip the diagonals of flat quads that were cut into triangles, so that "
      "subdivision keeps the symmetry they had");
  const auto options = std::make_shared<SymmetriseOptions>();
  add_input_option(*command, options->input);
  add_output_option(*command, options->output, true);
  command
      ->add_option("--by", options->by,
                   "split (in the middle: four triangles, all of a cube's symmetries), flip "
                   "(towards one space diagonal: one three-fold axis) or flip-alternately (joining "
                   "every other vertex: the symmetries of a tetrahedron)")
      ->transform(CLI::CheckedTransformer(std::map<std::string, SymmetriseBy>{
                                              {"split", SymmetriseBy::kSplit},
                                              {"flip", SymmetriseBy::kFlipToAxis},
                                              {"flip-alternately", SymmetriseBy::kFlipAlternately}})
                      .description(""))
      ->type_name("WORD")
      ->default_str("split");
  command
      ->add_option("--degrees", options->degrees,
                   "Two triangles are flat where their planes differ by no more")
      ->type_name("ANGLE")
      ->check(CLI::Range(0.0, 90.0))
      ->capture_default_str();
  command->callback([options, &work] {
    check_output(options->output, false);
    work = [options] { return symmetrise_and_write(*options); };
  });
}

}  // namespace limn::cli
