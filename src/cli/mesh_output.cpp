#include "cli/mesh_output.h"

#include <iostream>

#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "limn/mesh/export.h"

namespace limn::cli {
namespace {

template <class Mesh>
Result<void> write_any(const std::string& output, const Mesh& mesh,
                       std::span<const std::uint8_t> depths) {
  if (output != "-") {
    return export_obj(output, mesh, depths);
  }
  write_obj(std::cout, mesh, depths);
  if (!std::cout.flush()) {
    return fail(ErrorKind::kFailed, "could not write to standard output");
  }
  return {};
}

}  // namespace

void add_output_option(CLI::App& command, std::string& output, bool is_required) {
  command
      .add_option("-o,--output", output,
                  is_required
                      ? "The mesh (.obj, or - for standard output)"
                      : "The mesh (.obj, or - for standard output); left out, only the numbers "
                        "are reported")
      ->type_name("OUT")
      ->required(is_required);
}

void check_output(const std::string& output, bool has_json, std::string_view endings) {
  if (has_json && output == "-") {
    throw CLI::ValidationError("--json", "standard output cannot take both -o - and --json");
  }
  if (!output.empty() && output != "-" && !output.ends_with(".obj")) {
    throw CLI::ValidationError("--output",
                               fmt::format("{}: the ending is to be {}", output, endings));
  }
}

Result<void> write_mesh(const std::string& output, const ControlMesh& mesh,
                        std::span<const std::uint8_t> depths) {
  return write_any(output, mesh, depths);
}

Result<void> write_mesh(const std::string& output, const RefinedMesh& mesh,
                        std::span<const std::uint8_t> depths) {
  return write_any(output, mesh, depths);
}

}  // namespace limn::cli
