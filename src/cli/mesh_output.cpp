#include "cli/mesh_output.h"

#include <iostream>
#include <map>

#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <CLI/Validators.hpp>

#include "cli/console.h"

namespace limn::cli {
namespace {

MeshFormat format_of(const MeshOutput& output) {
  if (output.format) {
    return *output.format;
  }
  return format_by_ending(output.path).value_or(MeshFormat::kObj);
}

template <class Mesh>
Result<void> write_any(const MeshOutput& output, const Mesh& mesh, ExportSettings settings) {
  settings.is_text = output.is_text;
  const MeshFormat format = format_of(output);
  if (const std::string lost = loss_sentence(format, lost_in(format, mesh, settings));
      !lost.empty()) {
    print_note(fmt::format("{}: {}", output.path == "-" ? "standard output" : output.path, lost));
  }
  if (output.path != "-") {
    return export_mesh(output.path, mesh, settings, format);
  }
  limn::write_mesh(std::cout, format, mesh, settings);
  if (!std::cout.flush()) {
    return fail(ErrorKind::kFailed, "could not write to standard output");
  }
  return {};
}

}  // namespace

void add_format_options(CLI::App& command, MeshOutput& output) {
  const std::map<std::string, MeshFormat> words{{"obj", MeshFormat::kObj},
                                                {"ply", MeshFormat::kPly},
                                                {"off", MeshFormat::kOff},
                                                {"stl", MeshFormat::kStl}};
  command.add_option("--format", output.format, "Write obj, ply, off or stl, whatever the ending")
      ->transform(CLI::CheckedTransformer(words).description(""))
      ->type_name("WORD")
      ->default_str("by the ending");
  command.add_flag("--ascii", output.is_text, "Write PLY as text, not as binary data");
}

void add_output_option(CLI::App& command, MeshOutput& output, bool is_required) {
  const std::string what = "The mesh (.obj, .ply, .off or .stl, or - for standard output)";
  command
      .add_option("-o,--output", output.path,
                  is_required ? what : what + "; left out, only the numbers are reported")
      ->type_name("OUT")
      ->required(is_required);
  add_format_options(command, output);
}

void check_output(const MeshOutput& output, bool has_json, std::string_view others) {
  if (has_json && output.path == "-") {
    throw CLI::ValidationError("--json", "standard output cannot take both -o - and --json");
  }
  if (!output.path.empty() && output.path != "-" && !output.format &&
      !format_by_ending(output.path)) {
    throw CLI::ValidationError(
        "--output",
        fmt::format("{}: the ending is to be .obj, .ply, .off{} .stl{}, or --format given",
                    output.path, others.empty() ? " or" : ",", others));
  }
}

Result<void> write_mesh(const MeshOutput& output, const ControlMesh& mesh,
                        ExportSettings settings) {
  return write_any(output, mesh, settings);
}

Result<void> write_mesh(const MeshOutput& output, const RefinedMesh& mesh,
                        ExportSettings settings) {
  return write_any(output, mesh, settings);
}

}  // namespace limn::cli
